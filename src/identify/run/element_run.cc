#include "identify/run/element_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/words.h"
#include "effects/unlisted.h"
#include "identify/models/bench_runs.h"
#include "identify/models/own_candidates.h"
#include "identify/next_test/next_test.h"
#include "identify/result/element_result.h"
#include "identify/result/result_json.h"
#include "identify/run/bench_checks.h"
#include "identify/run/validation_asks.h"
#include "identify/select/passivity.h"
#include "phs_model/phs_model.h"

namespace phs::identify::element {

using measurement::Manifest;
namespace {

using hydraulics::PhsParams;
using search::FitProblem;
using search::Identification;
using search::SearchOptions;
using json = nlohmann::ordered_json;
using search::IdentifyOutcome;

constexpr double kLast = 0.99;  // of the work

json BenchHead(const Manifest& manifest, const ElementData& data) {
  json sources = json::array();
  for (const ElementRecord& r : data.records) sources.push_back(r.source);
  json head = {{"rig", manifest.rig},
               {"declared", manifest.model},
               {"data", data.records.size() == 1 ? sources[0] : sources},
               {"noise",
                {{"x_m", data.position_noise_m},
                 {"force_N", data.by_force ? data.force_noise_N : data.noise}}},
               {"data_findings", search::FindingList(data.findings)}};
  if (data.compare_below_Hz > 0) head["compare_below_Hz"] = data.compare_below_Hz;
  if (data.records.size() == 1) {
    const ElementRecord& r = data.records[0];
    head["estimation"] = {r.estimation.begin, r.estimation.end};
    head["validation"] = {r.validation.begin, r.validation.end};
  }
  return head;
}

search::TestRig TestRigOf(const Manifest& manifest, const ElementData& data) {
  search::Channels positions, speeds;
  std::vector<double> forces;
  for (const ElementRecord& r : data.records) {
    positions.push_back(r.motion.position_m[0]), speeds.push_back(r.motion.speed_m_s[0]);
    forces.insert(forces.end(), r.force_N.begin(), r.force_N.end());
  }
  return search::MakeTestRig(manifest.limits, {"x_m"}, data.records.front().motion.step_s,
                             positions, speeds, forces, std::numeric_limits<double>::infinity());
}

std::string UnitOf(const std::string& channel) { return channel.substr(channel.rfind('_') + 1); }

std::string BenchSummary(const json& result) {
  std::string out = search::FindingLines(result) + search::VerdictLines(result);
  for (const json& e : result["effects"]) out += search::EffectLine(e);
  for (const char* key : {"channels_estimation", "channels"}) {
    const auto [channel, s] = *result[key].items().begin();
    out += fmt::format("{} {:10} rmse {:.4g} -> {:.4g} {}  relative {:.3f} -> {:.3f} %\n", channel,
                       std::string(key) == "channels" ? "validation" : "estimation",
                       s["before"]["rmse"].get<double>(), s["after"]["rmse"].get<double>(),
                       UnitOf(channel), s["before"]["relative_percent"].get<double>(),
                       s["after"]["relative_percent"].get<double>());
  }
  out += search::NextTestLines(result);
  const json& left = result["unexplained"];
  out += fmt::format("unexplained: {:.2f} times its noise and uncertainty",
                     left["residual_over_noise"].get<double>());
  if (!left["depends_on"].empty()) {
    out += ", depends on " + JoinWords(left["depends_on"].get<std::vector<std::string>>());
  }
  out += "\n";
  if (result["validation_asks_for"].is_object()) {
    for (const json& e : result["validation_asks_for"]["effects"]) {
      out += "the validation record also asks for " + e["name"].get<std::string>();
      if (e.contains("formula")) out += ": " + e["formula"].get<std::string>();
      out += "\n";
    }
  }
  return out;
}

Status WriteFiles(const ElementData& data, const Rows* before, const Rows& after,
                  const std::vector<PhsParams>& models, const json& result, const ResultDir& dir) {
  if (Status s = WriteRows(dir.File("measured.csv"), data, nullptr); !s.ok()) return s;
  if (Status s = WriteRows(dir.File("predicted.csv"), data, &after); !s.ok()) return s;
  if (before != nullptr) {
    if (Status s = WriteRows(dir.File("baseline.csv"), data, before); !s.ok()) return s;
  }
  for (size_t r = 0; r < models.size(); ++r) {
    const std::string file = r == 0 ? "model.yaml" : fmt::format("model_{}.yaml", r + 1);
    Status s = WriteFileAtomically(dir.File(file), phs_model::ToYaml(models[r]));
    if (!s.ok()) return s;
  }
  return WriteFileAtomically(dir.File("result.json"), result.dump(1) + "\n");
}

std::vector<PhsParams> CorrectedModels(const ElementData& data, const BenchRuns& bench,
                                       const PhsParams& corrected) {
  std::vector<PhsParams> models = bench.Models(corrected);
  for (size_t r = 0; r < models.size(); ++r) {
    models[r].description =
        "Identified from " + data.records[r].source + "; declared " + models[r].name;
    models[r].name += "_identified";
  }
  return models;
}

/// Errors and residuals of both models.
struct BenchFindings {
  RowScore estimation_before, estimation_after, before, after;
  RowMap map_before;                     ///< in the estimation windows
  RowMap map_after;                      ///< in the validation windows
  LeftOver fitted_before, fitted_after;  ///< in the estimation windows
  LeftOver left_before, left_after;
};

BenchFindings Look(const ElementData& data, const Rows& before, const Rows& after,
                   const Rows& uncertain) {
  return {ScoreRows(data, before, true),
          ScoreRows(data, after, true),
          ScoreRows(data, before, false),
          ScoreRows(data, after, false),
          MapRows(data, before, uncertain, true),
          MapRows(data, after, uncertain, false),
          LeftOfRows(data, before, uncertain, true),
          LeftOfRows(data, after, uncertain, true),
          LeftOfRows(data, before, uncertain, false),
          LeftOfRows(data, after, uncertain, false)};
}

Unexplained UnexplainedOf(const BenchFindings& f, const Identification& found) {
  return {.channel = f.map_after.channel,
          .nrmse = f.after.score.nrmse,
          .whiteness_p = f.map_after.whiteness_p,
          .over_noise = f.map_after.over_noise,
          .following_over_noise = std::sqrt(f.left_after.following),
          .depends_on = f.map_after.depends_on,
          .formula = FormulaText(found)};
}

VerdictFacts FactsOf(const BenchFindings& f, const FitProblem& problem, const Identification& found,
                     std::vector<std::string> faults, std::vector<std::string>* drives) {
  *drives = search::WhatDrives(problem, found);
  faults.insert(faults.end(), drives->begin(), drives->end());
  const std::string& channel = f.map_after.channel;
  return {BothWindows({{channel, f.left_before.over_noise, f.map_after.over_noise,
                        f.after.score.nrmse, f.left_after.following, f.left_after.comes_and_goes}},
                      {{channel, f.fitted_before.over_noise, f.fitted_after.over_noise,
                        f.estimation_after.score.nrmse, f.fitted_after.following,
                        f.fitted_after.comes_and_goes}}),
          search::NamedEffects(found),
          search::FittedNumbers(found),
          std::move(faults),
          !found.candidates.empty(),
          search::WouldExplain(found)};
}

/// result.json up to the verdict. `faults`: of the data.
json Describe(const Manifest& manifest, const ElementData& data, const FitProblem& problem,
              const Identification& found, const BenchFindings& f, const Unexplained& left,
              std::vector<std::string> faults) {
  json result = BenchHead(manifest, data);
  result["channels_estimation"][data.compared] = {{"before", ToJson(f.estimation_before)},
                                                  {"after", ToJson(f.estimation_after)}};
  result["channels"][data.compared] = {{"before", ToJson(f.before)}, {"after", ToJson(f.after)}};
  const size_t declared = found.declared.free.size();
  result["effects"] = search::EffectList(found);
  result["fitted"] = search::Parameters(found.corrected, found.after, 0, declared, true);
  result["fitted_before"] = search::Parameters(found.declared, found.before, 0, declared, true);
  result["localised"] = ToJson(f.map_before);
  result["unexplained"] = ToJson(f.map_after);
  result["unexplained"]["nrmse"] = left.nrmse;
  result["unexplained"]["following_over_noise"] = left.following_over_noise;
  result["unexplained"]["formula"] = search::OrNull(left.formula);
  std::vector<std::string> drives;
  const VerdictFacts facts = FactsOf(f, problem, found, std::move(faults), &drives);
  result["drives"] = drives;
  search::PutVerdict(facts, &result);
  return result;
}

SearchOptions ForBench(const SearchOptions& options, const ElementData& data,
                       const std::vector<std::string>& faults) {
  SearchOptions asked = options;
  const auto& named = data.candidates;
  asked.formula = named.empty() || std::find(named.begin(), named.end(),
                                             effects::UnlistedInfo().name) != named.end();
  asked.effort.unpromising = !named.empty();  // what is named is tried
  if (!faults.empty()) asked.effort.max_effects = 0, asked.formula = false;  // nothing to explain
  return asked;
}

}  // namespace

Result<IdentifyOutcome> RunElementIdentify(const Manifest& manifest, const SearchOptions& options,
                                           const search::Progress& progress, const ResultDir& dir) {
  Result<PhsParams> declared = measurement::DeclaredModel(manifest);
  if (!declared.ok()) return declared.error();
  Result<ElementData> data = ReadElementData(manifest);
  if (!data.ok()) return data.error();
  for (const Status& s :
       {search::CheckAsked(manifest.candidates, ElementCandidateNames(), "a bench"),
        search::CheckOwnCandidates(data.value().own, declared.value(), rigs::RigKind::kElement,
                                   manifest.options)}) {
    if (!s.ok()) return s.error();
  }
  auto runs = BenchRuns::Create(manifest, data.value(), declared.value());
  if (!runs.ok()) return runs.error();
  const BenchRuns& bench = *runs.value();
  Result<FitProblem> made = FitProblem::Create(bench.forward(), bench.declared(), options.rule);
  if (!made.ok()) return made.error();
  FitProblem& problem = made.value();
  std::vector<std::string> faults = FindFaults(manifest, data.value(), declared.value());
  if (faults.empty() && data.value().too_fast) return *data.value().too_fast;
  Result<Identification> searched =
      Identify(&problem, bench.declared(), ForBench(options, data.value(), faults), progress);
  if (!searched.ok()) return searched.error();
  const Identification& found = searched.value();
  IdentifyOutcome outcome;
  outcome.cancelled = found.cancelled;
  if (found.cancelled) return outcome;
  if (const auto unit = FindSwallowedUnit(search::FittedNumbers(found))) faults.push_back(*unit);
  const Result<Rows> before = bench.Predict(problem.Params(found.declared, found.before.values));
  const PhsParams corrected = problem.Params(found.corrected, found.after.values);
  const Result<Rows> after = bench.Predict(corrected);
  if (!before.ok()) return before.error();
  if (!after.ok()) return after.error();
  const Result<Rows> uncertain = bench.Uncertain(corrected);
  if (!uncertain.ok()) return uncertain.error();
  json& result = outcome.result;
  const BenchFindings findings =
      Look(data.value(), before.value(), after.value(), uncertain.value());
  const Unexplained left = UnexplainedOf(findings, found);
  result = Describe(manifest, data.value(), problem, found, findings, left, faults);
  search::PutRule(options.rule, &result);
  std::optional<Asked> asks;
  if (!bench.own() && faults.empty()) {
    asks = AskValidation(data.value(), found.corrected, found.after, corrected, options);
  }
  result["validation_asks_for"] = AskedJson(asks);
  const Status tested = faults.empty()
                            ? search::PutNextTest(
                                  problem, found, left, TestRigOf(manifest, data.value()), options,
                                  [&] { return !progress || progress(kLast); }, dir, &result)
                            : search::PutRecordFirst(&result);
  if (!tested.ok()) return tested.error();
  if (outcome.cancelled = progress && !progress(kLast); outcome.cancelled) return outcome;
  AddAsked(asks, &result["next_test"]);
  result["candidates"] = search::CandidateList(found);
  result["model"] = "model.yaml";
  const Status written = WriteFiles(data.value(), &before.value(), after.value(),
                                    CorrectedModels(data.value(), bench, corrected), result, dir);
  if (!written.ok()) return written.error();
  outcome.summary = BenchSummary(result);
  return outcome;
}

Result<IdentifyOutcome> RunElementRig(const Manifest& manifest, const ResultDir& dir) {
  Result<PhsParams> declared = measurement::DeclaredModel(manifest);
  if (!declared.ok()) return declared.error();
  Result<ElementData> data = ReadElementData(manifest);
  if (!data.ok()) return data.error();
  auto bench = BenchForward::Create(data.value(), declared.value(), {});
  if (!bench.ok()) return bench.error();
  const Result<Rows> rows = bench.value()->Predict(declared.value());
  if (!rows.ok()) return rows.error();
  IdentifyOutcome outcome;
  outcome.result = BenchHead(manifest, data.value());
  const RowScore score = ScoreRows(data.value(), rows.value(), false);
  const std::string& channel = data.value().compared;
  outcome.result["channels"][channel] = ToJson(score);
  outcome.result["channels_estimation"][channel] =
      ToJson(ScoreRows(data.value(), rows.value(), true));
  outcome.summary =
      fmt::format("{}  validation rmse {:.4g} {}  nrmse {:.4f}  relative {:.3f} %\n", channel,
                  score.score.rmse, UnitOf(channel), score.score.nrmse, score.relative_percent);
  if (Status s = WriteFiles(data.value(), nullptr, rows.value(), {}, outcome.result, dir);
      !s.ok()) {
    return s.error();
  }
  return outcome;
}

}  // namespace phs::identify::element
