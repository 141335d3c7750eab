// A formula beside a listed effect: its form, or a cause of its own.
#include "identify/select/own_form.h"

#include "identify/result/result_json.h"
#include "phs_model/phs_model.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

AcceptedEffect EffectOf(const std::string& name, double delta_bic,
                        std::vector<std::string> targets = {}) {
  AcceptedEffect effect;
  effect.candidate.effect = effect.candidate.params.name = name;
  effect.candidate.params.targets = std::move(targets);
  effect.evidence.delta_bic = delta_bic;
  return effect;
}

FoundFormula FormulaOver(const std::string& text, const std::string& unit,
                         std::vector<std::string> targets = {}) {
  FoundFormula formula;
  formula.text = text, formula.unit = unit, formula.targets = std::move(targets);
  formula.terms = {{text, "", 50, 0.2}};
  formula.coefficients = {1};
  return formula;
}

/// The quarter rig with these effects and a formula of delta BIC 100.
Identification With(std::vector<AcceptedEffect> effects, FoundFormula formula) {
  Identification found;
  found.corrected.params = Declared();
  found.effects = std::move(effects);
  found.effects.push_back(EffectOf("unlisted", 100, formula.targets));
  found.formula = std::move(formula);
  return found;
}

TEST(OwnForm, AFormulaOverNoMoreThanTheLawIsItsForm) {
  EXPECT_EQ(HasOwnForm(With({EffectOf("mount_compliance", 900), EffectOf("stribeck", 300)},
                            FormulaOver("c1*(v/0.02[m/s])", "N"))),
            1u);
  EXPECT_EQ(HasOwnForm(With({EffectOf("position_friction", 300)},
                            FormulaOver("c1*s*sin(2*pi*x/0.001[m])", "N"))),
            0u);
  EXPECT_EQ(HasOwnForm(With({EffectOf("pressure_area", 300, {"L2"})},
                            FormulaOver("c1*(p/1e7[Pa])^2", "N"))),
            0u);
}

TEST(OwnForm, AFormulaOverAnotherVariableIsACauseOfItsOwn) {
  EXPECT_FALSE(
      HasOwnForm(With({EffectOf("stribeck", 300)}, FormulaOver("c1*s*(x/0.005[m])", "N"))));
  EXPECT_FALSE(HasOwnForm(
      With({EffectOf("hose_expansion", 300)}, FormulaOver("c1*(p/1e7[Pa])", "m3_per_s", {"L1"}))));
  EXPECT_FALSE(HasOwnForm(With({EffectOf("backlash", 300)}, FormulaOver("c1*(x/0.005[m])", "N"))));
}

TEST(OwnForm, AFormulaThatWeighsMoreIsACauseOfItsOwnWhereSeveralLawsAreOverIt) {
  EXPECT_FALSE(HasOwnForm(With({EffectOf("stribeck", 99)}, FormulaOver("c1*(v/0.02[m/s])", "N"))));
  EXPECT_FALSE(HasOwnForm(
      With({EffectOf("hose_expansion", 99)}, FormulaOver("c1*(p/1e7[Pa])^2", "m3", {"L2"}))));
}

/// Friction in waves over the position, and of a slope that weighs less: one law is over both.
TEST(OwnForm, AFormulaThatWeighsMoreIsTheFormOfTheOneLawThatIsOverIt) {
  EXPECT_EQ(HasOwnForm(With({EffectOf("position_friction", 99)},
                            FormulaOver("c1*s*sin(2*pi*x/0.001[m])", "N"))),
            0u);
}

TEST(OwnForm, AFormulaOfOilActsWhereItsEffectDoes) {
  const FoundFormula volume = FormulaOver("c1*(p/1e7[Pa])^2", "m3", {"L2"});
  EXPECT_EQ(HasOwnForm(With({EffectOf("hose_expansion", 300, {"L2"})}, volume)), 0u);
  EXPECT_EQ(HasOwnForm(With({EffectOf("hose_expansion", 300)}, volume)), 0u) << "in all lines";
  EXPECT_FALSE(HasOwnForm(With({EffectOf("hose_expansion", 300, {"L1"})}, volume)));
  const FoundFormula past = FormulaOver("c1*(p/1e7[Pa])^2", "m3_per_s", {"1"});
  EXPECT_EQ(HasOwnForm(With({EffectOf("piston_leakage", 300)}, past)), 0u);
  EXPECT_FALSE(HasOwnForm(With({EffectOf("external_leakage", 300)}, past)));
}

