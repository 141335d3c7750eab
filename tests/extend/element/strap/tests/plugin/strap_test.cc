// The strap: loose until it is taut, carries a weight at rest, loses energy only.
#include <gtest/gtest.h>

#include <cmath>

#include "plugin/elements.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// A mass of 100 kg on a vertical slide, 2 m under a fixed point, held by one element.
ModelPtr HangingOnStrap(const std::string& kind, const std::string& data) {
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

ElementState StrapStateOf(const mjModel* m, const mjData* d) {
  const Binding& binding = *Find(m);
  return binding.elements().back()->StateOf(m, d, binding.Speed(d), 0);
}

TEST(Strap, IsLooseThenCarriesTheWeight) {
  const EngineGuard guard;
  const ModelPtr m =
      HangingOnStrap("strap", "stiffness_N_per_m=1e5 length_m=2.02 damping_Ns_per_m=2e3");
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  while (d->time < 0.06) mj_step(m.get(), d.get());
  EXPECT_EQ(StrapStateOf(m.get(), d.get()).force, 0) << "0.018 m fallen";
  while (d->time < 5) {
    mj_step(m.get(), d.get());
    EXPECT_LE(StrapStateOf(m.get(), d.get()).force, 0) << "never pushes";
  }
  EXPECT_NEAR(d->qpos[0], -0.02 - 1000 / 1e5, 1e-6);
  EXPECT_NEAR(StrapStateOf(m.get(), d.get()).force, -1000, 0.1);
}

TEST(Strap, LosesEnergyWhileTautOnly) {
  const EngineGuard guard;
  const ModelPtr m =
      HangingOnStrap("strap", "stiffness_N_per_m=1e5 length_m=2 damping_Ns_per_m=2e3");
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  const Elements& strap = *Find(m.get())->elements().back();
  for (double z : {0.01, -0.01}) {
    for (double v : {-0.3, 0.2, 0.8}) {
      d->qpos[0] = z;
      mj_forward(m.get(), d.get());
      const double lost = strap.LostPower(m.get(), d.get(), &v);
      EXPECT_NEAR(lost, z > 0 ? 0 : v > 0.5 ? 1e5 * 0.01 * v : 2e3 * v * v, 1e-6) << z << " " << v;
    }
  }
}

}  // namespace
}  // namespace phs::plugin
