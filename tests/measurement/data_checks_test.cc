// Faults of single channels: each is found, named and left out or mended; sound data stay as is.
#include "measurement/data_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "measurement/channel_noise.h"
#include "measurement/standstill.h"
#include "measurement/time_wave.h"
#include "measurement/units.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

using measurement::Channel;
using measurement::DataFinding;
using measurement::EstimateNoise;
using measurement::FindContradictions;
using measurement::FindStandstill;
using measurement::FindTimeWave;
using measurement::FitData;
using measurement::LeaveOutBelowVacuum;
using measurement::MarkSpikes;
using measurement::MarkStuck;
using measurement::MeasuredChannel;
using measurement::MendInputScale;
using measurement::RigRun;
namespace {

constexpr double kStep = 0.005;

/// 40 s of a sine with white noise of 1/1000, in steps of a quarter of the noise.
Channel Sine() {
  Channel channel{"p_bore_Pa", "p_bore_Pa", 1, {}, {}, {}};
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 8000; ++i) {
    const double y = 2e6 + 1e6 * std::sin(i * kStep) + 1e3 * normal(random);
    channel.y.push_back(250 * std::round(y / 250));
  }
  channel.bad.assign(channel.y.size(), 0);
  channel.noise = EstimateNoise(channel, std::vector<char>(channel.y.size(), 0), kStep);
  return channel;
}

RigRun Clock() {
  RigRun run;
  run.step_s = kStep;
  return run;
}

/// A channel that runs against the model, two that were swapped, one in bar: each is said once.
TEST(DataChecksTest, WhatContradictsAFittedModelIsNamed) {
  FitData data;
  std::vector<std::vector<double>> predicted(4);
  for (int i = 0; i < 400; ++i) {
    const double t = 0.05 * i;
    const double y[4] = {std::sin(t), std::sin(2.1 * t), std::cos(0.7 * t), 1e6 * std::sin(t)};
    for (size_t c = 0; c < 4; ++c) predicted[c].push_back(y[c]);
  }
  const char* names[4] = {"load1_N", "lead_left_Q_N", "lead_right_Q_N", "pL1_Pa"};
  for (size_t c = 0; c < 4; ++c) {
    data.outputs.emplace_back(), data.outputs[c].name = names[c];
    data.outputs[c].values = predicted[c];
  }
  EXPECT_THAT(FindContradictions(predicted, data), testing::IsEmpty());
  for (double& y : data.outputs[0].values) y = -y;
  std::swap(data.outputs[1].values, data.outputs[2].values);
  for (double& y : data.outputs[3].values) y *= 1e-5;
  const auto said = FindContradictions(predicted, data);
  ASSERT_EQ(said.size(), 3u);
  EXPECT_THAT(said[0], testing::HasSubstr("lead_left_Q_N and lead_right_Q_N follow each other"));
  EXPECT_THAT(said[1], testing::HasSubstr("load1_N runs against the fitted model"));
  EXPECT_THAT(said[2], testing::HasSubstr("pL1_Pa swings 1e-05 times"));
}

TEST(DataChecksTest, SoundChannelStaysAsItIs) {
  Channel channel = Sine();
  const std::vector<double> before = channel.y;
  std::vector<DataFinding> findings;
  MarkStuck(&channel, Clock(), &findings);
  MarkSpikes(&channel, &findings);
  EXPECT_TRUE(findings.empty());
  EXPECT_EQ(channel.y, before);
}

/// 10 s of a pressure that reads -0.8 MPa for 50 ms in the middle, and a load cell beside it; with
/// `offset` [Pa] on the whole pressure.
FitData BelowVacuum(double offset) {
  FitData data;
  data.step_s = kStep;
  data.outputs = {{"load_cell_N", {}, 10}, {"p_bore_Pa", {}, 5e3}};
  for (int i = 0; i < 2000; ++i) {
    data.time_s.push_back(i * kStep);
    data.outputs[0].values.push_back(100);
    data.outputs[1].values.push_back(offset + (i >= 1000 && i < 1010 ? -8e5 : 1e5));
  }
  return data;
}

