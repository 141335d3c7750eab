// What the search carries from one accepted effect to the next: weights and starts.
#include "identify/reweigh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "identify/near_fit.h"
#include "identify/seen_starts.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {

using measurement::FitData;
namespace {

Candidate Presliding() {
  return MakeCandidate(*effects::Catalogue().Find("presliding"), {"stiffness_N_per_m"}, {{1e8}},
                       {{"breakaway_ratio", 0.7}});
}

/// Declared and corrected model of a record, both fitted.
Identification Found(const FitProblem& problem, const Candidate& effect, double value) {
  Identification found;
  found.declared = problem.forward().Declared(Declared());
  std::vector<double> start;
  for (const FreeParameter& p : found.declared.free) start.push_back(p.start);
  found.before = FitBalanced(problem, found.declared, start, {}, {.final_jacobian = true});
  found.corrected = WithCandidate(found.declared, effect);
  start.push_back(value);
  found.after = FitBalanced(problem, found.corrected, start, {}, {.final_jacobian = true});
  return found;
}

TEST(Reweigh, AStiffBristleChangesWeightsAndBothFitsAViscousForceNeither) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"presliding", {}, {{"stiffness_N_per_m", 3e8}}});
  const FitData data = Record(truth);
  FitProblem problem = FitProblem::Create(data, Declared()).value();
  FitProblem coarse = problem.Thinned(Declared(), 2).value();
  const SampleWeights fine_weights = problem.weights(), coarse_weights = coarse.weights();

  const Candidate viscous = MakeCandidate(*effects::Catalogue().Find("viscous_friction"),
                                          {"extension_Ns_per_m"}, {{1e3}}, {});
  Identification plain = Found(problem, viscous, 1e3);
  const Eigen::VectorXd residual = plain.after.residual;
  Reweigh(&problem, &coarse, &plain);
  EXPECT_EQ(problem.weights(), fine_weights);
  EXPECT_EQ(plain.after.residual, residual);

  Identification stiff = Found(problem, Presliding(), 3e8);
  const double load = stiff.after.channel_ms[1], before = stiff.before.channel_ms[1];
  Reweigh(&problem, &coarse, &stiff);
  EXPECT_NE(problem.weights()[1], fine_weights[1]);
  EXPECT_NE(coarse.weights()[1], coarse_weights[1]);
  EXPECT_LT(stiff.after.channel_ms[1], 0.9 * load) << "less is left where the motion does not tell";
  EXPECT_NE(stiff.before.channel_ms[1], before);
}

TEST(SeenStarts, AreThoseOfTheSameNumbersInTheSamePlaceThatPromisedSomething) {
  const auto of = [](const char* place) {
    Candidate c =
        MakeCandidate(*effects::Catalogue().Find("entrained_air"), {"air_fraction"}, {{1e-3}}, {});
    c.params.targets = {place};
    return c;
  };
  const Candidate first = of("L1"), second = of("L2");
  FullTrial good, poor;
  good.candidate = &first, good.predicted = -0.2, good.start = {1, 2, 0.04};
  poor.candidate = &second, poor.predicted = -0.001, poor.start = {1, 2, 0.08};
  SeenStarts seen;
  seen.Note({good, poor}, 2, 0);
  std::vector<Candidate> list = {first, second};
  seen.AddStarts(&list);
  EXPECT_EQ(list[0].starts, (std::vector<std::vector<double>>{{1e-3}, {0.04}}));
  EXPECT_EQ(list[1].starts, (std::vector<std::vector<double>>{{1e-3}}));
}

}  // namespace
}  // namespace phs::identify::search
