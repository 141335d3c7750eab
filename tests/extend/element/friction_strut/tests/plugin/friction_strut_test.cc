// The friction strut: carries less than its level in creep, slides above it.
#include <gtest/gtest.h>

#include <cmath>

#include "plugin/elements.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// A mass of 100 kg on a vertical slide, 2 m under a fixed point, held by one element.
ModelPtr HangingOnStrut(const std::string& kind, const std::string& data) {
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

ElementState StrutStateOf(const mjModel* m, const mjData* d) {
  const Binding& binding = *Find(m);
  return binding.elements().back()->StateOf(m, d, binding.Speed(d), 0);
}

TEST(FrictionStrut, CreepsUnderALoadBelowItsLevelAndSlidesAboveIt) {
  const EngineGuard guard;
  for (const auto& [data, level] : {std::pair{"level_N=2000", 2000.0}, {"level_N=600", 600.0}}) {
    const ModelPtr m = HangingOnStrut("friction", data);
    ASSERT_TRUE(Attach(m.get(), {}).ok());
    const DataPtr d(mj_makeData(m.get()));
    while (d->time < 1) mj_step(m.get(), d.get());
    // F0 tanh(v/v0) = m g, or constant acceleration g - F0/m.
    const double speed = level > 1000 ? 1e-3 * std::atanh(1000 / level) : 10 - level / 100;
    EXPECT_NEAR(-d->qvel[0], speed, 5e-3 * speed) << data;
    EXPECT_NEAR(StrutStateOf(m.get(), d.get()).force, -std::min(level, 1000.0), 1) << data;
  }
}

TEST(FrictionStrut, SlopeIsThatOfItsForce) {
  const EngineGuard guard;
  const ModelPtr m = HangingOnStrut("friction", "level_N=2000 turn_m_s=0.01");
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  mj_forward(m.get(), d.get());
  const Elements& strut = *Find(m.get())->elements().back();
  for (double v : {-0.02, 0.0, 0.003, 0.05}) {
    double force = 0;
    strut.AddDampers(m.get(), d.get(), &v, &force);
    EXPECT_NEAR(force, -2000 * std::tanh(v / 0.01), 1e-6);
    EXPECT_NEAR(strut.LostPower(m.get(), d.get(), &v), -force * v, 1e-9);
  }
}

}  // namespace
}  // namespace phs::plugin
