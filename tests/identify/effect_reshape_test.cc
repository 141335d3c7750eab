// Effects accepted one after the other, looked at anew beside each other; and fits that do not let
// one channel's shortcoming bend the others.
#include "identify/effect_reshape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "identify/effect_trials.h"
#include "identify/near_fit.h"
#include "phs_model/phs_model.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {

using measurement::FitData;
namespace {

Candidate Of(const char* effect, const std::vector<const char*>& free,
             const std::vector<double>& start,
             const std::vector<std::pair<const char*, double>>& fixed = {}) {
  return MakeCandidate(*effects::Catalogue().Find(effect), free, {start}, fixed);
}

TEST(ReshapeTest, AResistanceAlikeInBothDirectionsIsNoCheckValveOnceTheWarmingIsThere) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"line_resistance", {}, {{"laminar_Pas_per_m3", 8e9}}});
  truth.effects.push_back(
      {"temperature_drift", {}, {{"rate_K_per_s", 0.01}, {"settling_s", 1000}}});
  const FitData data = Record(truth);
  auto problem = FitProblem::Create(data, Declared());
  ASSERT_TRUE(problem.ok());
  auto coarse = problem.value().Thinned(Declared(), 2);
  ASSERT_TRUE(coarse.ok());

  Identification found;
  found.declared = found.corrected = DeclaredModel(Declared());
  std::vector<double> start;
  for (const auto& p : found.declared.free) start.push_back(p.start);
  for (const Candidate& c :
       {Of("check_restriction", {"out_Pas_per_m3", "in_Pas_per_m3"}, {7e9, 9e9}),
        Of("temperature_drift", {"rate_K_per_s", "settling_s"}, {0.01, 900})}) {
    found.corrected = WithCandidate(found.corrected, c);
    start.insert(start.end(), c.starts[0].begin(), c.starts[0].end());
    found.effects.push_back({c, {}, {}});
  }
  found.after = FitNear(problem.value(), found.corrected, start, {},
                        {.max_steps = 8, .final_jacobian = true});
  ASSERT_TRUE(found.after.ok);
  found.candidates.resize(1);
  found.candidates[0].effect = "check_restriction", found.candidates[0].verdict = "accepted";

  ReshapeEffects(
      problem.value(), coarse.value(), {}, [](double) { return true; }, &found);
  ASSERT_EQ(found.effects.size(), 2u);
  double resistance = 0;
  for (size_t i = 0; i < found.corrected.free.size(); ++i) {
    if (found.corrected.free[i].name != "effects.line_resistance.laminar_Pas_per_m3") continue;
    resistance = found.after.values[i];
  }
  EXPECT_NEAR(resistance, 8e9, 0.03 * 8e9);
  EXPECT_EQ(found.candidates.front().verdict, "a simpler effect that it contains suffices");
  // Numbers, columns and effects have moved together.
  ASSERT_EQ(found.after.values.size(), found.corrected.free.size());
  const Eigen::VectorXd again = problem.value().Residual(found.corrected, found.after.values);
  EXPECT_LT((again - found.after.residual).norm(), 1e-9 * again.norm());
  Eigen::VectorXd residual;
  Eigen::MatrixXd columns;
  ASSERT_TRUE(
      problem.value().Linearise(found.corrected, found.after.values, 0, &residual, &columns));
  EXPECT_LT((columns - found.after.jacobian).norm(), 1e-6 * columns.norm());
  EXPECT_EQ(found.effects.back().candidate.effect, "temperature_drift") << "the order is kept";
  FreeModel rest;
  const size_t count = ValuesWithout(found, 0, &rest).size();
  EXPECT_EQ(count, rest.free.size());
}

