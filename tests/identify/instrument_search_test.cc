// What instruments do wrong, found in small records made with the rig model itself.
#include <gtest/gtest.h>

#include <string>

#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

TEST(InstrumentSearchTest, FindsAGaugeThatIsKnockedInTheRecord) {
  const Identification found =
      FindAlone({"sensor_offset", {}, {{"p_rod_Pa", 9e4}, {"start_s", 17.3}}},
                {"sensor_drift", "sensor_gain", "sensor_creep"});
  EXPECT_NEAR(ValueOf(found, "effects.sensor_offset.p_rod_Pa"), 9e4, 2e3);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_offset.start_s"), 17.3, 0.3);
}

TEST(InstrumentSearchTest, FindsAGaugeWhoseMembraneRubs) {
  const Identification found =
      FindAlone({"sensor_hysteresis", {}, {{"p_rod", 0.03}, {"width_Pa", 2e6}}},
                {"sensor_creep", "sensor_gain", "sensor_delay"});
  EXPECT_NEAR(ValueOf(found, "effects.sensor_hysteresis.p_rod"), 0.03, 3e-3);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_hysteresis.width_Pa"), 2e6, 3e5);
}

TEST(InstrumentSearchTest, FindsThatBothPressuresReadLow) {
  // Gauge sensors at altitude: both lack as much of the atmosphere, 88 kPa here.
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"sensor_offset", {}, {{"p_bore_Pa", -8.8e4}, {"p_rod_Pa", -8.8e4}}});
  const Identification found = Find(Declared(), Record(truth));
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "sensor_offset");
  EXPECT_NEAR(ValueOf(found, "effects.sensor_offset.p_bore_Pa"), -8.8e4, 3e3);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_offset.p_rod_Pa"), -8.8e4, 3e3);
}

/// A wrong bridge or a wrong constant: no force that the cylinder gives.
TEST(InstrumentSearchTest, ALoadCellThatShowsHalfAsMuchAgainIsItsGain) {
  measurement::FitData record = Record(OffDeclared());
  for (measurement::MeasuredChannel& channel : record.outputs) {
    if (channel.name != "load_cell_N") continue;
    for (double& y : channel.values) y *= 1.5;
    channel.noise *= 1.5;
  }
  const Identification found = Find(Declared(), record);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "sensor_gain");
  EXPECT_NEAR(ValueOf(found, "effects.sensor_gain.load"), 1.5, 0.01);
}

// Its reading in compression was called a force over a pressure, which has that sign, too.
TEST(InstrumentSearchTest, FindsALoadCellThatShowsMoreInTensionAlone) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"sensor_gain", {}, {{"load", 1.07}, {"load_compression", 1 / 1.07}}});
  const Identification found = Find(Declared(), Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "sensor_gain");
  EXPECT_NEAR(ValueOf(found, "effects.sensor_gain.load"), 1.07, 0.005);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_gain.load_compression"), 1 / 1.07, 0.005);
}

// Beside delays, creep and a loop.
TEST(InstrumentSearchTest, FindsAnAmplifierThatCannotFollow) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"sensor_slew", {}, {{"load_N_per_s", 4e4}}});
  const Identification found =
      FindAmong({"sensor_slew", "sensor_delay", "sensor_creep", "sensor_hysteresis", "stribeck"},
                Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "sensor_slew");
  EXPECT_NEAR(ValueOf(found, "effects.sensor_slew.load_N_per_s") / 4e4, 1, 0.03) << Said(found);
}

// A gauge on a tube with a bubble in it rings; beside delays, creep and a loop.
TEST(InstrumentSearchTest, FindsAGaugeThatRings) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"sensor_delay", {}, {{"p_rod_s", 0.03}, {"damping", 0.15}}});
  const Identification found = FindAmong(
      {"sensor_slew", "sensor_delay", "sensor_creep", "sensor_hysteresis", "line_inertance"},
      Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "sensor_delay");
  EXPECT_NEAR(ValueOf(found, "effects.sensor_delay.p_rod_s") / 0.03, 1, 0.03) << Said(found);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_delay.damping") / 0.15, 1, 0.1) << Said(found);
}

