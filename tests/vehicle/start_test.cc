// Every run begins settled and rolling freely, whatever the speed.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plugin/settle.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

TEST(Start, EveryBogieStandsSettledAtEverySpeed) {
  for (const char* bogie : {"phs", "emd_radial_coco"}) {
    for (const double speed : {5.0, 41.7, 62.5, 110.0}) {
      Scenario s;
      s.bogie = bogie;
      s.track = "straight";
      s.speed_m_s = speed;
      s.timestep_s = 2e-4;
      auto sim = Simulation::Create(s);
      ASSERT_TRUE(sim.ok()) << bogie << " at " << speed << ": " << sim.error().Line();
      const mjModel* m = sim.value().model();
      mjData* d = sim.value().data();
      plugin::ResetToStart(m, d);
      mj_forward(m, d);
      std::vector<double> allowed(static_cast<size_t>(m->nv), 1e-2);
      // Spins roll at their own speed; a drive that begins to hold the vehicle's may nudge them.
      for (const auto& w : sim.value().binding().wheelsets()) {
        allowed[static_cast<size_t>(w.spin_dof)] = 0.1;
      }
      for (int dof = 0; dof < m->nv; ++dof) {
        EXPECT_LT(std::abs(d->qacc[dof]), allowed[static_cast<size_t>(dof)])
            << bogie << " at " << speed << ", dof " << dof;
      }
      EXPECT_NEAR(d->qvel[0], speed, 1e-6 * speed) << bogie;
    }
  }
}

}  // namespace
}  // namespace phs::vehicle
