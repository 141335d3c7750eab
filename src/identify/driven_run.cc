#include "identify/driven_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/table.h"
#include "identify/result_json.h"
#include "measurement/data_checks.h"
#include "measurement/fit_run.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

using measurement::FitData;
using measurement::InputIsSwapped;
using measurement::LeaveOutBelowVacuum;
using measurement::Manifest;
using measurement::MeasuredChannel;
using measurement::MendOutputs;
using measurement::ReadFitData;
using measurement::SmoothMotion;
namespace {

using hydraulics::PhsParams;

/// Data and declared model of a manifest, checked against each other.
struct Case {
  FitData data;
  PhsParams declared;
};

/// Outputs as the declared model predicts them.
Result<Channels> Predict(const FitData& data, const PhsParams& params) {
  Result<FitProblem> problem = FitProblem::Create(data, params);
  if (!problem.ok()) return problem.error();
  return problem.value().Predict(params);
}

void TurnInput(FitData* data) {
  for (size_t a = 0; a < data->inputs.size(); ++a) {
    for (double& x : data->inputs[a].values) x = -x;
    SmoothMotion& motion = data->motion[a];
    for (auto* row : {&motion.position, &motion.speed, &motion.acceleration}) {
      for (double& x : *row) x = -x;
    }
    data->findings.push_back(
        {data->inputs[a].name, "every output runs against the model: its sign is swapped"});
  }
}

Status CheckCandidates(const std::vector<std::string>& asked) {
  const std::vector<std::string> known = CandidateNames();
  for (const std::string& name : asked) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    return Error{"candidates: " + name, "is no effect that a rig is searched for", JoinWords(known),
                 DidYouMean(name, known)};
  }
  return {};
}

Result<Case> LoadCase(const Manifest& manifest) {
  if (Status s = CheckCandidates(manifest.candidates); !s.ok()) return s.error();
  Result<PhsParams> declared = phs_model::FindPhsParams(manifest.model);
  if (!declared.ok()) return declared.error();
  if (Status s = CheckFree(declared.value(), manifest.free); !s.ok()) return s.error();
  Result<FitData> read = ReadFitData(manifest, declared.value());
  if (!read.ok()) return read.error();
  Case c{std::move(read.value()), std::move(declared.value())};
  Result<Channels> predicted = Predict(c.data, c.declared);
  if (!predicted.ok()) return predicted.error();
  if (InputIsSwapped(c.data, predicted.value())) {
    TurnInput(&c.data);
    predicted = Predict(c.data, c.declared);
    if (!predicted.ok()) return predicted.error();
  }
  MendOutputs(predicted.value(), &c.data);
  LeaveOutBelowVacuum(&c.data);
  return c;
}

/// A column on the uniform clock, at the times of the file's rows.
std::vector<double> AtRows(const FitData& data, const std::vector<double>& y) {
  if (data.row_time_s.empty()) return y;
  std::vector<double> out;
  const double last = static_cast<double>(y.size()) - 1;
  for (const double t : data.row_time_s) {
    const double at = std::clamp((t - data.time_s.front()) / data.step_s, 0.0, last);
    const auto k = static_cast<size_t>(at + 1e-6);
    const double part = at - static_cast<double>(k);
    out.push_back(part > 1e-6 && k + 1 < y.size() ? y[k] + part * (y[k + 1] - y[k]) : y[k]);
  }
  return out;
}

}  // namespace

Status WriteChannels(const ResultDir& dir, const std::string& file, const FitData& data,
                     const Channels& outputs) {
  std::vector<std::string> names = {"t_s"};
  Channels columns = {data.row_time_s.empty() ? data.time_s : data.row_time_s};
  for (size_t a = 0; a < data.inputs.size(); ++a) {
    names.push_back(data.inputs[a].name), columns.push_back(AtRows(data, data.motion[a].position));
  }
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    names.push_back(data.outputs[c].name), columns.push_back(AtRows(data, outputs[c]));
  }
  return WriteCsv(dir.File(file), names, columns);
}

