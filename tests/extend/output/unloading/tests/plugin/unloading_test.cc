// Wheel unloading against the wheel loads.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "plugin/channels.h"
#include "plugin/observer.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// Channels of the PHS bogie in a curve, half a second after the start.
std::map<std::string, double> UnloadingInACurve() {
  const EngineGuard guard;
  const ModelPtr m = LoadFile(BogiePath("phs"));
  AttachOptions options;
  options.track = "curve_r250";
  options.speed_m_s = 15;
  options.start_s_m = 80;
  EXPECT_TRUE(Attach(m.get(), options).ok());
  const DataPtr d(mj_makeData(m.get()));
  ResetToStart(m.get(), d.get());
  while (d->time < 0.5) mj_step(m.get(), d.get());
  const InstantForces instant(m.get());
  mj_forward(m.get(), d.get());
  const Observer observer(m.get(), *Find(m.get()));
  std::vector<double> row(observer.channels().size());
  observer.Observe(m.get(), d.get(), row.data());
  std::map<std::string, double> value;
  for (size_t i = 0; i < row.size(); ++i) value[observer.channels()[i].name] = row[i];
  return value;
}

TEST(Unloading, IsTheShareThatTheWheelIsLighterThanTheMeanOfItsAxle) {
  const auto at = UnloadingInACurve();
  for (const std::string axle : {"lead", "trail"}) {
    const double left = at.at(axle + "_left_Q_N"), right = at.at(axle + "_right_Q_N");
    EXPECT_GT(std::abs(at.at(axle + "_left_unloading")), 1e-4);
    EXPECT_NEAR(at.at(axle + "_left_unloading"), (right - left) / (left + right), 1e-12);
    EXPECT_NEAR(at.at(axle + "_right_unloading"), -at.at(axle + "_left_unloading"), 1e-12);
  }
}

}  // namespace
}  // namespace phs::plugin