TEST(DataChecksTest, NothingIsAskedOfAModelWhereAPressureReadsBelowVacuum) {
  FitData data = BelowVacuum(0);
  LeaveOutBelowVacuum(&data);
  ASSERT_EQ(data.findings.size(), 1u);
  EXPECT_EQ(data.findings[0].channel, "p_bore_Pa");
  EXPECT_THAT(data.findings[0].text, testing::HasSubstr("from 4.99 to 5.095 s"));
  for (const MeasuredChannel& channel : data.outputs) {
    const auto lost = std::count_if(channel.values.begin(), channel.values.end(),
                                    [](double y) { return std::isnan(y); });
    EXPECT_EQ(lost, 2 + 10 + 10) << channel.name;
    EXPECT_FALSE(std::isnan(channel.values[997]));
    EXPECT_TRUE(std::isnan(channel.values[998]) && std::isnan(channel.values[1019]));
  }
}

TEST(DataChecksTest, AnOffsetPressureIsNotBelowVacuum) {
  FitData data = BelowVacuum(-3e5);
  LeaveOutBelowVacuum(&data);
  EXPECT_TRUE(data.findings.empty());
  for (const double y : data.outputs[0].values) ASSERT_EQ(y, 100);
}

/// 60 s of a load cell with noise of 30 N: the actuator stands still, creeps (the load drifts by
/// turns) and stands again; and the actuator's own record with noise of 1 um.
struct Still {
  std::vector<double> actuator;
  Channel load{"load_cell_N", "load_cell_N", 1, {}, {}, {}};
};
Still CreepBetweenRests(double wave_N) {
  Still out;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 12000; ++i) {
    const double t = i * kStep;
    const bool creeps = t > 10 && t < 50;
    out.actuator.push_back((creeps ? 2e-4 * std::sin(0.5 * (t - 10)) : 0) + 1e-6 * normal(random));
    out.load.y.push_back((creeps ? 800 * std::sin(3 * t) : 0) + wave_N * std::sin(48 * t) +
                         30 * normal(random));
  }
  out.load.bad.assign(out.load.y.size(), 0);
  return out;
}

// A first sample 10 mm off spoiled a clean record: the motion was smoothed through it.
TEST(Spikes, AreFoundInTheFirstAndInTheLastSample) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Channel good{"x_m", "x_m", 1, {}, {}, {}};
  for (int i = 0; i < 4000; ++i) {
    good.y.push_back(0.03 * std::sin(0.009 * i + 1) + 2e-7 * normal(random));
  }
  good.bad.assign(good.y.size(), 0);
  std::vector<DataFinding> none;
  for (const auto& mark : {measurement::MarkSpikes, measurement::MarkMotionSpikes}) {
    Channel clean = good;
    mark(&clean, &none);
    EXPECT_TRUE(none.empty());
    for (const size_t at : {size_t{0}, size_t{2}, good.y.size() - 2, good.y.size() - 1}) {
      Channel spoiled = good;
      spoiled.y[at] += 1e-3;
      std::vector<DataFinding> findings;
      mark(&spoiled, &findings);
      EXPECT_EQ(findings.size(), 1u) << at;
      EXPECT_TRUE(spoiled.bad[at]) << at;
      EXPECT_NEAR(spoiled.y[at], good.y[at], 2e-5) << at;
    }
  }
}

TEST(ChannelNoiseTest, CreepIsNoStandstill) {
  const Still still = CreepBetweenRests(0);
  const std::vector<char> rest = FindStandstill(still.actuator, {}, kStep, 1e-6);
  EXPECT_GT(std::count(rest.begin(), rest.begin() + 2000, 1), 1500);
  EXPECT_LT(std::count(rest.begin() + 2200, rest.begin() + 9800, 1), 300) << "turning points only";
  EXPECT_NEAR(EstimateNoise(still.load, rest, kStep).level, 30, 3);
}

TEST(ChannelNoiseTest, AVibrationIsNoNoise) {
  const Still still = CreepBetweenRests(300);
  const std::vector<char> rest = FindStandstill(still.actuator, {}, kStep, 1e-6);
  EXPECT_NEAR(EstimateNoise(still.load, rest, kStep).level, 30, 4);
}