Status WriteMeasured(const ResultDir& dir, const FitData& data) {
  Channels outputs;
  for (const MeasuredChannel& c : data.outputs) outputs.push_back(c.values);
  return WriteChannels(dir, "measured.csv", data, outputs);
}

Json Head(const Manifest& manifest, const FitData& data) {
  return {{"rig", manifest.rig},
          {"declared", manifest.model},
          {"data", data.source},
          {"estimation", data.estimation},
          {"validation", data.validation},
          {"noise", NoiseLevels(data)},
          {"data_findings", FindingList(data.findings)}};
}

Result<IdentifyOutcome> SearchAndWrite(const Manifest& manifest, const PhsParams& declared,
                                       FitProblem* problem, const SearchOptions& options,
                                       const Progress& progress, const WriteModel& write_model,
                                       const ResultDir& dir) {
  const FitData& data = problem->data();
  Result<Identification> search = Identify(problem, declared, options, progress);
  if (!search.ok()) return search.error();
  const Identification& found = search.value();
  IdentifyOutcome outcome;
  outcome.cancelled = found.cancelled;
  if (found.cancelled) return outcome;
  const PhsParams corrected = problem->Params(found.corrected, found.after.values);
  Result<Channels> before = problem->Predict(problem->Params(found.declared, found.before.values));
  Result<Channels> after = problem->Predict(corrected);
  if (!before.ok()) return before.error();
  if (!after.ok()) return after.error();
  const Result<std::vector<double>> over_noise =
      problem->OverNoise(corrected, after.value(), data.validation);
  if (!over_noise.ok()) return over_noise.error();
  Json& result = outcome.result;
  result = Head(manifest, data);
  result["channels"] = ScoreBoth(data, before.value(), after.value(), data.validation);
  result["channels_estimation"] = ScoreBoth(data, before.value(), after.value(), data.estimation);
  result["effects"] = EffectList(found);
  result["fitted"] = Parameters(found.corrected, found.after, 0, found.declared.free.size(), true);
  result["localised"] = Localise(data, before.value(), found.before);
  result["unexplained"] = Unexplained(data, after.value(), over_noise.value(), found);
  result["next_test"] = NextTests(found, result["unexplained"]);
  result["candidates"] = CandidateList(found);
  result["model"] = "model.yaml";
  for (const Status& s :
       {WriteMeasured(dir, data), WriteChannels(dir, "predicted.csv", data, after.value()),
        WriteChannels(dir, "baseline.csv", data, before.value()), write_model(corrected),
        WriteFileAtomically(dir.File("result.json"), result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  outcome.summary = Summary(result);
  return outcome;
}

Result<IdentifyOutcome> IdentifyDriven(const Manifest& manifest, const SearchOptions& options,
                                       const Progress& progress, const ResultDir& dir) {
  Result<Case> loaded = LoadCase(manifest);
  if (!loaded.ok()) return loaded.error();
  const FitData& data = loaded.value().data;
  const PhsParams& declared = loaded.value().declared;
  Result<FitProblem> problem = FitProblem::Create(data, declared);
  if (!problem.ok()) return problem.error();
  const auto write_model = [&](PhsParams corrected) {
    corrected.name += "_identified";
    corrected.description = "Identified from " + data.source + "; declared " + declared.name;
    return WriteFileAtomically(dir.File("model.yaml"), phs_model::ToYaml(corrected));
  };
  SearchOptions asked = options;
  // Four cylinders and a beam: a run costs ten times as much, and there are more places to try.
  asked.thorough = options.thorough && data.kind != rigs::RigKind::kFull;
  asked.formula = data.candidates.empty() ||
                  std::find(data.candidates.begin(), data.candidates.end(), "unlisted") !=
                      data.candidates.end();
  return SearchAndWrite(manifest, declared, &problem.value(), asked, progress, write_model, dir);
}

}  // namespace phs::identify::search
