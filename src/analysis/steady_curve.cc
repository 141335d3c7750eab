#include "analysis/steady_curve.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "analysis/steady_problem.h"
#include "plugin/observer.h"

namespace phs::analysis {
namespace {

constexpr double kAcceptable = 1e-2;  ///< acceleration left [m/s^2, rad/s^2]
constexpr double kAcceptableOnTheWay = 0.2;

double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Arc lengths to solve at, on the way to the place in the first arc. Empty without an arc.
std::vector<double> Places(const rail::Track& track, double start,
                           const SteadyCurveOptions& options) {
  std::vector<double> places;
  for (const rail::TrackSection& section : track.sections()) {
    const bool arc = section.kind == "curve";
    const double begin = std::max(section.begin_s, start);
    const double end =
        arc ? section.begin_s + options.place_in_arc * (section.end_s - section.begin_s)
            : section.end_s;
    if (end <= begin) continue;
    const int count = arc                            ? options.arc_places
                      : section.kind == "transition" ? options.transition_places
                                                     : 1;
    for (int i = 1; i <= count; ++i) places.push_back(begin + (end - begin) * i / count);
    if (arc) return places;
  }
  return {};
}

/// The observed channels at the one place as a run of one row, and its means.
vehicle::SteadyMeans Describe(const vehicle::Simulation& simulation, const mjData* d) {
  const plugin::Observer observer(simulation.model(), simulation.binding());
  vehicle::RunOutcome run;
  run.channels = observer.channels();
  std::vector<double> row(run.channels.size());
  observer.Observe(simulation.model(), d, row.data());
  for (const double value : row) run.columns.push_back({value});
  return vehicle::CalcSteadyMeans(simulation, run);
}

/// The free joint of a vehicle with one root that stands on the track by itself, at speed.
Result<int> FreeRoot(const vehicle::Simulation& simulation) {
  const mjModel* m = simulation.model();
  int root = -1;
  int roots = 0;
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] != mjJNT_FREE) continue;
    root = j;
    ++roots;
  }
  const std::string mend = "run it in time: phs simulate";
  if (roots != 1) {
    return Error{simulation.scenario().bogie,
                 roots == 0 ? "has no free joint at its root: it cannot turn with a curve"
                            : "has " + std::to_string(roots) + " free roots",
                 "one <freejoint/>, at the root", mend};
  }
  if (!(simulation.binding().target_speed() > 0)) {
    return Error{simulation.scenario().bogie, "stands still", "a speed above 0", mend};
  }
  return root;
}

}  // namespace

Result<SteadyCurve> SolveSteadyCurve(vehicle::Simulation* simulation,
                                     const SteadyCurveOptions& options) {
  const plugin::Binding& binding = simulation->binding();
  const auto root = FreeRoot(*simulation);
  if (!root.ok()) return root.error();
  const double begin = ThreadSeconds();
  SteadyProblem problem(simulation, root.value());
  SteadyCurve result;
  const std::vector<double> places = Places(binding.track(), problem.s(), options);
  for (const double place : places) {
    const double acceptable = place == places.back() ? kAcceptable : kAcceptableOnTheWay;
    result.residual = problem.AdvanceTo(place, options.tolerance, acceptable);
    ++result.places;
    if (result.residual < acceptable) continue;
    return Error{simulation->scenario().bogie + " on " + binding.track().name(),
                 "has no steady state that Newton's method finds (at s = " + std::to_string(place) +
                     " m accelerations of " + std::to_string(result.residual) + " are left)",
                 "", "run it in time: phs simulate"};
  }
  if (result.places == 0) {
    return Error{"track '" + binding.track().name() + "'", "has no circular arc", "a curve", ""};
  }
  result.processor_s = ThreadSeconds() - begin;
  result.speed_m_s = problem.speed();
  result.coasting_m_s2 = problem.coasting();
  result.evaluations = problem.evaluations();
  result.steady = Describe(*simulation, problem.data());
  return result;
}

CurveTotals CalcCurveTotals(const vehicle::SteadyMeans& steady) {
  CurveTotals totals;
  totals.T_gamma_N = steady.TGamma();
  for (const vehicle::WheelMeans& wheel : steady.wheels) {
    totals.largest_Y_N = std::max(totals.largest_Y_N, std::abs(wheel.Y_N));
    totals.largest_Y_over_Q = std::max(totals.largest_Y_over_Q, std::abs(wheel.Y_over_Q));
  }
  return totals;
}

}  // namespace phs::analysis
