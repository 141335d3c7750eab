#include "effects/unlisted.h"

#include <algorithm>
#include <optional>

#include "effects/formula_laws.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

constexpr int kCoefficients = kFormulaCoefficients;
constexpr FormulaUnit kUnits[] = {FormulaUnit::kForce, FormulaUnit::kVolume, FormulaUnit::kFlow,
                                  FormulaUnit::kLength, FormulaUnit::kPressure};

std::string CoefficientName(int k, FormulaUnit unit) {
  return "c" + std::to_string(k) + "_" + UnitSuffix(unit);
}

/// The unit whose coefficients are given; nothing where all are zero.
Result<std::optional<FormulaUnit>> UnitOf(const EffectParams& effect) {
  std::optional<FormulaUnit> unit;
  for (const FormulaUnit candidate : kUnits) {
    bool given = false;
    for (int k = 1; k <= kCoefficients; ++k) {
      const auto value = effect.values.find(CoefficientName(k, candidate));
      given |= value != effect.values.end() && value->second != 0;
    }
    if (!given) continue;
    if (unit)
      return RefuseEffect(effect, "coefficients of two units", "one unit: c1_N … or c1_m3 …");
    unit = candidate;
  }
  return unit;
}

Result<Formula> FormulaOf(const EffectParams& effect, FormulaUnit unit) {
  std::map<std::string, double> coefficients;
  for (int k = 1; k <= kCoefficients; ++k) {
    const auto value = effect.values.find(CoefficientName(k, unit));
    coefficients["c" + std::to_string(k)] = value == effect.values.end() ? 0 : value->second;
  }
  Result<Formula> formula = Formula::Parse(effect.formula, coefficients, unit);
  if (formula.ok()) return formula;
  Error error = formula.error();
  error.where = "effects." + effect.name + "." + error.where;
  return error;
}

/// No force depends on itself: over F it is what the load cell shows.
bool IsReading(const Formula& formula) { return formula.Uses("F"); }

/// How many formulas give a force on a cylinder.
long ForcesOn(int cylinder, const hydraulics::PhsParams& params) {
  return std::count_if(params.effects.begin(), params.effects.end(), [&](const auto& other) {
    if (other.name != UnlistedInfo().name) return false;
    const auto unit = UnitOf(other);
    const std::vector<int> targets = TargetCylinders(other, params);
    if (!unit.ok() || unit.value() != FormulaUnit::kForce) return false;
    const Result<Formula> formula = FormulaOf(other, FormulaUnit::kForce);
    return formula.ok() && !IsReading(formula.value()) &&
           std::find(targets.begin(), targets.end(), cylinder) != targets.end();
  });
}

Status AddForce(const EffectParams& effect, const Formula& formula, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    if (i < 0) return RefuseEffect(effect, "a force acts on cylinders, not on lines", "cylinders");
    if (ForcesOn(i, extension->params()) > 1) {
      return RefuseEffect(effect, "a second formula on one cylinder", "one");
    }
    AddForceTo(i, formula, extension);
  }
  return {};
}

/// A law whose coefficients are all zero (a fit passes there) does nothing, wherever it acts; it
/// must still be one.
Status CheckWithoutAmount(const EffectParams& effect) {
  Result<Formula> as_force = FormulaOf(effect, FormulaUnit::kForce);
  for (const FormulaUnit unit : kUnits) {
    if (FormulaOf(effect, unit).ok()) return {};
  }
  return as_force.error();
}

Status InstallUnlisted(const EffectParams& effect, Extension* extension) {
  const auto given = UnitOf(effect);
  if (!given.ok()) return given.error();
  if (!given.value()) return CheckWithoutAmount(effect);
  const FormulaUnit unit = *given.value();
  const Result<Formula> formula = FormulaOf(effect, unit);
  if (!formula.ok()) return formula.error();
  switch (unit) {
    case FormulaUnit::kForce:
      if (IsReading(formula.value())) return AddReading(effect, formula.value(), unit, extension);
      return AddForce(effect, formula.value(), extension);
    case FormulaUnit::kVolume:
      return AddVolume(effect, formula.value(), extension);
    case FormulaUnit::kFlow:
      return AddFlow(effect, formula.value(), extension);
    case FormulaUnit::kLength:
    case FormulaUnit::kPressure:
      return AddReading(effect, formula.value(), unit, extension);
  }
  return {};
}

std::vector<hydraulics::EffectParameter> Parameters() {
  struct Row {
    FormulaUnit unit;
    const char* text;
    double most, plausible;
  };
  constexpr Row kRows[] = {{FormulaUnit::kForce, "N", 1e9, 1e5},
                           {FormulaUnit::kVolume, "m3", 1, 1e-4},
                           {FormulaUnit::kFlow, "m3/s", 1, 1e-4},
                           {FormulaUnit::kLength, "m", 1, 1e-2},
                           {FormulaUnit::kPressure, "Pa", 1e9, 1e7}};
  std::vector<hydraulics::EffectParameter> out;
  for (const Row& row : kRows) {
    for (int k = 1; k <= kCoefficients; ++k) {
      out.push_back({CoefficientName(k, row.unit), row.text, 0, -row.most, row.most, -row.plausible,
                     row.plausible, "coefficient"});
    }
  }
  return out;
}

}  // namespace

const EffectInfo& UnlistedInfo() {
  static const EffectInfo info = {"unlisted",
                                  "unlisted",
                                  "cylinders or lines",
                                  "a law by formula",
                                  Parameters(),
                                  InstallUnlisted,
                                  {},
                                  true};
  return info;
}

bool ActsOnOil(const hydraulics::EffectParams& effect) {
  return std::any_of(effect.values.begin(), effect.values.end(), [](const auto& value) {
    return value.second != 0 &&
           (value.first.ends_with("_m3") || value.first.ends_with("_m3_per_s"));
  });
}

}  // namespace phs::effects
