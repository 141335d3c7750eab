#include "identify/run/rig_identify.h"

#include <algorithm>

#include "effects/unlisted.h"
#include "identify/models/own_candidates.h"
#include "identify/models/rig_forward.h"
#include "identify/run/driven_run.h"
#include "identify/run/input_unit.h"
#include "identify/run/joined_run.h"
#include "measurement/data_checks.h"
#include "measurement/fit_run.h"
#include "measurement/held_frames.h"
#include "measurement/zero_position.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

using measurement::BeginningChannel;
using measurement::BeginningOf;
using measurement::FindZeroPositions;
using measurement::FitData;
using measurement::InputIsSwapped;
using measurement::LeaveOutBelowVacuum;
using measurement::Manifest;
using measurement::MendOutputs;
using measurement::NameZeros;
using measurement::ReadFitData;
using measurement::ScaleInputs;

namespace {

using hydraulics::PhsParams;

/// Data and declared model of a manifest, checked against each other.
struct Case {
  FitData data;
  PhsParams declared;
};

/// Outputs as the declared model predicts them.
Result<Channels> Predict(const FitData& data, const PhsParams& params) {
  auto rig = RigForward::Create(data, params);
  if (!rig.ok()) return rig.error();
  Channels out;
  const Status done = rig.value()->Run(params, ForwardModel::Span::kWhole, &out);
  if (!done.ok()) return done.error();
  return out;
}

void TurnInput(FitData* data) {
  ScaleInputs(-1, data);
  for (const auto& input : data->inputs) {
    data->findings.push_back(
        {input.name, "every output runs against the model: its sign is swapped"});
  }
}

/// The data with their positions counted from elsewhere.
FitData LessZeros(FitData data, const measurement::ZeroPositions& zeros) {
  for (size_t a = 0; a < data.inputs.size(); ++a) {
    for (double& x : data.inputs[a].values) x -= zeros.inputs[a];
    for (double& x : data.motion[a].position) x -= zeros.inputs[a];
  }
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    for (double& x : data.outputs[c].values) x -= zeros.outputs[c];
  }
  return data;
}

void CountFromStaticState(const PhsParams& declared, FitData* data) {
  if (data->options.driven_by != rigs::Drive::kPosition) return;
  std::vector<BeginningChannel> inputs, outputs;
  std::vector<double> least;
  for (size_t a = 0; a < data->inputs.size(); ++a) {
    inputs.push_back({data->inputs[a].name, data->motion[a].position.front(), 0});
    least.push_back(std::max(5 * data->inputs[a].noise, 1e-5));
  }
  for (const auto& c : data->outputs) outputs.push_back(BeginningOf(c.name, c.values));
  const auto predict = [&](const std::vector<double>& from) {
    return Predict(LessZeros(*data, {from, std::vector<double>(outputs.size(), 0)}), declared);
  };
  const measurement::ZeroPositions zeros = FindZeroPositions(inputs, least, outputs, predict);
  if (!zeros.any()) return;
  *data = LessZeros(std::move(*data), zeros);
  NameZeros(inputs, zeros.inputs, &data->findings);
  NameZeros(outputs, zeros.outputs, &data->findings);
}

Result<Case> LoadCase(const Manifest& manifest, bool several) {
  Result<PhsParams> declared = measurement::DeclaredModel(manifest);
  if (!declared.ok()) return declared.error();
  if (Status s = CheckFree(declared.value(), manifest.free); !s.ok()) return s.error();
  Result<FitData> read = ReadFitData(manifest, declared.value(), several);
  if (!read.ok()) return read.error();
  Case c{std::move(read.value()), std::move(declared.value())};
  if (Status s = CheckOwnCandidates(c.data.own, c.declared, c.data.kind, c.data.options); !s.ok()) {
    return s.error();
  }
  CountFromStaticState(c.declared, &c.data);
  Result<Channels> predicted = Predict(c.data, c.declared);
  if (!predicted.ok()) return predicted.error();
  MendInputUnit([&](const FitData& data) { return Predict(data, c.declared); }, &c.data,
                &predicted.value());
  if (InputIsSwapped(c.data, predicted.value())) {
    TurnInput(&c.data);
    predicted = Predict(c.data, c.declared);
    if (!predicted.ok()) return predicted.error();
  }
  MendOutputs(predicted.value(), &c.data);
  measurement::LeaveOutHeld(predicted.value(), &c.data);
  LeaveOutBelowVacuum(&c.data);
  return c;
}