TEST(ChannelNoiseTest, BlowsFromBesideTheRigAreNoNoise) {
  Still still = CreepBetweenRests(0);
  const std::vector<char> rest = FindStandstill(still.actuator, {}, kStep, 1e-6);
  for (size_t i = 0; i < still.load.y.size(); ++i) {
    const double since = std::fmod(static_cast<double>(i) * kStep, 1.3);
    still.load.y[i] += 1500 * std::exp(-since / 0.1) * std::cos(2 * M_PI * 13 * since);
  }
  const double level = EstimateNoise(still.load, rest, kStep).level;  // rms with the blows 210
  EXPECT_GT(level, 30);
  EXPECT_LT(level, 60);
}

// Noise that remembers a tenth of a second, without and with: what bursts take away is next to
// nothing.
TEST(ChannelNoiseTest, NoiseOfAColourStaysAsLoudAsItIs) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  Channel load{"load_cell_N", "load_cell_N", 1, {}, {}, {}};
  const double kept = std::exp(-kStep / 0.1);
  for (double y = 0; load.y.size() < 24000;) {
    y = kept * y + std::sqrt(1 - kept * kept) * 40 * normal(random);
    load.y.push_back(y + 10 * normal(random));
  }
  load.bad.assign(load.y.size(), 0);
  // A straight line over each second takes some of the colour with it.
  const std::vector<char> rest(load.y.size(), 1);
  EXPECT_NEAR(EstimateNoise(load, rest, kStep).level, std::hypot(40, 10), 9);
}

TEST(TimeWaveTest, FindsAFrequencyBetweenTheLinesOfTheRecord) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  std::vector<double> y;
  for (int i = 0; i < 8000; ++i) {
    y.push_back(i % 7 == 0 ? 0 : std::sin(2 * M_PI * 7.6391 * i * kStep) + normal(random));
  }
  // Cramer-Rao: sqrt(6/n) sigma/(pi A T) = 2.4e-4 Hz (D. C. Rife and R. R. Boorstyn, IEEE Trans. IT
  // 20 (1974) 591).
  EXPECT_NEAR(FindTimeWave(y, kStep).frequency_Hz, 7.6391, 4 * 2.4e-4);
  EXPECT_EQ(FindTimeWave({1, 2, 3}, kStep).frequency_Hz, 0);
  for (size_t i = 0; i < y.size(); ++i) y[i] += 3 * std::sin(2 * M_PI * 4 * i / y.size());
  EXPECT_NEAR(FindTimeWave(y, kStep).frequency_Hz * y.size() * kStep, 4, 0.1) << "periods";
  EXPECT_NEAR(FindTimeWave(y, kStep, 9).frequency_Hz, 7.6391, 0.1) << "of those with nine or more";
}

TEST(DataChecksTest, FindsSpikes) {
  Channel channel = Sine();
  channel.y[1000] += 4e5, channel.y[5000] -= 4e5;
  std::vector<DataFinding> findings;
  MarkSpikes(&channel, &findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].text, testing::HasSubstr("2 spikes"));
  EXPECT_TRUE(channel.bad[1000] && channel.bad[5000]);
  EXPECT_EQ(std::count(channel.bad.begin(), channel.bad.end(), 1), 2);
}

TEST(DataChecksTest, FindsSaturation) {
  Channel channel = Sine();
  for (double& y : channel.y) y = std::min(y, 2.8e6);
  std::vector<DataFinding> findings;
  MarkStuck(&channel, Clock(), &findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].text, testing::HasSubstr("saturated at 2.8e+06"));
}

TEST(DataChecksTest, FindsAStuckSensor) {
  Channel channel = Sine();
  for (int i = 2000; i < 3000; ++i) channel.y[i] = channel.y[2000];
  std::vector<DataFinding> findings;
  MarkStuck(&channel, Clock(), &findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].text, testing::HasSubstr("stuck between 10 and 15 s"));
}

