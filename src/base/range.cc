#include "base/range.h"

#include <fmt/format.h>

#include <cmath>

namespace phs {

bool Range::Contains(double value) const {
  if (!std::isfinite(value)) return false;
  return (open_min ? value > min : value >= min) && (open_max ? value < max : value <= max);
}

std::string Range::Text() const {
  const bool has_min = std::isfinite(min);
  const bool has_max = std::isfinite(max);
  if (has_min && has_max) {
    return fmt::format("{} {} x {} {}", min, open_min ? "<" : "<=", open_max ? "<" : "<=", max);
  }
  if (has_min) return fmt::format("x {} {}", open_min ? ">" : ">=", min);
  if (has_max) return fmt::format("x {} {}", open_max ? "<" : "<=", max);
  return "finite numbers";
}

}  // namespace phs
