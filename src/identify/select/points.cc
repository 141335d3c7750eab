#include "identify/select/points.h"

#include <algorithm>
#include <cmath>

#include "identify/fit/near_fit.h"

namespace phs::identify::search {
namespace {

double Coordinate(const FreeModel& model, const std::vector<double>& values, size_t i) {
  return model.free[i].ToCoordinate(values[i]);
}

/// Far enough apart that a step from one does not reach the other.
bool AreApart(const FreeModel& model, const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kStep = 0.1;  // of a logarithmic number: ten per cent
  for (size_t i = 0; i < a.size(); ++i) {
    if (model.free[i].logarithmic &&
        std::abs(Coordinate(model, a, i) - Coordinate(model, b, i)) > kStep) {
      return true;
    }
  }
  return false;
}

/// The others fitted with number `held` at its declared value.
Point FitHolding(const FitProblem& coarse, const FreeModel& model,
                 const std::vector<double>& values, size_t held) {
  const double declared = model.free[held].start;
  const FreeModel others = WithHeld(model, held, declared);
  std::vector<double> start = values;
  start.erase(start.begin() + static_cast<long>(held));
  const FitResult fit = FitNear(coarse, others, start, {}, {.max_steps = 6, .intervals = false});
  if (!fit.ok) return {};
  std::vector<double> all = fit.values;
  all.insert(all.begin() + static_cast<long>(held), declared);
  return FitNear(coarse, model, all, {}, {.max_steps = 0, .final_slopes = true});
}

}  // namespace

std::vector<Point> PointsAbout(const FitProblem& coarse, const FreeModel& model,
                               const FitResult& fit, size_t declared, bool elsewhere) {
  constexpr double kFar = 0.1;      // [ln] ten per cent: farther than a step reaches
  constexpr double kOutlier = 2.5;  // deviations
  std::vector<Point> points;
  const auto add = [&](Point point) {
    if (!point.ok) return;  // one that was stopped has no values
    const bool known = std::any_of(points.begin(), points.end(), [&](const Point& p) {
      return !AreApart(model, p.values, point.values);
    });
    if (!known) points.push_back(std::move(point));
  };
  add(FitNear(coarse, model, fit.values, {}, {.max_steps = 6, .final_slopes = true}));
  if (points.empty() || !elsewhere) return points;
  std::vector<double> start = fit.values;
  for (size_t i = 0; i < declared; ++i) start[i] = model.free[i].start;
  add(FitNear(coarse, model, start, {},
              {.max_steps = 12, .robust = kOutlier, .final_slopes = true}));
  const std::vector<double> best = points.front().values;
  for (size_t i = 0; i < declared; ++i) {
    const FreeParameter& p = model.free[i];
    if (!p.logarithmic || std::abs(p.ToCoordinate(best[i]) - p.ToCoordinate(p.start)) < kFar) {
      continue;
    }
    add(FitHolding(coarse, model, best, i));
  }
  return points;
}

}  // namespace phs::identify::search
