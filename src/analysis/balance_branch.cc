#include "analysis/balance_branch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace phs::analysis {
namespace {

constexpr double kLeastPart = 1.0 / 500;
constexpr double kFarOff = 3;  ///< in largest steps: another branch
constexpr double kAtTheEnd = 1e-5;

/// Straight on from the last two motions, `share` of the way between them.
PeriodicMotion Ahead(const PeriodicMotion& before, const PeriodicMotion& last, double share) {
  PeriodicMotion next = last;
  next.coefficients += share * (last.coefficients - before.coefficients);
  next.omega += share * (last.omega - before.omega);
  next.parameter += share * (last.parameter - before.parameter);
  return next;
}

}  // namespace

BalanceBranch::BalanceBranch(const VibratingSystem& system, const BranchOptions& options,
                             PeriodicMotion first, PeriodicMotion second)
    : system_(system), options_(options), before_(std::move(first)), last_(std::move(second)) {}

bool BalanceBranch::Next() {
  const double amplitude = SizeOf(last_), parameter = last_.parameter;
  if (amplitude >= options_.largest * (1 - kAtTheEnd)) return false;
  const double most_a = std::min((options_.ratio - 1) * amplitude, options_.step);
  const double most_p = options_.parameter_share * std::abs(parameter);
  const double da = (amplitude - SizeOf(before_)) / most_a;
  const double dp = (parameter - before_.parameter) / most_p;
  for (; part_ > kLeastPart; part_ /= 2) {
    const PeriodicMotion guess = Ahead(before_, last_, part_ / std::hypot(da, dp));
    BalanceLine line{da / most_a, dp / most_p,
                     da / most_a * SizeOf(guess) + dp / most_p * guess.parameter};
    if (SizeOf(guess) >= options_.largest) line = {1, 0, options_.largest};
    auto found = SolveBalance(system_, guess, line, options_.solver);
    if (!found.ok()) continue;
    const double a = (SizeOf(found.value()) - amplitude) / most_a;
    const double p = (found.value().parameter - parameter) / most_p;
    if (!(a * da + p * dp > 0 && std::hypot(a, p) < kFarOff)) continue;
    before_ = std::move(last_);
    last_ = std::move(found.value());
    part_ = std::min(1.0, 2 * part_);
    return true;
  }
  return false;
}

}  // namespace phs::analysis
