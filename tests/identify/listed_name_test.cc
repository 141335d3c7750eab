// A formula that is a listed effect gets its name; a physical cause goes before an instrument; what
// drives is said.
#include "identify/select/listed_name.h"

#include <gmock/gmock.h>

#include "identify/fit/accept.h"
#include "identify/fit/near_fit.h"
#include "identify/select/passivity.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;
using measurement::FitData;

struct Tried {
  FreeModel model;
  FitResult fit;
  FormulaTrial formula;
};

/// The formula that the declared model's residual asks for.
Tried TryOn(const FitProblem& problem, const FitProblem& coarse) {
  Tried out;
  out.model = problem.forward().Declared(Declared());
  std::vector<double> start;
  for (const auto& p : out.model.free) start.push_back(p.start);
  out.fit = FitNear(problem, out.model, start, {}, {.max_steps = 15, .final_slopes = true});
  out.formula = TryFormula(problem, coarse, out.model, out.fit, {.max_terms = 1});
  return out;
}

std::optional<ListedName> NameOn(const PhsParams& truth) {
  const FitData data = Record(truth);
  const auto problem = ProblemOf(data, Declared());
  const auto coarse = problem.value().Coarse(Declared(), 0.02);
  const Tried tried = TryOn(problem.value(), coarse.value());
  EXPECT_TRUE(tried.formula.fit.ok);
  return FindListedName(problem.value(), coarse.value(), tried.model, tried.fit, tried.formula, {},
                        [](double) { return true; });
}

TEST(ListedName, AFormulaOverPressureIsPressureFriction) {
  PhsParams truth = OffDeclared();
  ASSERT_TRUE(phs_model::AddEffect(&truth, "pressure_friction").ok());
  const auto name = NameOn(truth);
  ASSERT_TRUE(name);
  EXPECT_EQ(name->form.effect, "pressure_friction");
}

TEST(ListedName, ALeakFoundAsAFlowIsALeak) {
  PhsParams truth = OffDeclared();
  ASSERT_TRUE(phs_model::AddEffect(&truth, "external_leakage").ok());
  const auto name = NameOn(truth);
  ASSERT_TRUE(name);
  EXPECT_EQ(name->form.effect, "external_leakage");
}

TEST(ListedName, AWaveInForceOverPositionIsOnNoList) {
  PhsParams truth = OffDeclared();
  hydraulics::EffectParams cogging{"unlisted", {}, {{"c1_N", 250}}};
  cogging.formula = "c1*sin(2*pi*x/0.0007[m])";
  truth.effects.push_back(cogging);
  const auto name = NameOn(truth);
  EXPECT_FALSE(name) << name->form.effect;
}

/// The first goes before the second though it explains less, and gives way beyond chance only.
void ExpectGivesWayOnlyBeyondChance(const std::string& first, const std::string& second) {
  const FitData data = Record(Declared());
  const auto problem = ProblemOf(data, Declared());
  Candidate preferred, other;
  preferred.effect = preferred.params.name = first;
  other.effect = other.params.name = second;
  FitResult better, worse;
  better.values = worse.values = {1};
  better.score = 100, worse.score = 105;
  const auto beats = [&](const Candidate& a, const FitResult& fa, const Candidate& b,
                         const FitResult& fb) { return Beats(problem.value(), a, fa, b, fb); };
  EXPECT_FALSE(beats(other, better, preferred, worse)) << "5 of 2 ln L may be chance";
  EXPECT_TRUE(beats(preferred, worse, other, better));
  worse.score = 120;
  EXPECT_TRUE(beats(other, better, preferred, worse));
  EXPECT_FALSE(beats(preferred, worse, other, better));
  EXPECT_TRUE(beats(preferred, better, preferred, worse));
}

TEST(ListedName, AnInstrumentGoesFirstOnlyBeyondChance) {
  ExpectGivesWayOnlyBeyondChance("external_leakage", "sensor_drift");
}

TEST(ListedName, ASpecialCaseGivesWayToWhatContainsItOnlyBeyondChance) {
  ExpectGivesWayOnlyBeyondChance("line_resistance", "check_restriction");
}

/// A search that has found this formula.
std::vector<std::string> DrivesWith(const std::string& formula, const std::string& unit,
                                    double value, std::vector<std::string> targets) {
  const FitData data = Record(Declared());
  const auto problem = ProblemOf(data, Declared());
  Identification found;
  found.formula.text = formula, found.formula.unit = unit, found.formula.targets = targets;
  found.formula.terms.emplace_back(), found.formula.coefficients = {value};
  found.declared = problem.value().forward().Declared(Declared());
  for (const auto& p : found.declared.free) found.after.values.push_back(p.start);
  found.corrected = WithCandidate(found.declared, FormulaCandidate(found.formula, 1e5));
  found.after.values.push_back(value);
  return WhatDrives(problem.value(), found);
}

TEST(Passivity, AFormulaThatTurnsTheFrictionDrives) {
  EXPECT_TRUE(DrivesWith("c1*s", "N", 200, {}).empty());
  EXPECT_TRUE(DrivesWith("c1*s", "N", -50, {}).empty()) << "less friction still rubs";
  EXPECT_THAT(DrivesWith("c1*s", "N", -9e3, {}),
              testing::ElementsAre(testing::HasSubstr("drives: with it the friction gives out")));
  EXPECT_THAT(DrivesWith("c1*s*(v/0.001[m/s])", "N", -5e3, {}).size(), 1u);
  EXPECT_TRUE(DrivesWith("c1*(x/0.001[m])", "N", -3e3, {}).empty()) << "a spring gives it back";
}

TEST(Passivity, AFlowAgainstItsPressureDrives) {
  EXPECT_TRUE(DrivesWith("c1*(p/1e6[Pa])", "m3_per_s", 1e-9, {"L1"}).empty());
  EXPECT_THAT(DrivesWith("c1*(p/1e6[Pa])", "m3_per_s", -1e-9, {"L1"}),
              testing::ElementsAre(testing::HasSubstr("the flow c1*(p/1e6[Pa]) drives")));
  for (const double sign : {1, -1}) {
    EXPECT_TRUE(DrivesWith("c1*sin(2*pi*t/7[s])", "m3_per_s", sign * 1e-6, {"L1"}).empty())
        << "time drives it, which is said by its variable";
  }
}

}  // namespace
}  // namespace phs::identify::search
