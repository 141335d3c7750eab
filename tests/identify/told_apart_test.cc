// What is left beside an effect that is told, where two laws explain it alike: neither is taken.
#include "effects/own_law.h"
#include "identify/effect_search.h"
#include "identify/test_question.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::EffectParams;
using hydraulics::PhsParams;

/// A brake on the piston of c |v| v: one law under a name of choice.
EffectParams Brake(const std::string& name, double c) {
  effects::OwnLaw law;
  law.where = "piston", law.expression = "c*v*abs(v)/1[m/s]";
  return {name, {}, {{"c_Ns_per_m", c}}, effects::ToText(law)};
}

/// A record with a leak and a weaker brake, and the brake offered under these names.
measurement::FitData BrakedRecord(const std::vector<std::string>& names) {
  PhsParams truth = Declared();
  truth.effects.push_back({"external_leakage", {"L1"}, {{"conductance_m3_per_Pas", 3e-14}}});
  truth.effects.push_back(Brake("brake", 2e7));
  measurement::FitData data = Record(truth);
  for (const std::string& name : names) {
    data.own.push_back({Brake(name, 1e7), {{"c_Ns_per_m", 1e5, 1e9}}, name});
  }
  data.candidates = {"external_leakage"};
  return data;
}

Identification Search(const measurement::FitData& data, bool told_apart = true) {
  SearchOptions options;
  options.rule.told_apart = told_apart;
  options.formula = false;
  auto rig = RigForward::Create(data, Declared());
  auto problem = FitProblem::Create(rig.value(), Declared(), options.rule);
  auto found = Identify(&problem.value(), Declared(), options, nullptr);
  EXPECT_TRUE(found.ok());
  return found.value();
}

std::vector<std::string> AcceptedNames(const Identification& found) {
  std::vector<std::string> out;
  for (const AcceptedEffect& e : found.effects) out.push_back(e.candidate.effect);
  return out;
}

TEST(ToldApart, ALawWithoutARivalIsTakenBesideAnother) {
  const measurement::FitData data = BrakedRecord({"brake"});
  const Identification found = Search(data);
  EXPECT_EQ(found.effects.size(), 2u) << Said(found);
  EXPECT_TRUE(found.untold.empty());
}

/// A rival that the rule would refuse itself: it wants more than is plausible of it.
TEST(ToldApart, ALawAtTheEndOfItsRangeStandsAgainstNone) {
  const double fitted = Search(BrakedRecord({"brake"})).after.values.back();
  measurement::FitData data = BrakedRecord({"brake", "other_brake"});
  data.own.back().numbers.front().high = 1.001 * fitted;
  const Identification found = Search(data);
  EXPECT_EQ(AcceptedNames(found), (std::vector<std::string>{"external_leakage", "brake"}))
      << Said(found);
}

TEST(ToldApart, OfTwoLawsThatExplainAlikeNeitherIsTakenBesideAnother) {
  const measurement::FitData data = BrakedRecord({"brake", "other_brake"});
  const Identification found = Search(data);
  EXPECT_EQ(AcceptedNames(found), std::vector<std::string>{"external_leakage"}) << Said(found);
  EXPECT_EQ(UntoldNames(found).size(), 2u);
  // The question stays: which test would tell them?
  auto problem = ProblemOf(data, Declared());
  const std::vector<Question> questions = OpenQuestions(problem.value(), found);
  ASSERT_EQ(questions.size(), 1u);
  EXPECT_NE(questions[0].one.name, questions[0].other.name);
  EXPECT_NE(questions[0].one.name.find("brake"), std::string::npos);
  EXPECT_EQ(Search(data, false).effects.size(), 2u) << "without the rule one of them is taken";
}

}  // namespace
}  // namespace phs::identify::search
