#include <algorithm>
#include <cmath>
#include <numeric>

#include "identify/discrepancy/formula_search.h"

namespace phs::identify {
namespace {

constexpr int kBins = 16;

/// P(F > f) with d1, d2 degrees of freedom by the cube-root approximation (Paulson 1942, Annals of
/// Mathematical Statistics 13, 233).
double ProbabilityAbove(double f, double d1, double d2) {
  if (!(f > 0) || !(d2 > 3)) return 1;
  const double a = 2 / (9 * d1), b = 2 / (9 * d2), root = std::cbrt(f);
  const double u = ((1 - b) * root - (1 - a)) / std::sqrt(b * root * root + a);
  return 0.5 * std::erfc(u / std::sqrt(2.0));
}

}  // namespace

std::vector<VariableShare> ShareByVariable(
    const std::vector<double>& residual, double independent,
    const std::vector<std::pair<std::string, std::vector<double>>>& variables) {
  std::vector<VariableShare> out;
  const size_t n = residual.size();
  if (n < 4 * kBins) return out;
  const double mean = std::accumulate(residual.begin(), residual.end(), 0.0) / double(n);
  double total = 0;
  for (const double r : residual) total += (r - mean) * (r - mean);
  for (const auto& [name, values] : variables) {
    if (values.size() != n) continue;
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    if (!(sorted.front() < sorted.back()) || !(total > 0)) continue;
    double sum[kBins] = {}, count[kBins] = {};
    for (size_t i = 0; i < n; ++i) {
      const auto rank = std::lower_bound(sorted.begin(), sorted.end(), values[i]) - sorted.begin();
      const int bin =
          std::min<int>(kBins - 1, static_cast<int>(rank * kBins / static_cast<long>(n)));
      sum[bin] += residual[i] - mean, ++count[bin];
    }
    double between = 0;
    int filled = 0;
    for (int b = 0; b < kBins; ++b) {
      if (count[b] > 0) between += sum[b] * sum[b] / count[b], ++filled;
    }
    const double eta = between / total, d1 = filled - 1, d2 = independent - filled;
    VariableShare share{name, std::max(0.0, eta - d1 / std::max(d1 + 1, independent)), 1};
    if (d1 > 0 && d2 > 0) {
      share.p_value = ProbabilityAbove(eta / d1 / std::max((1 - eta) / d2, 1e-300), d1, d2);
    }
    out.push_back(share);
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  return out;
}

}  // namespace phs::identify
