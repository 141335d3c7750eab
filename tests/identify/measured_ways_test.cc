// Forces and pressures of a bogie's PHS at the measured ways of its pistons.
#include "identify/models/measured_ways.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/data_path.h"
#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"

namespace phs::identify::search {
namespace {

using measurement::FitData;
using Span = ForwardModel::Span;

hydraulics::PhsParams BoBo() {
  const auto path = FindData("PHS model", "models/phs", "bo_bo", {".yaml"});
  return phs_model::LoadPhsParams(path.value()).value();
}

/// Ten seconds at 50 Hz: four ways as sines of 2 mm, one load cell, one line, one place of an axle.
FitData BogieRecord() {
  FitData data;
  data.step_s = 0.02, data.estimation = {0.2, 6}, data.validation = {6, 10};
  for (int i = 0; i < 500; ++i) data.time_s.push_back(0.02 * i);
  const auto add = [&](const std::string& name, double amplitude, double hertz, double noise) {
    data.outputs.push_back({name, {}, noise});
    for (const double t : data.time_s) {
      data.outputs.back().values.push_back(amplitude * std::sin(2 * std::numbers::pi * hertz * t));
    }
  };
  add("piston1_m", 2e-3, 0.2, 1e-6), add("piston2_m", -2e-3, 0.3, 1e-6);
  add("piston3_m", 2e-3, 0.4, 1e-6), add("piston4_m", -2e-3, 0.5, 1e-6);
  add("load3_N", 0, 1, 50), add("lead_lateral_m", 1e-3, 0.1, 1e-5), add("pL2_Pa", 0, 1, 1e3);
  return data;
}

PhsOutputsOf Outputs() { return {{0, 1, 2, 3}, {-1, -1, 4, -1}, {-1, 6, -1, -1}}; }

TEST(MeasuredWays, ForcesAndPressuresAreThoseOfTheFullRigDrivenByTheWays) {
  const FitData data = BogieRecord();
  const hydraulics::PhsParams phs = BoBo();
  const auto ways = MeasuredWays::Of(data, Outputs(), phs);
  ASSERT_NE(ways, nullptr);
  const Channels before(data.outputs.size(), std::vector<double>(data.time_s.size(), 7.0));
  Channels out = before;
  ASSERT_TRUE(ways->Put(phs, Span::kWhole, &out).ok());
  for (const int kept : {0, 1, 2, 3, 5}) EXPECT_EQ(out[kept], before[kept]);

  rigs::RigOptions options;
  options.actuators = 4;
  const auto rig = rigs::RigModel::Create(rigs::RigKind::kFull, phs, options);
  ASSERT_TRUE(rig.ok());
  rigs::RigMotion motion{.t0_s = 0, .step_s = data.step_s};
  for (int c = 0; c < 4; ++c) motion.position_m.push_back(data.outputs[c].values);
  rigs::RigPrediction wanted;
  ASSERT_TRUE(rig.value().Run(motion, &wanted).ok());
  // The ways are smoothed: a micrometre is 36 N of a seal that holds; the lines rise by 10 MPa.
  for (size_t i = 0; i < data.time_s.size(); ++i) {
    EXPECT_NEAR(out[4][i], wanted.channels[4 + 2][i], 100) << data.time_s[i];
    EXPECT_NEAR(out[6][i], wanted.channels[8 + 1][i], 5e3) << data.time_s[i];
  }
}

TEST(MeasuredWays, ThinnedRunsAreEverySoManythSample) {
  const FitData data = BogieRecord();
  const hydraulics::PhsParams phs = BoBo();
  const auto ways = MeasuredWays::Of(data, Outputs(), phs, 2);
  ASSERT_NE(ways, nullptr);
  Channels out(data.outputs.size(), std::vector<double>(150, 7.0));  // 0 to 6 s
  ASSERT_TRUE(ways->Put(phs, Span::kEstimation, &out).ok());
  EXPECT_EQ(out[4].size(), 150u);
  EXPECT_EQ(out[6].size(), 150u);
}

TEST(MeasuredWays, WhatTheNoiseOfTheWaysMakesIsUncertain) {
  const FitData data = BogieRecord();
  const hydraulics::PhsParams phs = BoBo();
  const auto ways = MeasuredWays::Of(data, Outputs(), phs);
  ASSERT_NE(ways, nullptr);
  Channels deviation(data.outputs.size(), std::vector<double>(data.time_s.size(), 0.0));
  ASSERT_TRUE(ways->PutUncertainty(phs, Span::kWhole, &deviation).ok());
  double most = 0;
  for (const double d : deviation[4]) {
    EXPECT_GE(d, 0);
    most = std::max(most, d);
  }
  EXPECT_GT(most, 5);
  EXPECT_LT(most, 1500) << "more than a seal holds";
  EXPECT_EQ(deviation[5], std::vector<double>(data.time_s.size(), 0.0));
}

TEST(MeasuredWays, WithoutAllWaysThereAreNone) {
  const hydraulics::PhsParams phs = BoBo();
  PhsOutputsOf three = Outputs();
  three.pistons[2] = -1;
  EXPECT_EQ(MeasuredWays::Of(BogieRecord(), three, phs), nullptr);
  PhsOutputsOf ways_alone{{0, 1, 2, 3}, {-1, -1, -1, -1}, {-1, -1, -1, -1}};
  EXPECT_EQ(MeasuredWays::Of(BogieRecord(), ways_alone, phs), nullptr);
  FitData gap = BogieRecord();
  for (int i = 100; i < 149; ++i) gap.outputs[1].values[i] = NAN;
  EXPECT_NE(MeasuredWays::Of(gap, Outputs(), phs), nullptr) << "0.98 s are bridged";
  for (int i = 149; i < 152; ++i) gap.outputs[1].values[i] = NAN;
  EXPECT_EQ(MeasuredWays::Of(gap, Outputs(), phs), nullptr) << "1.04 s are not";
}

/// Mean of a force where it slides out less that where it slides in, 2 s each.
double OutLessIn(const std::vector<double>& force) {
  double sum = 0;
  for (size_t i = 0; i < 100; ++i) sum += force[i + 50] - force[i + 300];
  return sum / 100;
}

// A piston that creeps and trembles by less than its sensor's noise: the smoothed way does not tremble,
// and at it the seal holds more. A run of the vehicle, whose trembling has other instants, says how much.
TEST(MeasuredWays, ASealThatTremblesHoldsLess) {
  FitData data = BogieRecord();
  const hydraulics::PhsParams phs = BoBo();
  const auto way = [&](double i, double phase, double amplitude) {
    const double t = 0.02 * i, turn = 2 * std::numbers::pi;
    return 3e-4 * std::sin(turn * 0.1 * t) + amplitude * std::sin(turn * 4.3 * t + phase);
  };
  const rigs::RigOptions options{.actuators = 4};
  const auto rig = rigs::RigModel::Create(rigs::RigKind::kFull, phs, options);
  ASSERT_TRUE(rig.ok());
  rigs::RigMotion motion{.t0_s = 0, .step_s = data.step_s};
  Channels of_vehicle(data.outputs.size(), std::vector<double>(data.time_s.size(), 0.0));
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 2e-5);
  for (size_t c = 0; c < 4; ++c) {
    motion.position_m.emplace_back();
    data.outputs[c].noise = 2e-5;
    for (size_t i = 0; i < data.time_s.size(); ++i) {
      motion.position_m[c].push_back(way(i, 1 + c, 8e-6));
      data.outputs[c].values[i] = motion.position_m[c].back() + noise(random);
      of_vehicle[c][i] = way(i, 2.5 * c, 8e-6);
    }
  }
  rigs::RigPrediction truth;
  ASSERT_TRUE(rig.value().Run(motion, &truth).ok());
  const double wanted = OutLessIn(truth.channels[4 + 2]);
  const auto ways = MeasuredWays::Of(data, Outputs(), phs);
  ASSERT_NE(ways, nullptr);
  const auto error = [&](bool trembles) {
    Channels at(data.outputs.size(), std::vector<double>(data.time_s.size(), 0.0));
    EXPECT_TRUE((trembles ? ways->PutTrembling(phs, Span::kWhole, of_vehicle, &at)
                          : ways->Put(phs, Span::kWhole, &at))
                    .ok());
    return OutLessIn(at[4]) - wanted;
  };
  const double smooth = error(false), trembling = error(true);
  EXPECT_GT(smooth, 300) << "[N] else nothing is shown";
  EXPECT_LT(std::abs(trembling), 0.3 * smooth);
}

}  // namespace
}  // namespace phs::identify::search
