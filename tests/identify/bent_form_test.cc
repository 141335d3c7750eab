// A law whose form is not quite right, and a second effect that takes what it leaves.
#include "identify/select/bent_form.h"

#include <gtest/gtest.h>

#include "identify/discrepancy/driven_formula.h"
#include "identify/fit/near_fit.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

Candidate OneTermFormula(const std::string& text, double coefficient) {
  FoundFormula found;
  found.text = text, found.coefficients = {coefficient};
  return FormulaCandidate(found, 1e5);
}

/// The host is a thrust of the bore pressure, in the record as in the model; beside it a force.
/// Which effect the second is the form of, both fitted.
std::optional<size_t> HostOf(const std::string& second, double coefficient) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back({"pressure_area", {"L2"}, {{"area_m2", -3e-4}}});
  truth.effects.push_back({"unlisted", {}, {{"c1_N", coefficient}}, second});
  const measurement::FitData data = Record(truth);
  const auto problem = ProblemOf(data, Declared());
  EXPECT_TRUE(problem.ok());
  const FitProblem& p = problem.value();
  Identification found;
  found.declared = p.forward().Declared(Declared());
  for (const Candidate& c : p.forward().Candidates(Declared())) {
    if (c.effect != "pressure_area" || c.params.targets != std::vector<std::string>{"L2"}) continue;
    found.effects.push_back({c, {}, {}});
    break;
  }
  EXPECT_EQ(found.effects.size(), 1u);
  found.effects.push_back({OneTermFormula(second, coefficient), {}, {}});
  found.effects[0].evidence.delta_bic = 1000, found.effects[1].evidence.delta_bic = 100;
  found.corrected = found.declared;
  std::vector<double> start;
  for (const AcceptedEffect& e : found.effects) {
    found.corrected = WithCandidate(found.corrected, e.candidate);
  }
  for (const FreeParameter& free : found.corrected.free) start.push_back(free.start);
  const NearFitOptions options{.max_steps = 25, .final_slopes = true};
  found.after = FitNear(p, found.corrected, start, {}, options);
  FreeModel model;
  const std::vector<double> values = ValuesWithout(found, 1, &model);
  const FitResult rest = FitNear(p, model, values, {}, options);
  EXPECT_TRUE(found.after.ok && rest.ok);
  EXPECT_GT(rest.score - found.after.score, 100) << "the record tells that there is more";
  return IsFormOf(p, found, 1, model, rest);
}

TEST(BentForm, AThrustThatGrowsWithTheStrokeIsItsOwnForm) {
  EXPECT_EQ(HostOf("c1*(p/1000000[Pa])*(x/0.002[m])", 40), 0u);
}

TEST(BentForm, AThrustThatBendsOverThePressureIsItsOwnForm) {
  EXPECT_EQ(HostOf("c1*(p/1000000[Pa])*(abs(p)/1000000[Pa])", 40), 0u);
}

TEST(BentForm, ACoggingBesideAThrustIsACauseOfItsOwn) {
  EXPECT_FALSE(HostOf("c1*sin(2*pi*x/0.0007[m])", 150).has_value());
}

}  // namespace
}  // namespace phs::identify::search
