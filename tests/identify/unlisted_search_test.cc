// What the catalogue does not hold must be described by a formula, and no listed effect bent to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>

#include "identify/result_json.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

hydraulics::PhsParams WithUnlisted(const std::string& formula, const std::string& coefficient,
                                   double value, std::vector<std::string> targets) {
  hydraulics::PhsParams truth = OffDeclared();
  hydraulics::EffectParams effect{"unlisted", std::move(targets), {{coefficient, value}}};
  effect.formula = formula;
  truth.effects.push_back(effect);
  return truth;
}

TEST(UnlistedSearchTest, DescribesAForceThatNoEffectHolds) {
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

TEST(UnlistedSearchTest, ASpringBesideTheCylinderIsNoGainOfTheLoadCell) {
  const FitData data = Record(WithUnlisted("c1*(x/0.001[m])", "c1_N", 300, {}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_THAT(found.formula.text, testing::StartsWith("c1*(x/0.002[m])"));
  EXPECT_NEAR(found.after.values.back(), 600, 30);
  EXPECT_TRUE(found.formula.targets.empty());
}

TEST(UnlistedSearchTest, AReliefValveIsAFlowBeyondAPressure) {
  const double opening = 5e6;  // above static: beyond what a leak of any exponent gives
  const FitData data =
      Record(WithUnlisted("c1*(max(p-5e6[Pa],0[Pa])/1e6[Pa])", "c1_m3_per_s", 4e-8, {"L2"}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  EXPECT_EQ(found.formula.unit, "m3_per_s");
  ASSERT_EQ(found.formula.targets, std::vector<std::string>{"L2"});
  ASSERT_THAT(found.formula.text, testing::HasSubstr("max(p-"));
  const std::string text = found.formula.text;
  EXPECT_NEAR(std::stod(text.substr(text.find("max(p-") + 6)), opening, 0.15 * opening);
  EXPECT_LT(found.after.channel_ms[2], 1.1);
}

TEST(UnlistedSearchTest, AValveThatOpensLowIsNotToldFromALeakThatWidens) {
  const FitData data =
      Record(WithUnlisted("c1*(max(p-2e6[Pa],0[Pa])/1e6[Pa])", "c1_m3_per_s", 4e-8, {"L2"}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "external_leakage");
  EXPECT_THAT(found.effects[0].confusable_with, testing::Contains("unlisted"));
}

TEST(UnlistedSearchTest, AGradualStopIsTheFormOfAListedEffect) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"diaphragm_stop", {"L2"}, {{"min_gas_volume_m3", 4.5e-6}, {"spread", 0.12}}});
  const Identification found = Find(Declared(), Record(truth));
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "diaphragm_stop");
  EXPECT_EQ(found.effects[0].candidate.params.targets, std::vector<std::string>{"L2"});
  ASSERT_EQ(found.effects[0].candidate.free.size(), 2u);
  EXPECT_NEAR(found.after.values[found.after.values.size() - 2], 4.5e-6, 0.1e-6);
  EXPECT_NEAR(found.after.values.back(), 0.12, 0.03);
}

TEST(UnlistedSearchTest, AStopIsHeardWithinARunOfTheModel) {
  const FitData data = Record(OffDeclared());
  auto problem = FitProblem::Create(data, Declared());
  std::atomic<bool> stop{false};
  std::atomic<int> asked{0}, after{0};
  const auto found = Identify(&problem.value(), Declared(), {}, [&](double) {
    if (++asked == 40) stop = true;
    if (stop) ++after;
    return !stop;
  });
  ASSERT_TRUE(found.ok());
  EXPECT_TRUE(found.value().cancelled);
  EXPECT_LE(after, 4) << "once by each thread, and no run of the model after that";
}

TEST(CandidatesTest, OnlyThoseAskedForAreTried) {
  FitData data = Record(OffDeclared());
  data.candidates = {"backlash", "sensor_offset"};
  const auto problem = FitProblem::Create(data, Declared());
  for (const Candidate& c : problem.value().forward().Candidates(Declared())) {
    EXPECT_TRUE(c.effect == "backlash" || c.effect == "sensor_offset") << c.effect;
  }
  EXPECT_THAT(CandidateNames(), testing::IsSupersetOf({"backlash", "gas_thermal", "unlisted"}));
}

TEST(CandidatesTest, NoNumberIsFreedTwiceWhateverOptionsAreTaken) {
  for (Candidate c : ListCandidates(Declared(), effects::RigKind::kQuarter)) {
    while (!c.options.empty()) c = WithOption(c, 0);
    std::set<std::string> names;
    for (const FreeParameter& p : c.free) {
      EXPECT_TRUE(names.insert(p.name).second) << c.effect << " " << p.name;
    }
  }
}

TEST(CandidatesTest, ALeakMayBeInOneCylinderOfFour) {
  const auto four = effects::FindPhsParams("bo_bo").value();
  std::vector<std::vector<std::string>> places;
  for (const Candidate& c : ListCandidates(four, effects::RigKind::kFull)) {
    if (c.effect == "piston_leakage") places.push_back(c.params.targets);
  }
  EXPECT_THAT(places, testing::IsSupersetOf<std::vector<std::string>>({{}, {"1"}, {"4"}}));
  int alone = 0;
  for (const Candidate& c : ListCandidates(Declared(), effects::RigKind::kQuarter)) {
    alone += c.effect == "piston_leakage" && !c.params.targets.empty();
  }
  EXPECT_EQ(alone, 0) << "one cylinder is all of them";
}

TEST(Unexplained, SaysWhatTheValidationWindowAloneExcites) {
  FitData data = Record(OffDeclared());
  for (size_t i = 0; i < data.time_s.size(); ++i) {
    if (!data.InEstimation(i)) data.outputs[3].values[i] += 1e5;  // ten times the noise of p_rod
  }
  Identification found;
  found.after.channel_ms = {1, 1, 1, 1};
  auto problem = FitProblem::Create(data, Declared());
  const auto truth = problem.value().Predict(OffDeclared()).value();
  const auto over = problem.value().OverNoise(OffDeclared(), truth, data.validation);
  ASSERT_TRUE(over.ok());
  EXPECT_NEAR(over.value()[2], 1, 0.1);
  const Json left = Unexplained(data, truth, over.value(), found);
  EXPECT_EQ(left["channel"], "p_rod_Pa");
  EXPECT_NEAR(left["residual_over_noise"].get<double>(), 10, 1);
  const auto tests = NextTests(found, left);
  ASSERT_EQ(tests.size(), 1u);
  EXPECT_THAT(tests[0], testing::HasSubstr("validation window excites"));
}

}  // namespace
}  // namespace phs::identify::search
