#include "sweep/outputs.h"

#include <sstream>
#include <vector>

namespace phs::sweep {
namespace {

std::vector<std::string> Parts(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

bool NamesList(const std::string& part) {
  return part == "wheelsets" || part == "wheels" || part == "cylinders" || part == "lines" ||
         part == "cases";
}

}  // namespace

std::string OutputColumn(const std::string& path) {
  std::string column;
  const auto parts = Parts(path);
  for (std::size_t i = parts.size() > 1 ? 1 : 0; i < parts.size(); ++i) {
    if (NamesList(parts[i])) continue;
    column += (column.empty() ? "" : "_") + parts[i];
  }
  return column;
}

}  // namespace phs::sweep
