// Power of an element between bodies: what the damper loses, with its sign.
#include <gtest/gtest.h>

#include <cmath>

#include "plugin/observer.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// A mass of 100 kg on a vertical slide, 2 m under a fixed point, held by one element.
ModelPtr HangingForPower(const std::string& kind, const std::string& data) {
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

TEST(ElementPower, IsWhatTheDamperLosesOfAFallingMass) {
  const EngineGuard guard;
  const ModelPtr m = HangingForPower("damper", "damping_Ns_per_m=2000");
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  while (d->time < 1) mj_step(m.get(), d.get());
  const Observer observer(m.get(), *Find(m.get()));
  std::vector<double> row(observer.channels().size());
  observer.Observe(m.get(), d.get(), row.data());
  double power = 0;
  for (size_t i = 0; i < row.size(); ++i) {
    if (observer.channels()[i].name == "damper_e_power_W") power = row[i];
  }
  // m g at the speed m g/c.
  EXPECT_NEAR(power, 1000.0 * 1000 / 2000, 0.5);
}

}  // namespace
}  // namespace phs::plugin