/// N(0, s) rounded to 1, each sample `rows` times.
Channel RoundedNoise(double s, int rows, int seed) {
  std::mt19937 source(seed);
  std::normal_distribution<double> normal(0, s);
  Channel channel{"p_bore_Pa", "p_bore_Pa", 1, {}, {}, {}};
  for (int i = 0; i < 12000 / rows; ++i) {
    channel.y.insert(channel.y.end(), rows, std::round(normal(source)));
  }
  channel.bad.assign(channel.y.size(), 0);
  channel.noise = {.white = s, .level = s, .quantum = 1};
  return channel;
}

// At most one in a thousand of these: none in 200 has a chance of 0.8 at least.
TEST(DataChecksTest, NoiseAloneIsNeverStuck) {
  for (const double s : {0.81, 1.0, 3.0, 20.0, 1e6}) {
    for (int k = 0; k < 40; ++k) {
      for (const int rows : {1, 4}) {  // a clock four times as slow, each value held
        Channel channel = RoundedNoise(s, rows, 100 * k + rows);
        std::vector<DataFinding> findings;
        MarkStuck(&channel, Clock(), &findings);
        EXPECT_TRUE(findings.empty()) << s << " " << rows << " " << findings[0].text;
      }
    }
  }
}

// A logger that stalls for 75 ms now and then: with noise of three steps, ten equal samples are none.
TEST(DataChecksTest, FindsALoggerThatStallsForMoments) {
  Channel channel = RoundedNoise(3, 1, 7);
  for (int k = 0; k < 20; ++k) {
    for (int i = 0; i < 15; ++i) channel.y[500 * k + 100 + i] = channel.y[500 * k + 100];
  }
  std::vector<DataFinding> findings;
  MarkStuck(&channel, Clock(), &findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].text, testing::HasSubstr("stuck 20 times between 0.495 and 48.07 s"));
  EXPECT_NEAR(static_cast<double>(std::count(channel.bad.begin(), channel.bad.end(), 1)), 300, 5);
}

// Factors of NIST SP 811, appendix B. A declared model that is a fifth off changes none of it.
TEST(Units, TheNearestIsTakenAndNoneThatIsFarOff) {
  for (const auto& [channel, metric, unit] :
       std::vector<std::tuple<const char*, double, const char*>>{{"p_bore_Pa", 6894.757, "psi"},
                                                                 {"p_bore_Pa", 1e5, "bar"},
                                                                 {"p_bore_Pa", 1e3, "kPa"},
                                                                 {"load_cell_N", 9.80665, "kgf"},
                                                                 {"piston_m", 1e-2, "cm"},
                                                                 {"x_m", 1e-6, "um"},
                                                                 {"v_m_s", 1e-3, "mm/s"}}) {
    for (const double off : {1.0, 1.2, 1 / 1.2}) {
      const auto found = measurement::UnitThatReads(channel, off / metric);
      ASSERT_TRUE(found) << channel << off;
      EXPECT_EQ(found->name(), unit);
    }
  }
  EXPECT_FALSE(measurement::UnitThatReads("p_bore_Pa", 0.5));    // SI is nearer
  EXPECT_FALSE(measurement::UnitThatReads("load_cell_N", 1e2));  // no unit is a centinewton
  EXPECT_FALSE(measurement::UnitThatReads("temperature_K", 1e3));
  EXPECT_EQ(measurement::FactorOf("p_bore_Pa", "p_bore_psi"), 6894.757293168);
  EXPECT_EQ(measurement::FactorOf("p_bore_Pa", "p_bore_Pa"), 1);
}

TEST(DataChecksTest, TakesMillimetresForMetres) {
  Channel channel{"actuator_m", "actuator_m", 1, {}, {}, {}};
  for (int i = 0; i < 8000; ++i) channel.y.push_back(5 * std::sin(i * kStep));
  channel.bad.assign(channel.y.size(), 0);
  std::vector<DataFinding> findings;
  EXPECT_EQ(MendInputScale(phs_model::FindPhsParams("quarter_setup2").value(), &channel, &findings),
            1e-3);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NEAR(channel.y[314], 5e-3, 1e-5);
}

}  // namespace
}  // namespace phs::identify::search
