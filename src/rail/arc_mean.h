// Means of a quantity along a surface.
#pragma once

#include <cmath>
#include <vector>

namespace phs::rail {

/// Means over +-`half` of the way `arc` [m, growing] along a surface. `kernel`: weight at a share 0 … 1
/// of `half`; `counts`: what each place counts for beside.
template <typename Kernel>
std::vector<double> MeanOverArc(const std::vector<double>& values, const std::vector<double>& arc,
                                const std::vector<double>& counts, double half,
                                const Kernel& kernel) {
  std::vector<double> means;
  std::size_t first = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    while (arc[i] - arc[first] > half) ++first;
    double sum = 0;
    double weights = 0;
    for (std::size_t j = first; j < values.size() && arc[j] - arc[i] < half; ++j) {
      const double weight = kernel(std::abs(arc[j] - arc[i]) / half) * counts[j];
      sum += weight * values[j];
      weights += weight;
    }
    means.push_back(sum / weights);
  }
  return means;
}

}  // namespace phs::rail
