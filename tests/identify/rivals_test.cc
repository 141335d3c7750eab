// What is left beside an effect that is told, where two laws explain it alike: one is taken, the
// other said.
#include "effects/own_law.h"
#include "identify/select/effect_search.h"
#include "identify/select/test_question.h"
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

Identification Search(const measurement::FitData& data) {
  SearchOptions options;
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

TEST(Rivals, ALawWithoutARivalIsTakenBesideAnother) {
  const measurement::FitData data = BrakedRecord({"brake"});
  const Identification found = Search(data);
  EXPECT_EQ(found.effects.size(), 2u) << Said(found);
  EXPECT_TRUE(found.effects.back().confusable_with.empty());
}

/// A rival that the rule would refuse itself: it wants more than is plausible of it.
TEST(Rivals, ALawAtTheEndOfItsRangeStandsAgainstNone) {
  const double fitted = Search(BrakedRecord({"brake"})).after.values.back();
  measurement::FitData data = BrakedRecord({"brake", "other_brake"});
  data.own.back().numbers.front().high = 1.001 * fitted;
  const Identification found = Search(data);
  EXPECT_EQ(AcceptedNames(found), (std::vector<std::string>{"external_leakage", "brake"}))
      << Said(found);
}

TEST(Rivals, OfTwoLawsThatExplainAlikeOneIsTakenAndTheOtherSaid) {
  const measurement::FitData data = BrakedRecord({"brake", "other_brake"});
  const Identification found = Search(data);
  ASSERT_EQ(found.effects.size(), 2u) << Said(found);
  const AcceptedEffect &leak = found.effects[0], &brake = found.effects[1];
  EXPECT_EQ(leak.candidate.effect, "external_leakage");
  EXPECT_TRUE(leak.confusable_with.empty());
  EXPECT_NE(brake.candidate.effect.find("brake"), std::string::npos);
  ASSERT_EQ(brake.confusable_with.size(), 1u);
  EXPECT_NE(brake.confusable_with[0].find("brake"), std::string::npos);
  EXPECT_NE(brake.confusable_with[0], brake.candidate.effect);
  // Which test would tell them?
  auto problem = ProblemOf(data, Declared());
  const std::vector<Question> questions = OpenQuestions(problem.value(), found);
  ASSERT_EQ(questions.size(), 1u);
  EXPECT_NE(questions[0].one.name, questions[0].other.name);
  EXPECT_NE(questions[0].one.name.find("brake"), std::string::npos);
}

}  // namespace
}  // namespace phs::identify::search
