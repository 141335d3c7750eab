// Friction power of the cylinders: never given back, force times speed.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "plugin/channels.h"
#include "plugin/observer.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// Channels of the PHS bogie in a curve, some time after the start.
std::map<std::string, double> PowerInACurve(double until) {
  const EngineGuard guard;
  const ModelPtr m = LoadFile(BogiePath("phs"));
  AttachOptions options;
  options.track = "curve_r250";
  options.speed_m_s = 15;
  options.start_s_m = 80;
  EXPECT_TRUE(Attach(m.get(), options).ok());
  const DataPtr d(mj_makeData(m.get()));
  ResetToStart(m.get(), d.get());
  while (d->time < until) mj_step(m.get(), d.get());
  const InstantForces instant(m.get());
  mj_forward(m.get(), d.get());
  const Observer observer(m.get(), *Find(m.get()));
  std::vector<double> row(observer.channels().size());
  observer.Observe(m.get(), d.get(), row.data());
  std::map<std::string, double> value;
  for (size_t i = 0; i < row.size(); ++i) value[observer.channels()[i].name] = row[i];
  return value;
}

TEST(FrictionPower, IsFrictionTimesTheSpeedOfThePiston) {
  const auto before = PowerInACurve(0.4995), at = PowerInACurve(0.5095);
  for (const std::string cylinder : {"cylinder_1", "cylinder_2", "cylinder_3", "cylinder_4"}) {
    const double way = at.at(cylinder + "_piston_m") - before.at(cylinder + "_piston_m");
    const double speed = way / (at.at("t_s") - before.at("t_s"));
    const double expected = speed * at.at(cylinder + "_friction_N");
    EXPECT_GT(std::abs(expected), 1e-3) << cylinder;
    EXPECT_NEAR(at.at(cylinder + "_friction_power_W"), expected, 0.2 * std::abs(expected))
        << cylinder;
  }
}

}  // namespace
}  // namespace phs::plugin
