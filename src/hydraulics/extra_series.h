// Further measured channels of a record, for laws that ask for them by name (effects/own_law.h).
#pragma once

#include <string>
#include <vector>

namespace phs::hydraulics {

inline constexpr int kMaxExtra = 8;

/// Samples at t0 + i step, linear between them, held beyond the ends.
struct ExtraSeries {
  std::vector<std::string> names;  ///< with unit, "coil_V"; at most kMaxExtra
  double t0_s = 0, step_s = 1;
  std::vector<std::vector<double>> values;  ///< [channel][sample], SI

  /// `out`: one value per channel.
  void At(double time, double* out) const noexcept {
    for (size_t c = 0; c < values.size(); ++c) {
      const std::vector<double>& y = values[c];
      const double place = (time - t0_s) / step_s, last = static_cast<double>(y.size()) - 1;
      if (!(place > 0)) {
        out[c] = y.front();
      } else if (place >= last) {
        out[c] = y.back();
      } else {
        const auto i = static_cast<size_t>(place);
        out[c] = y[i] + (place - static_cast<double>(i)) * (y[i + 1] - y[i]);
      }
    }
  }
};

}  // namespace phs::hydraulics
