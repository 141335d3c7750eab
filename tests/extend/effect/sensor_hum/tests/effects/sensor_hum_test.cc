// Hum on the channels of a rig: added to those named, absent from the others.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rigs/rig_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

std::vector<std::vector<double>> Shown(const PhsParams& params) {
  rigs::RigMotion motion;
  motion.step_s = 0.01;
  motion.position_m.resize(1);
  for (int i = 0; i < 200; ++i) motion.position_m[0].push_back(1e-3 * std::sin(0.02 * i));
  const auto rig = rigs::RigModel::Create(rigs::RigKind::kQuarter, params);
  EXPECT_TRUE(rig.ok());
  rigs::RigPrediction out;
  EXPECT_TRUE(rig.value().Run(motion, &out).ok());
  return out.channels;
}

TEST(SensorHum, IsAddedToTheLoadCellAlone) {
  const auto plain = Shown(Quarter());
  const auto hum = Shown(With(Quarter(), "sensor_hum", {{"load_N", 40}, {"frequency_Hz", 7}}));
  for (size_t i = 0; i < plain[1].size(); ++i) {
    const double expected = 40 * std::sin(2 * M_PI * 7 * 0.01 * static_cast<double>(i));
    EXPECT_NEAR(hum[1][i] - plain[1][i], expected, 1e-9);
  }
  EXPECT_EQ(hum[2], plain[2]);
  EXPECT_EQ(hum[3], plain[3]);
}

}  // namespace
}  // namespace phs::effects
