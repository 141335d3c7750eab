#include "identify/fit/octave_bands.h"

#include <array>
#include <cmath>

namespace phs::identify {
namespace {

constexpr int kLeast = 16;  // samples that are still halved
// Daubechies 1988, table 1, N = 4.
constexpr std::array<double, 8> kLow = {
    0.23037781330885523,  0.7148465705525415,   0.6308807679295904,   -0.02798376941698385,
    -0.18703481171888114, 0.030841381835986965, 0.032883011666982945, -0.010597401784997278};

/// One octave of a ring: slow and fast half of y, each (n + 1)/2 long; an odd one gains a zero.
void Halve(const Eigen::VectorXd& y, Eigen::VectorXd* slow, Eigen::VectorXd* fast) {
  const int n = static_cast<int>(y.size()), half = (n + 1) / 2;
  slow->resize(half), fast->resize(half);
  for (int k = 0; k < half; ++k) {
    double low = 0, high = 0;
    const int first = 2 * k - 3;  // the filter about its middle
    const bool inside = first >= 0 && first + 8 <= n;
    for (int j = 0; j < 8; ++j) {
      const int i = inside ? first + j : (first + j + 2 * half) % (2 * half);
      const double at = i < n ? y[i] : 0;
      low += kLow[static_cast<size_t>(j)] * at;
      high += (j % 2 == 0 ? 1 : -1) * kLow[static_cast<size_t>(7 - j)] * at;
    }
    (*slow)[k] = low, (*fast)[k] = high;
  }
}

/// Takes mean and slope off y; gives them as coefficients of unit vectors.
Eigen::Vector2d TakeTrend(Eigen::VectorXd* y) {
  const auto n = y->size();
  const Eigen::VectorXd even = Eigen::VectorXd::Constant(n, 1 / std::sqrt(static_cast<double>(n)));
  Eigen::VectorXd slope = Eigen::VectorXd::LinSpaced(n, -1, 1);
  if (n > 1) slope.normalize();
  Eigen::Vector2d out(even.dot(*y), n > 1 ? slope.dot(*y) : 0);
  *y -= out[0] * even;
  if (n > 1) *y -= out[1] * slope;
  return out;
}

}  // namespace

OctaveBands::OctaveBands(int samples) : samples_(samples), begin_{0} {
  int n = samples;
  for (; n >= kLeast; n = (n + 1) / 2) begin_.push_back(begin_.back() + (n + 1) / 2);
  begin_.push_back(begin_.back() + n + 2);
}

Eigen::VectorXd OctaveBands::Transform(const Eigen::Ref<const Eigen::VectorXd>& y) const {
  Eigen::VectorXd out(size()), rest = y, slow, fast;
  const Eigen::Vector2d trend = TakeTrend(&rest);
  for (int band = 0; band + 1 < num_bands(); ++band) {
    Halve(rest, &slow, &fast);
    out.segment(begin(band), fast.size()) = fast;
    rest.swap(slow);
  }
  out.segment(size() - 2 - rest.size(), rest.size()) = rest;
  out.tail<2>() = trend;
  return out;
}

}  // namespace phs::identify
