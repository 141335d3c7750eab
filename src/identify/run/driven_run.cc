#include "identify/run/driven_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/table.h"
#include "effects/catalogue.h"
#include "effects/unlisted.h"
#include "identify/fit/thread_budget.h"
#include "identify/next_test/next_test.h"
#include "identify/result/result_json.h"
#include "identify/select/passivity.h"
#include "measurement/data_checks.h"
#include "measurement/standstill.h"

namespace phs::identify::search {

using measurement::FitData;
using measurement::Manifest;
using measurement::MeasuredChannel;
using measurement::SmoothMotion;
namespace {

using hydraulics::PhsParams;

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

namespace {

/// The rows of a window of what drives the model and of what it answers.
Channels Signals(const FitData& data, const Channels& predicted, size_t begin, size_t end) {
  Channels out;
  const auto add = [&](const std::vector<double>& row) {
    if (row.size() < end) return;
    out.emplace_back(row.begin() + static_cast<long>(begin), row.begin() + static_cast<long>(end));
  };
  for (const SmoothMotion& motion : data.motion) add(motion.position);
  add(data.pressure_Pa);
  for (const std::vector<double>& row : predicted) add(row);
  return out;
}

/// The rms over the record of each difference between theories is one draw of one more error: 95 %
/// of a normal one's draws lie within twice its deviation.
void AddRms(const std::vector<Channels>& differences, Channels* deviation) {
  constexpr double kOfDraws = 1.96;
  for (const Channels& difference : differences) {
    for (size_t c = 0; c < difference.size(); ++c) {
      double square = 0;
      for (const double x : difference[c]) {
        square += x * x / static_cast<double>(difference[c].size());
      }
      for (double& u : (*deviation)[c]) u = std::hypot(u, kOfDraws * std::sqrt(square));
    }
  }
}

/// Rows from `begin` to `end` where every driving part stands still.
std::vector<char> StandsStill(const FitData& data, size_t begin, size_t end) {
  std::vector<char> out(end - begin, data.inputs.empty() ? 0 : 1);
  for (const MeasuredChannel& input : data.inputs) {
    std::vector<char> bad;
    for (const double x : input.values) bad.push_back(!std::isfinite(x));
    const std::vector<char> still =
        measurement::FindStandstill(input.values, bad, data.step_s, input.noise);
    for (size_t i = begin; i < end; ++i) {
      out[i - begin] = out[i - begin] && i < still.size() && still[i];
    }
  }
  return out;
}

}  // namespace

Result<Channels> KnownErrors(const ForwardModel& forward, const PhsParams& params) {
  Channels uncertain;
  const Status s = forward.Uncertainty(params, ForwardModel::Span::kWhole, &uncertain);
  if (!s.ok()) return s.error();
  std::vector<Channels> differences;
  const Status known = forward.TheoryDifferences(params, ForwardModel::Span::kWhole, &differences);
  if (!known.ok()) return known.error();
  AddRms(differences, &uncertain);
  const Status drawn = forward.InputErrors(params, ForwardModel::Span::kWhole, &differences);
  if (!drawn.ok()) return drawn.error();
  AddRms(differences, &uncertain);
  return uncertain;
}

std::vector<LeftOver> OverNoise(const FitData& data, const Channels& uncertain,
                                const Channels& predicted, const std::array<double, 2>& window) {
  const auto row = [&](double t) {
    return static_cast<size_t>(std::lower_bound(data.time_s.begin(), data.time_s.end(), t) -
                               data.time_s.begin());
  };
  const size_t begin = row(window[0]), end = row(window[1]);
  const Channels signals = Signals(data, predicted, begin, end);
  const std::vector<char> still = StandsStill(data, begin, end);
  Channels drives;
  for (const measurement::SmoothMotion& motion : data.motion) {
    drives.emplace_back(motion.speed.begin() + static_cast<long>(begin),
                        motion.speed.begin() + static_cast<long>(end));
  }
  std::vector<LeftOver> out;
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const MeasuredChannel& channel = data.outputs[c];
    std::vector<double> residual;
    double sum = 0, count = 0;
    for (size_t i = begin; i < end; ++i) {
      residual.push_back((channel.values[i] - predicted[c][i]) /
                         std::hypot(channel.noise, uncertain[c][i]));
      if (std::isfinite(residual.back())) sum += residual.back() * residual.back(), ++count;
    }
    const bool quiet = IsQuietAtRest(residual, still);
    out.push_back({std::sqrt(sum / std::max(count, 1.0)), MeanSquareThatFollows(residual, signals),
                   quiet || ComesAndGoes(residual), quiet, SwingsAt(residual, drives),
                   FindTwoLevels(residual)});
  }
  return out;
}

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
  if (!data.run.empty()) {
    names.insert(names.end(), {"run", "run_t_s"});
    columns.insert(columns.end(), {data.run, data.run_time_s});
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

namespace {

constexpr double kLast = 0.99;  // of the work

/// What both models leave in a window, by channel.
struct WindowLeft {
  std::vector<LeftOver> before, after;
  std::vector<BeforeAfter> scores;
  double step_s = 1;  ///< of the rows

  std::vector<ChannelLeft> Channels() const {
    std::vector<ChannelLeft> out;
    for (size_t c = 0; c < scores.size(); ++c) {
      out.push_back({scores[c].channel, before[c].over_noise, after[c].over_noise,
                     scores[c].after.nrmse, after[c].following, after[c].comes_and_goes,
                     after[c].quiet_at_rest});
      out.back().swings_Hz = after[c].swings / step_s;
      if (const auto& levels = after[c].levels) {
        out.back().levels_apart = levels->apart, out.back().jumps = levels->jumps;
      }
    }
    return out;
  }
};

TestRig TestRigOf(const Manifest& manifest, const FitData& data, const PhsParams& declared,
                  const SearchOptions& options) {
  std::vector<std::string> inputs;
  Channels positions, speeds;
  for (size_t a = 0; a < data.motion.size(); ++a) {
    inputs.push_back(data.inputs[a].name);
    positions.push_back(data.motion[a].position), speeds.push_back(data.motion[a].speed);
  }
  std::vector<double> forces;
  for (const MeasuredChannel& c : data.outputs) {
    if (c.name.ends_with("_N")) forces.insert(forces.end(), c.values.begin(), c.values.end());
  }
  const double stop =
      declared.cylinders.empty() ? 0 : declared.cylinders.front().end_stop.clearance_m;
  TestRig rig = MakeTestRig(manifest.limits, inputs, data.step_s, positions, speeds, forces, stop);
  rig.coarse_step_s = std::max(data.step_s, options.effort.coarse_step_s);
  return rig;
}

}  // namespace

namespace {

/// An error of a sensor: a listed one, or a formula of what it shows.
bool IsOfInstrument(const hydraulics::EffectParams& effect) {
  const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(effect);
  if (info != nullptr && info->family == "instrument") return true;
  if (effect.name != effects::UnlistedInfo().name) return false;
  const bool of_load = effect.formula.find('F') != std::string::npos;
  return of_load || std::any_of(effect.values.begin(), effect.values.end(), [](const auto& value) {
           return value.first.ends_with("_Pa") || value.first.ends_with("_m");
         });
}

/// What contradicts the corrected model, as sound instruments would show it: an error of a sensor may
/// not stand for a unit. `after`: as the instruments show it.
std::vector<std::string> Contradictions(const FitData& data, const FitProblem& problem,
                                        const PhsParams& corrected, const Channels& after) {
  PhsParams sound = corrected;
  if (std::erase_if(sound.effects, IsOfInstrument) > 0) {
    Channels shown;
    if (problem.forward().Run(sound, ForwardModel::Span::kWhole, &shown).ok()) {
      return measurement::FindContradictions(shown, data);
    }
  }
  return measurement::FindContradictions(after, data);
}

}  // namespace

Result<IdentifyOutcome> SearchAndWrite(const Manifest& manifest, const FitData& data,
                                       const PhsParams& declared, FitProblem* problem,
                                       const SearchOptions& options, const Progress& progress,
                                       const WriteModel& write_model, const ResultDir& dir) {
  SearchOptions asked = options;
  asked.effort.unpromising = !manifest.candidates.empty();  // what is named is tried
  Result<Identification> search = Identify(problem, declared, asked, progress);
  if (!search.ok()) return search.error();
  const Identification& found = search.value();
  IdentifyOutcome outcome;
  outcome.cancelled = found.cancelled;
  if (found.cancelled) return outcome;
  const PhsParams corrected = problem->Params(found.corrected, found.after.values);
  const PhsParams refitted = problem->Params(found.declared, found.before.values);
  Channels before, after;
  Status ran[2];
  ThreadBudget(options.effort.threads).ForEach(2, [&](int k) {
    ran[k] = problem->forward().Run(k == 0 ? refitted : corrected, ForwardModel::Span::kWhole,
                                    k == 0 ? &before : &after);
  });
  for (const Status& s : ran) {
    if (!s.ok()) return s.error();
  }
  const Result<Channels> uncertain = KnownErrors(problem->forward(), corrected);
  if (!uncertain.ok()) return uncertain.error();
  const auto left_in = [&](const std::array<double, 2>& window) -> WindowLeft {
    return {OverNoise(data, uncertain.value(), before, window),
            OverNoise(data, uncertain.value(), after, window),
            ScoreBoth(data, before, after, window), data.step_s};
  };
  const WindowLeft validation = left_in(data.validation), estimation = left_in(data.estimation);
  Json& result = outcome.result;
  result = Head(manifest, data);
  PutRule(options.rule, &result);
  const Unexplained unexplained = FindUnexplained(data, after, validation.after,
                                                  MeanSquares(data, *problem, found.after), found);
  const std::vector<std::string> drives = WhatDrives(*problem, found);
  const std::vector<std::string> wrong = Contradictions(data, *problem, corrected, after);
  VerdictFacts facts{BothWindows(validation.Channels(), estimation.Channels()),
                     NamedEffects(found),
                     FittedNumbers(found),
                     wrong,
                     !found.candidates.empty(),
                     WouldExplain(found),
                     data.questions};
  facts.faults.insert(facts.faults.end(), drives.begin(), drives.end());
  facts.faults.insert(facts.faults.end(), data.faults.begin(), data.faults.end());
  result["channels"] = ScoresJson(validation.scores);
  result["channels_estimation"] = ScoresJson(estimation.scores);
  result["effects"] = EffectList(found);
  result["fitted"] = Parameters(found.corrected, found.after, 0, found.declared.free.size(), true);
  result["localised"] =
      LocalisedJson(Localise(data, before, MeanSquares(data, *problem, found.before)));
  result["unexplained"] = UnexplainedJson(unexplained);
  result["drives"] = drives;
  PutVerdict(facts, &result);
  const Status tested =
      wrong.empty()
          ? PutNextTest(
                *problem, found, unexplained, TestRigOf(manifest, data, declared, options), options,
                [&] { return !progress || progress(kLast); }, dir, &result)
          : PutRecordFirst(&result);
  if (!tested.ok()) return tested.error();
  if (outcome.cancelled = progress && !progress(kLast); outcome.cancelled) return outcome;
  result["candidates"] = CandidateList(found);
  result["model"] = "model.yaml";
  for (const Status& s :
       {WriteMeasured(dir, data), WriteChannels(dir, "predicted.csv", data, after),
        WriteChannels(dir, "baseline.csv", data, before), write_model(corrected),
        WriteFileAtomically(dir.File("result.json"), result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  outcome.summary = Summary(result);
  return outcome;
}

}  // namespace phs::identify::search
