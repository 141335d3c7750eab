// Effects accepted one after the other, looked at anew beside each other; and fits that do not let
// one channel's shortcoming bend the others.
#include "identify/effect_reshape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/near_fit.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
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