/// A gauge errs over its own pressure: its gain in another form. Of another gauge it is not.
TEST(OwnForm, AReadingOverItsPressureIsTheFormOfItsGain) {
  const FoundFormula reading = FormulaOver("c1*(max(p-1e6[Pa],0[Pa])/1e7[Pa])^2", "Pa", {"L2"});
  Identification found = With({EffectOf("sensor_gain", 50)}, reading);
  EXPECT_EQ(HasOwnForm(found), 0u);
  found.effects[0].evidence.best_channel = "p_rod_Pa";
  EXPECT_FALSE(HasOwnForm(found));
}

/// Oil that leaves a line by its pressure, or passes the piston: each is of one law alone.
TEST(OwnForm, AFlowThatWeighsMoreIsTheFormOfTheLeakWhereItFlows) {
  const FoundFormula out = FormulaOver("c1*(p/1e7[Pa])^2", "m3_per_s", {"L2"});
  EXPECT_EQ(HasOwnForm(With({EffectOf("external_leakage", 50, {"L2"})}, out)), 0u);
  EXPECT_FALSE(HasOwnForm(With({EffectOf("piston_leakage", 50)}, out)));
}

// What begins nowhere is no form of a valve that opens; what feeds below a pressure is.
TEST(OwnForm, AFeedBelowAPressureIsTheFormOfAValveThatFeeds) {
  const auto over = [](const std::string& text) {
    return HasOwnForm(
        With({EffectOf("makeup_valve", 300, {"L2"})}, FormulaOver(text, "m3_per_s", {"L2"})));
  };
  EXPECT_EQ(over("c1*(max(-p-8e5[Pa],0[Pa])/1e6[Pa])^2"), 0u);
  EXPECT_FALSE(over("c1*(p/1e7[Pa])^2")) << "a leak beside it";
}

/// What surrounds the rig acts on every line: a heater that is switched on and off is no sine.
TEST(OwnForm, AFlowOverTimeBesideAWarmingIsItsForm) {
  const auto over = [](const std::string& text, const std::string& unit) {
    return HasOwnForm(With({EffectOf("temperature_drift", 300)}, FormulaOver(text, unit, {"L1"})));
  };
  EXPECT_EQ(over("c1*sin(2*pi*t/11[s])", "m3_per_s"), 0u);
  EXPECT_FALSE(over("c1*(p/1e7[Pa])", "m3_per_s")) << "a leak beside it";
  EXPECT_FALSE(over("c1*sin(2*pi*t/11[s])", "Pa")) << "a gauge beside it";
}

TEST(OwnForm, IsSaidInsideItsEffect) {
  Identification found = With({EffectOf("stribeck", 300)}, FormulaOver("c1*(v/0.02[m/s])", "N"));
  const auto number = [&](size_t effect, const std::string& name, double value) {
    FreeParameter p;
    p.name = "effects." + found.effects[effect].candidate.effect + "." + name;
    found.effects[effect].candidate.free.push_back(p);
    found.corrected.free.push_back(p);
    found.after.values.push_back(value), found.after.half_95.push_back(0.1);
  };
  number(0, "extra_N", 200), number(1, "c1_N", -30);
  const Json list = EffectList(found);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0]["name"], "stribeck");
  EXPECT_EQ(list[0]["form"]["formula"], "c1*(v/0.02[m/s])");
  EXPECT_EQ(list[0]["form"]["parameters"]["c1_N"]["value"], -30);
  ASSERT_EQ(NamedEffects(found).size(), 1u);
  EXPECT_EQ(NamedEffects(found)[0].own_form, "c1*(v/0.02[m/s])");
}

}  // namespace
}  // namespace phs::identify::search