TEST(ShapeOnWholeTest, ANumberThatOnlyTheWholeRecordAsksForIsFreed) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(
      {"line_resistance", {}, {{"laminar_Pas_per_m3", 8e9}, {"rod_ratio", 0.7}}});
  const FitData data = Record(truth);
  auto problem = FitProblem::Create(data, Declared());
  ASSERT_TRUE(problem.ok());
  const FreeModel model = DeclaredModel(Declared());
  FullTrial trial;
  for (const Candidate& c : problem.value().forward().Candidates(Declared())) {
    const bool plain = VariantName(c) == "laminar_Pas_per_m3" && !c.options.empty();
    if (trial.form.free.empty() && c.effect == "line_resistance" && plain) trial.form = c;
  }
  ASSERT_EQ(trial.form.free.size(), 1u);
  std::vector<double> start;
  for (const auto& p : model.free) start.push_back(p.start);
  start.push_back(5e9);
  trial.fit = FitNear(problem.value(), WithCandidate(model, trial.form), start, {},
                      {.max_steps = 8, .final_jacobian = true});
  ASSERT_TRUE(trial.fit.ok);
  ShapeOnWhole(problem.value(), model, &trial);
  const FreeModel whole = WithCandidate(model, trial.form);
  ASSERT_EQ(trial.fit.values.size(), whole.free.size());
  double ratio = 0;
  for (size_t i = 0; i < whole.free.size(); ++i) {
    if (whole.free[i].name == "effects.line_resistance.rod_ratio") ratio = trial.fit.values[i];
  }
  EXPECT_NEAR(ratio, 0.7, 0.03);
}

TEST(DeclaredModelTest, TheNumbersNamedAreFreeAndNoOthers) {
  FitData data = Record(OffDeclared());
  data.free = {"friction.scale", "L2.gas_volume_m3"};
  auto problem = FitProblem::Create(data, Declared());
  ASSERT_TRUE(problem.ok());
  const FreeModel model = problem.value().forward().Declared(Declared());
  ASSERT_EQ(model.free.size(), 2u);
  EXPECT_EQ(model.free[0].name, "friction.scale");
  EXPECT_DOUBLE_EQ(model.free[1].start, 16.16e-6);
  EXPECT_DOUBLE_EQ(model.free[1].high, 2.5 * 16.16e-6);
  EXPECT_TRUE(CheckFree(Declared(), data.free).ok());
  const Status unknown = CheckFree(Declared(), {"L2.gas_volume"});
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().where, "free: L2.gas_volume");
  EXPECT_FALSE(CheckFree(Declared(), {"L2.free_air_m3"}).ok()) << "nil in the declared model";
}

TEST(DeclaredModelTest, FreeAirOfAChamberIsFreeByItself) {
  const auto cylinder = phs_model::FindPhsParams("single_cylinder").value();
  std::vector<std::string> names;
  for (const FreeParameter& p : DeclaredModel(cylinder).free) names.push_back(p.name);
  EXPECT_EQ(names, (std::vector<std::string>{"chamber.oil_volume_m3", "chamber.free_air_m3",
                                             "friction.scale"}));
}

TEST(NearFitTest, BalancedWhatOneChannelLacksDoesNotBendTheOthers) {
  FitData data = Record(OffDeclared());
  for (size_t i = 0; i < data.time_s.size(); ++i) {  // a force that the model lacks
    data.outputs[1].values[i] += 3000 * std::sin(2 * M_PI * data.time_s[i] / 7);
  }
  auto problem = FitProblem::Create(data, Declared());
  ASSERT_TRUE(problem.ok());
  const FreeModel model = DeclaredModel(Declared());
  std::vector<double> start;
  for (const auto& p : model.free) start.push_back(p.start);
  const auto error = [&](bool balanced) {
    FitResult fit = FitNear(problem.value(), model, start, {}, {.max_steps = 15});
    if (balanced) {
      fit = FitNear(problem.value(), model, fit.values, {}, {.max_steps = 15, .balanced = true});
    }
    const hydraulics::PhsParams truth = OffDeclared();
    return std::abs(std::log(fit.values[0] / truth.lines[0].oil_volume_m3)) +
           std::abs(std::log(fit.values[3] / truth.lines[1].gas_volume_m3));
  };
  const double plain = error(false), balanced = error(true);
  EXPECT_GT(plain, 0.02);
  EXPECT_LT(balanced, 0.3 * plain);
}

}  // namespace
}  // namespace phs::identify::search
