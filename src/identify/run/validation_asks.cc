#include "identify/run/validation_asks.h"

#include <utility>

#include "identify/result/element_result.h"
#include "identify/result/result_json.h"

namespace phs::identify::element {

using hydraulics::PhsParams;
using search::FitProblem;
using search::FitResult;
using search::FreeModel;
using search::FreeParameter;
using search::Identification;
using search::SearchOptions;
using json = nlohmann::ordered_json;

std::optional<Asked> AskValidation(const ElementData& data, const FreeModel& corrected,
                                   const FitResult& fit, const PhsParams& params,
                                   const SearchOptions& options) {
  ElementData turned = data;
  for (ElementRecord& r : turned.records) {
    std::swap(r.fitted, r.scored), std::swap(r.estimation, r.validation);
  }
  std::vector<std::string> names;
  for (const FreeParameter& p : corrected.free) names.push_back(p.name);
  auto bench = BenchForward::Create(turned, params, names);
  if (!bench.ok()) return {};
  Result<FitProblem> problem = FitProblem::Create(bench.value(), params, options.rule);
  if (!problem.ok()) return {};
  SearchOptions few = options;
  few.effort.max_effects = 2;
  Result<Identification> found = Identify(&problem.value(), params, few, nullptr);
  if (!found.ok()) return {};
  Asked out{std::move(found).value(), {}, {}, {}};
  const Identification& f = out.found;
  out.estimated.assign(fit.values.begin(), fit.values.begin() + static_cast<long>(names.size()));
  const auto rows = bench.value()->Predict(problem.value().Params(f.declared, f.before.values));
  const auto more = bench.value()->Predict(problem.value().Params(f.corrected, f.after.values));
  if (rows.ok()) {
    out.relative_percent_refitted = ScoreRows(turned, rows.value(), true).relative_percent;
  }
  if (more.ok()) {
    out.relative_percent_with_effects = ScoreRows(turned, more.value(), true).relative_percent;
  }
  return out;
}

json AskedJson(const std::optional<Asked>& asked) {
  if (!asked) return nullptr;
  const Identification& f = asked->found;
  json refitted = search::Parameters(f.declared, f.before, 0, f.declared.free.size(), true);
  for (size_t i = 0; i < asked->estimated.size(); ++i) {
    refitted[f.declared.free[i].name]["estimation"] = asked->estimated[i];
  }
  json out = {{"refitted", refitted},
              {"effects", search::EffectList(f)},
              {"formula", search::OrNull(FormulaText(f))}};
  if (asked->relative_percent_refitted) {
    out["relative_percent_refitted"] = *asked->relative_percent_refitted;
  }
  if (asked->relative_percent_with_effects) {
    out["relative_percent_with_effects"] = *asked->relative_percent_with_effects;
  }
  return out;
}

void AddAsked(const std::optional<Asked>& asked, json* tests) {
  if (!asked) return;
  for (const search::AcceptedEffect& effect : asked->found.effects) {
    tests->push_back(effect.candidate.effect +
                     ": only the validation record asks for it; take a record of that kind into "
                     "the estimation");
  }
}

}  // namespace phs::identify::element