// A damp plug: what is quick in the other gauge. Beside a gain, creep, a loop and the seal's ring.
TEST(InstrumentSearchTest, FindsAGaugeThatPicksUpTheOther) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"sensor_crosstalk", {}, {{"p_rod_of_p_bore", 0.04}, {"time_s", 0.6}}});
  const Identification found = FindAmong(
      {"sensor_crosstalk", "sensor_gain", "sensor_creep", "sensor_hysteresis", "seal_shuttle"},
      Record(truth));
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.effects[0].candidate.effect, "sensor_crosstalk");
  EXPECT_NEAR(ValueOf(found, "effects.sensor_crosstalk.p_rod_of_p_bore") / 0.04, 1, 0.1);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_crosstalk.time_s") / 0.6, 1, 0.15) << Said(found);
}

// Beside gains, thrusts and a load cell that cannot follow.
TEST(InstrumentSearchTest, FindsALoadCellWhoseAmplifierSaturates) {
  const Identification found =
      FindAlone({"sensor_saturation", {}, {{"load_N", 7e4}, {"sharpness", 5}}},
                {"sensor_gain", "pressure_area", "sensor_slew", "sensor_hysteresis"});
  EXPECT_NEAR(ValueOf(found, "effects.sensor_saturation.load_N") / 7e4, 1, 0.02) << Said(found);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_saturation.sharpness") / 5, 1, 0.1) << Said(found);
}

// Little by little into its rate: beside a lag and a delay, which its small signals are alike to.
TEST(InstrumentSearchTest, FindsAnAmplifierThatRunsIntoItsRateLittleByLittle) {
  const Identification found =
      FindAlone({"sensor_slew", {}, {{"load_N_per_s", 6e4}, {"time_s", 0.02}}},
                {"sensor_delay", "sensor_creep", "sensor_hysteresis", "stribeck"});
  EXPECT_NEAR(ValueOf(found, "effects.sensor_slew.load_N_per_s") / 6e4, 1, 0.03) << Said(found);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_slew.time_s") / 0.02, 1, 0.1) << Said(found);
}

// 60 ppm, 2.4 ms at the end of the window: beside delays, drifts and creep.
TEST(InstrumentSearchTest, FindsPressuresOfACardWhoseClockIsFast) {
  const Identification found =
      FindAlone({"sensor_clock", {}, {{"p_bore", 6e-5}, {"p_rod", 6e-5}}},
                {"sensor_delay", "sensor_drift", "sensor_creep", "line_resistance"});
  EXPECT_NEAR(ValueOf(found, "effects.sensor_clock.p_bore"), 6e-5, 3e-6) << Said(found);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_clock.p_rod"), 6e-5, 3e-6) << Said(found);
}

// Both gauges and the load cell hang on it: beside gains, a drag and the speed in one reading.
TEST(InstrumentSearchTest, FindsASupplyThatSagsWithTheDrivesPower) {
  const Identification found = FindAlone(
      {"sensor_supply", {}, {{"of_power", 0.08}, {"time_s", 0.1}}},
      {"sensor_gain", "sensor_creep", "viscous_friction", "line_resistance", "sensor_crosstalk"});
  EXPECT_NEAR(ValueOf(found, "effects.sensor_supply.of_power") / 0.08, 1, 0.03) << Said(found);
  EXPECT_NEAR(ValueOf(found, "effects.sensor_supply.time_s") / 0.1, 1, 0.1) << Said(found);
}

// A mode of the frame that the load cell feels in part: beside a mass, a line that rings, delays.
TEST(InstrumentSearchTest, FindsAFrameThatRingsAtTheLoadCell) {
  for (const double share : {0.3, -0.5}) {  // below zero: beyond a node of the mode
    const Identification found =
        FindAlone({"sensor_delay", {}, {{"load_s", 0.02}, {"damping", 0.1}, {"share", share}}},
                  {"moving_mass", "line_inertance", "sensor_creep", "sensor_slew"});
    EXPECT_NEAR(ValueOf(found, "effects.sensor_delay.load_s") / 0.02, 1, 0.03) << Said(found);
    EXPECT_NEAR(ValueOf(found, "effects.sensor_delay.damping") / 0.1, 1, 0.15) << Said(found);
    EXPECT_NEAR(ValueOf(found, "effects.sensor_delay.share") / share, 1, 0.1) << Said(found);
  }
}

// The actuator's logger is the faster one: every channel comes ever earlier.
TEST(InstrumentSearchTest, FindsThatTheActuatorHasAnotherClock) {
  const Identification found = FindAlone({"sensor_clock", {}, {{"all", -8e-5}}},
                                         {"sensor_delay", "backlash", "mount_compliance"});
  EXPECT_NEAR(ValueOf(found, "effects.sensor_clock.all"), -8e-5, 4e-6) << Said(found);
}

}  // namespace
}  // namespace phs::identify::search
