// The spring with clearance: free fall through it, then the motion of a mass on a spring.
#include <gtest/gtest.h>

#include <cmath>

#include "plugin/elements.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// A mass of 100 kg on a vertical slide, 2 m under a fixed point, held by one element.
ModelPtr HangingOnSpring(const std::string& kind, const std::string& data) {
  const std::string name = kind + ":e";
  return LoadText(
      "<mujoco><size nuserdata='96'/><option timestep='0.0005' gravity='0 0 -10'/><worldbody>"
      "<site name='fixed' pos='0 0 2'/><body><joint type='slide' axis='0 0 1'/>"
      "<inertial pos='0 0 0' mass='100' diaginertia='1 1 1'/><site name='end'/></body></worldbody>"
      "<custom><tuple name='" +
      name +
      "'><element objtype='site' objname='fixed'/>"
      "<element objtype='site' objname='end'/></tuple><text name='" +
      name + "' data='" + data + "'/></custom></mujoco>");
}

ElementState SpringStateOf(const mjModel* m, const mjData* d) {
  const Binding& binding = *Find(m);
  return binding.elements().back()->StateOf(m, d, binding.Speed(d), 0);
}

TEST(ClearanceSpring, FallsFreelyThroughTheClearanceAndComesBack) {
  const EngineGuard guard;
  const ModelPtr m =
      HangingOnSpring("clearance", "stiffness_N_per_m=1e5 length_m=2 clearance_m=0.05");
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  while (d->time < 0.099) {
    mj_step(m.get(), d.get());
    EXPECT_EQ(SpringStateOf(m.get(), d.get()).force, 0);
  }
  // Lowest point: k x²/2 = m g (c + x).
  double lowest = 0, highest_after = -1, stored = 0;
  while (d->time < 0.5) {
    mj_step(m.get(), d.get());
    if (d->qpos[0] < lowest) {
      lowest = d->qpos[0];
      stored = Find(m.get())->elements().back()->StoredEnergy(m.get(), d.get());
      highest_after = -1;
    }
    highest_after = std::max(highest_after, d->qpos[0]);
  }
  const double weight = 1000, k = 1e5;
  const double x = (weight + std::sqrt(weight * weight + 2 * k * weight * 0.05)) / k;
  EXPECT_NEAR(lowest, -0.05 - x, 1e-4);
  EXPECT_NEAR(stored, weight * (0.05 + x), 0.01 * weight * 0.05);
  EXPECT_NEAR(highest_after, 0, 1e-3) << "nothing is lost";
}

TEST(ClearanceSpring, PushesToBothSidesAndKnowsItsStiffness) {
  const EngineGuard guard;
  const ModelPtr m =
      HangingOnSpring("clearance", "stiffness_N_per_m=1e5 length_m=2 clearance_m=0.05");
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  for (const auto& [z, force] : {std::pair{0.07, 2e3}, {0.03, 0.0}, {-0.06, -1e3}}) {
    d->qpos[0] = z;
    mj_forward(m.get(), d.get());
    EXPECT_NEAR(SpringStateOf(m.get(), d.get()).force, force, 1e-6);
    const double along = 1;
    double stiffness = 0;
    Find(m.get())->elements().back()->AddStiffness(m.get(), d.get(), &along, &stiffness);
    EXPECT_NEAR(stiffness, force == 0 ? 0 : 1e5, 1e-6);
  }
}

}  // namespace
}  // namespace phs::plugin
