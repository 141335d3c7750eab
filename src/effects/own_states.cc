#include "effects/own_states.h"

#include <algorithm>
#include <cmath>

namespace phs::effects {
namespace {

constexpr int kMost = OwnStates::kMost;

/// a x = b in place of b, with partial pivoting; leaves b where a is singular.
void Solve(int n, double (*a)[kMost], double* b) {
  int row[kMost];
  for (int i = 0; i < n; ++i) row[i] = i;
  for (int k = 0; k < n; ++k) {
    int best = k;
    for (int i = k + 1; i < n; ++i) {
      if (std::abs(a[row[i]][k]) > std::abs(a[row[best]][k])) best = i;
    }
    std::swap(row[k], row[best]);
    const double pivot = a[row[k]][k];
    if (!(std::abs(pivot) > 0)) return;
    for (int i = k + 1; i < n; ++i) {
      const double factor = a[row[i]][k] / pivot;
      for (int j = k; j < n; ++j) a[row[i]][j] -= factor * a[row[k]][j];
      b[row[i]] -= factor * b[row[k]];
    }
  }
  double x[kMost];
  for (int k = n - 1; k >= 0; --k) {
    double sum = b[row[k]];
    for (int j = k + 1; j < n; ++j) sum -= a[row[k]][j] * x[j];
    x[k] = sum / a[row[k]][k];
  }
  std::copy(x, x + n, b);
}

}  // namespace

void OwnStates::CalcRates(const hydraulics::ForcePlace& place, double* rate) const noexcept {
  for (size_t k = 0; k < rates_.size(); ++k) rate[k] = rates_[k].Value(place);
}

void OwnStates::Advance(double h, hydraulics::ForcePlace place, double* state) const noexcept {
  const int n = size();
  if (n == 0 || !(h > 0)) return;
  const double gamma = 1 - std::sqrt(0.5);
  double z[kMost], rate[kMost] = {}, slope[kMost][kMost];
  std::copy(state, state + n, z);
  place.state = z;
  const auto linearise = [&](double step) {
    CalcRates(place, rate);
    double steepest = 0;
    for (int j = 0; j < n; ++j) {
      const double at = z[j],
                   nudge = 1e-5 * std::max(std::abs(at), std::abs(step * rate[j])) + 1e-14;
      double moved[kMost];
      z[j] = at + nudge;
      CalcRates(place, moved);
      z[j] = at;
      for (int i = 0; i < n; ++i) {
        slope[i][j] = (moved[i] - rate[i]) / nudge;
        steepest = std::max(steepest, std::abs(slope[i][j]));
      }
    }
    return steepest;
  };
  constexpr double kPart = 0.25, kMostSteps = 16;
  const double steps = std::clamp(std::ceil(h * linearise(h) / kPart), 1.0, kMostSteps);
  const double step = h / steps;
  for (int s = 0; s < static_cast<int>(steps); ++s) {
    if (s > 0) linearise(step);
    double first[kMost], second[kMost], start[kMost], matrix[kMost][kMost];
    const auto solve = [&](double* b) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) matrix[i][j] = (i == j) - gamma * step * slope[i][j];
      }
      Solve(n, matrix, b);
    };
    for (int i = 0; i < n; ++i) first[i] = step * rate[i], start[i] = z[i];
    solve(first);
    for (int i = 0; i < n; ++i) z[i] = start[i] + first[i];
    CalcRates(place, second);
    for (int i = 0; i < n; ++i) second[i] = step * second[i] - 2 * first[i];
    solve(second);
    for (int i = 0; i < n; ++i) z[i] = start[i] + 1.5 * first[i] + 0.5 * second[i];
  }
  if (std::all_of(z, z + n, [](double x) { return std::isfinite(x); })) std::copy(z, z + n, state);
}

}  // namespace phs::effects