/// Every run with its declared model.
Result<std::vector<Case>> LoadCases(const Manifest& manifest) {
  if (Status s = CheckAsked(manifest.candidates, CandidateNames(), "a rig"); !s.ok()) {
    return s.error();
  }
  const size_t count = manifest.runs.size();
  std::vector<Case> out;
  for (size_t r = 0; r < count; ++r) {
    Result<Case> one = LoadCase(measurement::OfRun(manifest, r), count > 1);
    if (!one.ok()) return one.error();
    out.push_back(std::move(one.value()));
  }
  return out;
}

Status WritePhsModel(const ResultDir& dir, const std::string& file, const FitData& data,
                     const PhsParams& declared, PhsParams corrected) {
  corrected.name += "_identified";
  corrected.description = "Identified from " + data.source + "; declared " + declared.name;
  corrected.of_runs.clear();
  return WriteFileAtomically(dir.File(file), phs_model::ToYaml(corrected));
}

SearchOptions ForRig(const SearchOptions& options, const FitData& data) {
  SearchOptions asked = options;
  // Four cylinders and a beam: a run costs ten times as much, and there are more places to try.
  if (data.kind == rigs::RigKind::kFull) {
    asked.effort.elsewhere = false;
    asked.effort.steps = 2;
    asked.effort.option_fits = 3;
  }
  asked.formula =
      data.candidates.empty() || std::find(data.candidates.begin(), data.candidates.end(),
                                           effects::UnlistedInfo().name) != data.candidates.end();
  return asked;
}

Result<IdentifyOutcome> IdentifyRuns(const Manifest& manifest, const std::vector<Case>& cases,
                                     const SearchOptions& options, const Progress& progress,
                                     const ResultDir& dir) {
  std::vector<RunToJoin> runs;
  for (const Case& c : cases) {
    auto rig = RigForward::Create(c.data, c.declared);
    if (!rig.ok()) return rig.error();
    runs.push_back({c.data, {rig.value(), c.declared}});
  }
  const auto write = [&](size_t r, const std::string& file, const PhsParams& corrected) {
    return WritePhsModel(dir, file, cases[r].data, cases[r].declared, corrected);
  };
  return SearchJoined(manifest, runs, ForRig(options, cases.front().data), progress, write, dir);
}

}  // namespace

Result<IdentifyOutcome> IdentifyDriven(const Manifest& manifest, const SearchOptions& options,
                                       const Progress& progress, const ResultDir& dir) {
  const Result<std::vector<Case>> loaded = LoadCases(manifest);
  if (!loaded.ok()) return loaded.error();
  if (loaded.value().size() > 1) {
    return IdentifyRuns(manifest, loaded.value(), options, progress, dir);
  }
  const FitData& data = loaded.value().front().data;
  const PhsParams& declared = loaded.value().front().declared;
  auto rig = RigForward::Create(data, declared);
  if (!rig.ok()) return rig.error();
  Result<FitProblem> problem = FitProblem::Create(rig.value(), declared, options.rule);
  if (!problem.ok()) return problem.error();
  const auto write = [&](const PhsParams& corrected) {
    return WritePhsModel(dir, "model.yaml", data, declared, corrected);
  };
  return SearchAndWrite(manifest, data, declared, &problem.value(), ForRig(options, data), progress,
                        write, dir);
}

}  // namespace phs::identify::search
