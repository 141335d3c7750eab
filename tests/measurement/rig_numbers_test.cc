// Numbers of a driven rig: what they are on motions whose answer is known, and against another manifest.
#include "measurement/rig_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/base/scratch_dir.h"

namespace phs::measurement {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class RigNumbersTest : public testing::Test {
 protected:
  static std::string Sine(const std::string& more, const std::string& sample_s = "0.005") {
    return "rig: quarter\nmodel: quarter_setup2\nsignal:\n  duration_s: 20\n  sample_s: " +
           sample_s + "\n  actuator_m: {kind: sine, amplitude_m: 1.5e-3, frequency_Hz: 0.1}\n" +
           more;
  }
  Result<Json> Numbers(const std::string& text) const {
    const auto manifest = LoadManifest(dir_.Write("rig.yaml", text), WindowNeed::kNone);
    if (!manifest.ok()) return manifest.error();
    const auto driven = DriveRig(manifest.value());
    if (!driven.ok()) return driven.error();
    return RigNumbers(manifest.value(), driven.value());
  }
  ScratchDir dir_;
};

TEST_F(RigNumbersTest, LargestAndRmsOfASine) {
  const auto made = Numbers(Sine(""));
  ASSERT_TRUE(made.ok()) << made.error().Line();
  const Json& n = made.value();
  EXPECT_NEAR(n["largest"]["piston_m"].get<double>(), 1.5e-3, 1e-12);
  // Two whole periods in 4000 steps, and the zero at their end.
  EXPECT_NEAR(n["rms"]["piston_m"].get<double>(), 1.5e-3 * std::sqrt(0.5 * 4000 / 4001), 1e-12);
  const Json& load = n["extremes"]["load_cell_N"];
  EXPECT_EQ(n["largest"]["load_cell_N"].get<double>(),
            std::max(load["most"].get<double>(), -load["least"].get<double>()));
}

TEST_F(RigNumbersTest, WithoutFrictionTheHydraulicForceIsTheLoad) {
  const auto made = Numbers(Sine("phs_parameters: {friction.scale: 0}\n"));
  ASSERT_TRUE(made.ok()) << made.error().Line();
  const Json& n = made.value();
  const double load = n["largest"]["load_cell_N"].get<double>();
  EXPECT_GT(load, 1e4);
  EXPECT_NEAR(n["largest"]["hydraulic_N"].get<double>(), load, 1e-9 * load);
  EXPECT_LT(n["hydraulic_force"]["against_load_cell"]["rmse"].get<double>(), 1e-9 * load);
}

TEST_F(RigNumbersTest, AgainstAnotherManifestOnlyWhatChangedDiffers) {
  dir_.Write("base.yaml", Sine(""));
  const auto same = Numbers(Sine("compare_with: base.yaml\n"));
  ASSERT_TRUE(same.ok()) << same.error().Line();
  EXPECT_EQ(same.value()["compared_with"]["load_cell_N"]["max"], 0.0);
  const auto made =
      Numbers(Sine("compare_with: base.yaml\nphs_parameters: {friction.scale: 1.5}\n"));
  ASSERT_TRUE(made.ok()) << made.error().Line();
  const Json& off = made.value()["compared_with"];
  EXPECT_EQ(off["hydraulic_N"]["max"], 0.0) << "seals do not act on rigid pressures";
  // Half of the table at the largest speed, 2 pi 0.1 Hz 1.5 mm, extending: linear between its points.
  const double speed = 2 * std::numbers::pi * 0.1 * 1.5e-3;
  const double table = 1700 + (1850 - 1700) * (speed - 0.0002) / (0.001 - 0.0002);
  EXPECT_NEAR(off["load_cell_N"]["max"].get<double>(), 0.5 * table, 0.5);
}

TEST_F(RigNumbersTest, AnotherClockOrRigIsRefusedInOneLine) {
  dir_.Write("base.yaml", Sine("", "0.01"));
  const auto clock = Numbers(Sine("compare_with: base.yaml\n"));
  ASSERT_FALSE(clock.ok());
  EXPECT_THAT(clock.error().Line(), HasSubstr("compare_with: has other channels or another clock"));
  const auto steps = Numbers(Sine("compare_with: steps_setup2\n"));
  ASSERT_FALSE(steps.ok());
  EXPECT_THAT(steps.error().Line(), HasSubstr("names a rig without a clock: steps"));
  const auto none = Numbers(Sine("compare_with: quarter_sin\n"));
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().Line(), HasSubstr("did you mean 'quarter_sine'?"));
}

}  // namespace
}  // namespace phs::measurement
