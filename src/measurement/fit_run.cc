#include "measurement/fit_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/words.h"
#include "measurement/channel_noise.h"
#include "measurement/data_checks.h"
#include "measurement/excitation.h"
#include "measurement/rig_data.h"
#include "measurement/sampling_check.h"
#include "measurement/standstill.h"
#include "measurement/stuck_bit.h"

namespace phs::measurement {
namespace {

constexpr double kEnoughStandstill_s = 4;  // to tell noise by it

/// Only what both say; `flags` empty: not said yet.
void Restrict(const std::vector<char>& by, std::vector<char>* flags) {
  if (flags->empty()) *flags = by;
  for (size_t i = 0; i < flags->size(); ++i) (*flags)[i] = (*flags)[i] && by[i];
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kMinSamples = 200;

/// Samples at which the driving motion is bridged over more than a few samples: what the model is
/// driven with there is not what happened.
std::vector<char> LostInput(const std::vector<Channel>& inputs) {
  constexpr size_t kShort = 4;
  std::vector<char> lost(inputs.front().y.size(), 0);
  for (const Channel& input : inputs) {
    for (size_t i = 0; i < lost.size();) {
      size_t end = i;
      while (end < lost.size() && input.bad[end]) ++end;
      if (end - i > kShort) std::fill(lost.begin() + i, lost.begin() + end, 1);
      i = end + 1;
    }
  }
  return lost;
}

/// What leaks, creeps or warms while the motion is not known shows in all that follows: a leak of a
/// record with 2 s left out came out sixty times too small, one with 0.5 s left out as it was.
void FindLostMotion(const RigRun& run, const std::vector<char>& lost, FitData* data) {
  constexpr double kLongestBridge_s = 1;
  const double last = std::max(data->estimation[1], data->validation[1]);
  for (size_t i = 0; i < lost.size();) {
    size_t end = i;
    while (end < lost.size() && lost[end]) ++end;
    const double from = run.Time(static_cast<int>(i)),
                 length = static_cast<double>(end - i) * run.step_s;
    if (length > kLongestBridge_s && from < last) {
      data->faults.push_back(
          fmt::format("the driving motion is not known from {:.4g} to {:.4g} s, nor what leaked or "
                      "slid there: "
                      "cut the record, or give its parts as runs",
                      from, from + length));
    }
    i = end + 1;
  }
}

std::string Words(const std::vector<DataFinding>& findings) {
  std::vector<std::string> words;
  words.reserve(findings.size());
  for (const DataFinding& f : findings) words.push_back(f.channel + " " + f.text);
  return JoinWords(words);
}

}  // namespace

Status CheckWindows(const RigRun& run, bool several) {
  for (const auto& [name, window] :
       {std::pair{"estimation", run.estimation}, std::pair{"validation", run.validation}}) {
    const int n = run.Last(window) - run.First(window);
    if (n >= kMinSamples || (several && window.empty())) continue;
    if (window.empty()) {
      return Error{run.source, fmt::format("the manifest names no {} window", name),
                   fmt::format("{}: [begin, end] in seconds", name),
                   "data used for fitting cannot judge the fit"};
    }
    return Error{run.source, fmt::format("{} samples in the {} window", n, name),
                 fmt::format("{} or more", kMinSamples),
                 "too little to tell an effect from noise; record longer or widen the window"};
  }
  return {};
}

void TakeOutput(Channel* channel, const RigRun& run, const std::vector<char>& input_lost,
                FitData* data) {
  if (!channel->present()) {
    data->findings.push_back({channel->name, "was not measured"});
    return;
  }
  if (!(channel->noise.level > 0)) {
    data->findings.push_back({channel->name, "never changes: dead, left out"});
    return;
  }
  MarkStuck(channel, run, &data->findings);
  MarkSpikes(channel, &data->findings);
  MeasuredChannel out{channel->name, channel->y, channel->noise.level};
  const bool fits = !run.estimation.empty();
  size_t good = 0, asked = 0;
  for (size_t i = 0; i < out.values.size(); ++i) {
    if (channel->bad[i] || input_lost[i]) out.values[i] = kNone;
    if (!(fits ? data->InEstimation(i) : run.validation.Contains(data->time_s[i]))) continue;
    ++asked, good += std::isfinite(out.values[i]);
  }
  if (good < kMinSamples || 10 * good < asked) {
    data->findings.push_back(
        {channel->name, fmt::format("only {} of {} samples of the {} window can be used: left out",
                                    good, asked, fits ? "estimation" : "validation")});
    return;
  }
  data->outputs.push_back(std::move(out));
}

FitData StartData(const RigRun& run) {
  FitData data;
  data.source = run.source;
  data.step_s = run.step_s;
  data.estimation = {run.estimation.begin, run.estimation.end};
  data.validation = {run.validation.begin, run.validation.end};
  for (int i = 0; i < run.num_samples; ++i) data.time_s.push_back(run.Time(i));
  data.findings = run.findings;
  return data;
}

Result<FitData> ReadFitData(const Manifest& manifest, const hydraulics::PhsParams& params,
                            bool several) {
  Result<rigs::RigKind> kind = rigs::ParseRigKind(manifest.rig);
  if (!kind.ok()) return kind.error();
  Result<rigs::RigModel> model = rigs::RigModel::Create(kind.value(), params, manifest.options);
  if (!model.ok()) return model.error();
  Result<RigRun> read = ReadRigRun(manifest.runs.front(), manifest, model.value().input_names(),
                                   model.value().output_names());
  if (!read.ok()) return read.error();
  RigRun& run = read.value();
  if (Status s = CheckWindows(run, several); !s.ok()) return s.error();
  FitData data = StartData(run);
  data.kind = kind.value();
  data.options = manifest.options;
  if (run.extra) data.options.extra = run.extra;
  data.candidates = manifest.candidates, data.own = manifest.own;
  data.free = manifest.free;
  data.row_time_s = run.row_time;
  std::vector<char> rest, standstill;
  for (Channel& input : run.inputs) {
    data.input_unit_m = MendInputScale(params, &input, &data.findings);
    MarkSpikes(&input, &data.findings);
    input.noise.white = WhiteNoise(input.y, input.bad);
    input.noise.quantum = Quantum(input.y);
    MarkStuck(&input, run, &data.findings);
    if (Status s = CheckSampling(input, run, &data.findings); !s.ok()) return s.error();
    const double noise = std::max(WhiteNoise(input.y, input.bad), Quantum(input.y) / 3.46);
    data.inputs.push_back({input.name, input.y, noise});
    data.motion.push_back(SmoothPosition(input.y, input.bad, run.step_s, std::max(noise, 1e-12)));
    Restrict(FindRest(data.motion.back(), run.step_s, 4, 2e-6, 0.5), &rest);
    Restrict(FindStandstill(input.y, input.bad, run.step_s, noise), &standstill);
  }
  Restrict(rest, &standstill);
  if (std::count(standstill.begin(), standstill.end(), 1) * run.step_s > kEnoughStandstill_s) {
    rest = std::move(standstill);
  }
  for (size_t a = 0; a < run.inputs.size(); ++a) {
    if (Status s = CheckExcitation({&run}, a); !s.ok()) return s.error();
  }
  if (run.pressure.present()) data.pressure_Pa = run.pressure.y;
  const std::vector<char> lost = LostInput(run.inputs);
  FindLostMotion(run, lost, &data);
  for (Channel& output : run.outputs) {
    if (output.present()) {
      ReadBackStuckBit(run, &output, &data.findings);
      output.noise = EstimateNoise(output, rest, run.step_s);
    }
    TakeOutput(&output, run, lost, &data);
  }
  if (data.outputs.empty()) {
    return Error{data.source, "no output channel can be used: " + Words(data.findings),
                 "a measured channel that changes", ""};
  }
  return data;
}

}  // namespace phs::measurement
