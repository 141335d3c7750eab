// The force of a cylinder belongs to the speed that is booked beside it (plugin/half_step.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugin/settle.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

/// Largest difference of a booked force from the law's own at the booked speed, as a share of the most
/// that speed changes that force by.
double WorstDifference(const std::string& vehicle) {
  Scenario scenario = LoadScenario("curve_r300").value();
  scenario.bogie = "phs";
  scenario.vehicle = vehicle;
  scenario.start_s_m = 20;
  // As shipped, friction hardly asks for the speed (2 kN s/m beside a bristle).
  scenario.phs_changes.parameters["friction.damping_Ns_per_m"] = 2e6;
  auto simulation = Simulation::Create(scenario);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  mjModel* m = simulation.value().mutable_model();
  const DataPtr d(mj_makeData(m));
  plugin::ResetToStart(m, d.get());
  double worst = 0, moving = 0;
  for (int step = 0; step < 4000; ++step) {
    mj_step(m, d.get());
    if (step < 100) continue;  // it starts at rest
    for (const plugin::PhsBinding& p : simulation.value().binding().phs()) {
      const size_t n = p.cylinder.size();
      std::vector<double> x(n), still(n, 0.0), force(n), at_rest(n);
      for (size_t i = 0; i < n; ++i) x[i] = d->actuator_length[p.cylinder[i]] - p.length0[i];
      const mjtNum* states = d->userdata + p.states_at;
      hydraulics::PhsOutputs out;
      out.force = force.data();
      p.system->Calc(d->time, x.data(), d->userdata + p.speeds_at, states, &out);
      out.force = at_rest.data();
      p.system->Calc(d->time, x.data(), still.data(), states, &out);
      for (size_t i = 0; i < n; ++i) {
        const double own = std::abs(force[i] - at_rest[i]);
        moving = std::max(moving, own);
        worst = std::max(worst, std::abs(d->userdata[p.forces_at + i] + force[i]));
      }
    }
  }
  EXPECT_GT(moving, 200) << "the speeds matter for the forces of the " << vehicle << " [N]";
  return worst / moving;
}

TEST(CylinderSpeedTest, ABogiesForcesAreThoseOfTheLawAtTheirSpeed) {
  EXPECT_LT(WorstDifference("bogie"), 0.02);
}

TEST(CylinderSpeedTest, SoAreThoseOfBothBogiesOfALocomotive) {
  EXPECT_LT(WorstDifference("locomotive"), 0.02);
}

}  // namespace
}  // namespace phs::vehicle
