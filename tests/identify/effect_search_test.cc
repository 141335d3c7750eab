// The search on small records made with the rig model itself: what is switched on must be found,
// and nothing must be found where nothing is.
#include "identify/effect_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "effects/catalogue.h"
#include "identify/data_checks.h"

namespace phs::identify::search {
namespace {

/// 60 s at 100 Hz: sines of two speeds, holds at rest; white sensor noise.
FitData Record(const hydraulics::PhsParams& truth) {
  FitData data;
  data.step_s = 0.01;
  data.estimation = {0, 40};
  data.validation = {40, 60};
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  effects::RigMotion motion{0, data.step_s, {{}}, {}, {}};
  for (int i = 0; i < 6000; ++i) {
    const double t = i * data.step_s;
    data.time_s.push_back(t);
    const double phase = std::fmod(t, 20.0);
    const double x =
        phase < 16 ? 2e-3 * std::sin(2 * M_PI * phase / 4) + 4e-4 * std::sin(2 * M_PI * phase) : 0;
    motion.position_m[0].push_back(x);
  }
  const auto rig = effects::RigModel::Create(effects::RigKind::kQuarter, truth);
  effects::RigPrediction clean;
  EXPECT_TRUE(rig.value().Run(motion, &clean).ok());
  data.inputs.push_back({"actuator_m", motion.position_m[0], 5e-7});
  for (double& x : data.inputs[0].values) x += 5e-7 * normal(random);
  data.motion.push_back(SmoothPosition(data.inputs[0].values, {}, data.step_s, 5e-7));
  const double noise[] = {1.5e-6, 40, 1e4, 1e4};
  for (size_t c = 0; c < 4; ++c) {
    data.outputs.push_back({rig.value().output_names()[c], clean.channels[c], noise[c]});
    for (double& y : data.outputs.back().values) y += noise[c] * normal(random);
  }
  return data;
}

Identification Find(const hydraulics::PhsParams& declared, const FitData& data) {
  auto problem = FitProblem::Create(data, declared);
  auto found = Identify(&problem.value(), declared, {}, nullptr);
  EXPECT_TRUE(found.ok());
  return found.value();
}

hydraulics::PhsParams Declared() { return effects::FindPhsParams("quarter_setup2").value(); }

hydraulics::PhsParams OffDeclared() {
  hydraulics::PhsParams truth = Declared();
  truth.lines[0].oil_volume_m3 *= 1.2, truth.lines[1].gas_volume_m3 *= 0.8;
  truth.friction.scale = 0.85;
  return truth;
}

TEST(EffectSearchTest, FindsNothingWhereTheDeclaredModelSuffices) {
  const FitData data = Record(OffDeclared());
  const Identification found = Find(Declared(), data);
  EXPECT_TRUE(found.effects.empty());
  EXPECT_NEAR(found.before.values.back(), 0.85, 0.01);
}

TEST(EffectSearchTest, FindsMountCompliance) {
  hydraulics::PhsParams truth = OffDeclared();
  ASSERT_TRUE(effects::AddEffect(&truth, "mount_compliance").ok());
  const FitData data = Record(truth);
  const Identification found = Find(Declared(), data);
  ASSERT_FALSE(found.effects.empty());
  EXPECT_EQ(found.effects[0].candidate.effect, "mount_compliance");
  EXPECT_NEAR(found.after.values.back(), 4.1e7, 0.05 * 4.1e7);
}

TEST(EffectSearchTest, FindsAnOrificeLeakAndItsExponent) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"piston_leakage", {}, {{"conductance_m3_per_Pas", 4e-14}, {"exponent", 0.5}}});
  const FitData data = Record(truth);
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "piston_leakage");
  const auto params = found.corrected.params.effects[0];
  const auto& free = found.corrected.free;
  double exponent = params.values.at("exponent");
  for (size_t i = 0; i < free.size(); ++i) {
    if (free[i].name == "effects.piston_leakage.exponent") exponent = found.after.values[i];
  }
  EXPECT_NEAR(exponent, 0.5, 0.15);
}

TEST(EffectSearchTest, DescribesAForceThatNoEffectHolds) {
  hydraulics::PhsParams truth = OffDeclared();
  hydraulics::EffectParams cogging{"unlisted", {}, {{"c1_N", 250}}};
  cogging.formula = "c1*sin(2*pi*x/0.0007[m])";
  truth.effects.push_back(cogging);
  const FitData data = Record(truth);
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_THAT(found.formula.text, testing::HasSubstr("sin(2*pi*x/0.000"));
  EXPECT_LT(found.after.channel_ms[1], 0.2 * found.before.channel_ms[1]);
}

TEST(ClusteredDeviation, IsThatOfTheBlocksWhereAResidualIsEvenInEach) {
  // A mean over B blocks of even residuals r_b: deviation sqrt(sum r_b²)/B sqrt(B/(B-1)).
  constexpr int kBlocks = 20, kRows = 50;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(kBlocks * kRows, 1);
  Eigen::VectorXd r(kBlocks * kRows);
  std::vector<int> block;
  for (int i = 0; i < kBlocks * kRows; ++i) {
    block.push_back(i / kRows);
    r[i] = i / kRows % 2 == 0 ? 3 : -3;
  }
  double quantile = 0;
  const Eigen::VectorXd deviation = ClusteredDeviation(one, r, block, kBlocks, &quantile);
  ASSERT_EQ(deviation.size(), 1);
  EXPECT_NEAR(deviation[0], 3 / std::sqrt(20.0) * std::sqrt(20.0 / 19), 1e-9);
  EXPECT_NEAR(quantile, 2.093, 0.01);  // Student, 19 degrees of freedom
}

TEST(EffectSearchTest, NamesAChannelOfSwappedSign) {
  FitData data = Record(Declared());
  for (double& y : data.outputs[1].values) y = -y;
  const auto problem = FitProblem::Create(data, Declared());
  MendOutputs(problem.value().Predict(Declared()).value(), &data);
  ASSERT_EQ(data.findings.size(), 1u);
  EXPECT_EQ(data.findings[0].channel, "load_cell_N");
  EXPECT_THAT(data.findings[0].text, testing::HasSubstr("sign swapped"));
}

TEST(EffectSearchTest, NamesChannelsUnderEachOthersNameAndUnits) {
  FitData data = Record(Declared());
  std::swap(data.outputs[2].values, data.outputs[3].values);
  for (double& y : data.outputs[1].values) y *= 1e-3;
  const auto problem = FitProblem::Create(data, Declared());
  const auto predicted = problem.value().Predict(Declared()).value();
  EXPECT_FALSE(InputIsSwapped(data, predicted));
  MendOutputs(predicted, &data);
  ASSERT_EQ(data.findings.size(), 2u);
  EXPECT_EQ(data.findings[0].channel, "p_bore_Pa");
  EXPECT_THAT(data.findings[0].text, testing::HasSubstr("p_rod_Pa"));
  EXPECT_EQ(data.findings[1].channel, "load_cell_N");
  EXPECT_THAT(data.findings[1].text, testing::HasSubstr("1e3"));
  EXPECT_NEAR(data.outputs[2].values[100], predicted[2][100], 1e5);
}

TEST(EffectSearchTest, SeesThatTheDrivingMotionIsSwapped) {
  FitData data = Record(Declared());
  for (double& x : data.motion[0].position) x = -x;
  for (double& v : data.motion[0].speed) v = -v;
  const auto problem = FitProblem::Create(data, Declared());
  EXPECT_TRUE(InputIsSwapped(data, problem.value().Predict(Declared()).value()));
}

}  // namespace
}  // namespace phs::identify::search
