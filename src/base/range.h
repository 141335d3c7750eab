// Which values a number may take, and how that is said.
#pragma once

#include <limits>
#include <string>

namespace phs {

/// Closed range of allowed numbers. An open end excludes the bound itself.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false;              ///< true: the value must be > min
  bool open_max = false;              ///< true: the value must be < max
  bool Contains(double value) const;  ///< false for NaN
  std::string Text() const;           ///< "0 < x <= 5", "x >= 0", "finite numbers"
};

}  // namespace phs
