#include "sweep/sensitivity.h"

#include <cmath>

namespace phs::sweep {
namespace {

double Mean(const std::vector<double>& x) {
  double sum = 0;
  for (double v : x) sum += v;
  return sum / static_cast<double>(x.size());
}

double StandardError(const std::vector<double>& x) {
  const double mean = Mean(x);
  double sum = 0;
  for (double v : x) sum += (v - mean) * (v - mean);
  const double n = static_cast<double>(x.size());
  return std::sqrt(sum / (n * (n - 1)));
}

}  // namespace

std::vector<SobolIndex> SobolIndices(const std::vector<double>& values, int dimensions) {
  const std::size_t d = static_cast<std::size_t>(dimensions), block = d + 2;
  std::vector<std::size_t> good;
  std::vector<double> both;
  for (std::size_t at = 0; at + block <= values.size(); at += block) {
    bool finite = true;
    for (std::size_t i = 0; i < block; ++i) finite &= std::isfinite(values[at + i]);
    if (!finite) continue;
    good.push_back(at);
    both.push_back(values[at]);
    both.push_back(values[at + 1]);
  }
  if (good.size() < 4) return {};
  const double mean = Mean(both);
  double variance = 0;
  for (double v : both) variance += (v - mean) * (v - mean);
  variance /= static_cast<double>(both.size() - 1);
  if (variance <= 0) return {};
  std::vector<SobolIndex> indices(d);
  for (std::size_t i = 0; i < d; ++i) {
    std::vector<double> first, total;
    for (std::size_t at : good) {
      first.push_back((values[at + 1] - mean) * (values[at + 2 + i] - values[at]) / variance);
      total.push_back(std::pow(values[at] - values[at + 2 + i], 2) / (2 * variance));
    }
    indices[i] = {Mean(first), Mean(total), StandardError(first), StandardError(total)};
  }
  return indices;
}

}  // namespace phs::sweep
