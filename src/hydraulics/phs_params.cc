#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

int PhsParams::FindLine(const std::string& line) const {
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].name == line) return static_cast<int>(i);
  }
  return -1;
}

int PhsParams::FindCylinder(const std::string& cylinder) const {
  for (size_t i = 0; i < cylinders.size(); ++i) {
    if (cylinders[i].name == cylinder) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace phs::hydraulics
