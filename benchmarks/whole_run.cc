// What a whole run costs against bare MuJoCo: curve_r550 with PHS and recorder at several steps,
// over mj_step of the same model without the plugin at 1 ms for the same simulated time. The two
// take turns, so that a busy machine slows both; the least of each counts.
//   whole_run [ROUNDS [STEP_MS…]]        default 5 rounds of 2, 1.5, 1, 0.5 and 0.25 ms
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <vector>

#include "plugin/registry.h"
#include "vehicle/simulation.h"

namespace {

using phs::vehicle::Scenario;
using phs::vehicle::Simulation;
using Clock = std::chrono::steady_clock;

Scenario Curve(double step) {
  Scenario s;
  s.name = "whole_run";
  s.track = "curve_r550";
  s.bogie = "phs";
  s.speed_m_s = 80 / 3.6;
  s.timestep_s = step;
  return s;
}

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Seconds of bare steps of 1 ms for `simulated` seconds; the vehicle falls, MuJoCo does the same.
double Bare(Simulation* simulation, double simulated) {
  mjModel* m = simulation->mutable_model();
  mjData* d = simulation->data();
  m->opt.timestep = 1e-3;
  mj_resetData(m, d);
  const auto start = Clock::now();
  for (double t = 0; t < simulated; t += 1e-3) {
    if (d->time > 1) mj_resetData(m, d);
    mj_step(m, d);
  }
  return SecondsSince(start);
}

}  // namespace

int main(int count, char** arguments) {
  const int rounds = count > 1 ? std::max(1, std::atoi(arguments[1])) : 5;
  fmt::print("step [ms]  whole run [s]  bare 1 ms [s]  ratio  times real time\n");
  std::vector<double> steps;
  for (int i = 2; i < count; ++i) steps.push_back(1e-3 * std::atof(arguments[i]));
  if (steps.empty()) steps = {2e-3, 1.5e-3, 1e-3, 5e-4, 2.5e-4};
  for (const double step : steps) {
    auto whole = Simulation::Create(Curve(step));
    auto bare = Simulation::Create(Curve(1e-3));
    if (!whole.ok() || !bare.ok()) {
      fmt::print("{:9.2f}  {}\n", 1e3 * step, (whole.ok() ? bare : whole).error().Line());
      continue;
    }
    phs::plugin::Detach(bare.value().mutable_model());
    double least = std::numeric_limits<double>::infinity();
    double least_bare = least;
    double simulated = 0;
    for (int round = 0; round < rounds; ++round) {
      const auto start = Clock::now();
      const auto run = whole.value().Run();
      least = std::min(least, SecondsSince(start));
      simulated = run.value().end_time_s;
      least_bare = std::min(least_bare, Bare(&bare.value(), simulated));
    }
    fmt::print("{:9.2f}  {:13.3f}  {:13.3f}  {:5.2f}  {:15.0f}\n", 1e3 * step, least, least_bare,
               least / least_bare, simulated / least);
  }
}
