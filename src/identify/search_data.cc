#include "identify/search_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "effects/catalogue.h"
#include "identify/channel_noise.h"
#include "identify/rig_data.h"

namespace phs::identify::search {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kMinSamples = 200;

/// Marks lone samples that jump off both neighbours by more than 12 noise levels, and far more than
/// the neighbours differ among themselves, as missing; returns how many.
int RemoveSpikes(std::vector<double>* values, double noise) {
  int removed = 0;
  std::vector<double>& y = *values;
  for (size_t i = 2; i + 2 < y.size(); ++i) {
    const double around = (4 * (y[i - 1] + y[i + 1]) - (y[i - 2] + y[i + 2])) / 6;
    const double spread = std::abs(y[i + 1] - y[i - 1]) + std::abs(y[i + 2] - y[i + 1]) +
                          std::abs(y[i - 1] - y[i - 2]);
    if (std::abs(y[i] - around) > 12 * noise + 4 * spread) y[i] = kNone, ++removed;
  }
  return removed;
}

Status CheckExcitation(const FitData& data) {
  for (const MeasuredChannel& input : data.inputs) {
    double low = 1e300, high = -1e300, turn = 0;
    int reversals = 0, direction = 0;
    bool first = true;
    const double step = std::max(20 * input.noise, 1e-7);
    for (size_t i = 0; i < data.time_s.size(); ++i) {
      const double t = data.time_s[i], x = input.values[i];
      if (t < data.estimation[0] || t >= data.estimation[1] || !std::isfinite(x)) continue;
      low = std::min(low, x), high = std::max(high, x);
      if (first) turn = x, first = false;
      if ((x - turn) * direction > 0) turn = x;
      if (std::abs(x - turn) <= step) continue;
      if (direction != 0) ++reversals;
      direction = x > turn ? 1 : -1, turn = x;
    }
    if (high - low < 2 * step) {
      return Error{data.source,
                   fmt::format("{} does not move in the estimation window ({:.2g} m)", input.name,
                               high - low),
                   "motion well above its noise",
                   "nothing can be identified from a constant input; choose another window"};
    }
    if (reversals < 2) {
      return Error{
          data.source,
          fmt::format("{} reverses {} times in the estimation window", input.name, reversals),
          "2 reversals or more",
          "friction and stiffness cannot be told apart without; choose a longer window"};
    }
  }
  return {};
}

double Correlation(const std::vector<double>& a, const std::vector<double>& b, double* ratio) {
  double n = 0, ma = 0, mb = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (std::isfinite(a[i])) ++n, ma += a[i], mb += b[i];
  }
  if (n < 2) return 0;
  ma /= n, mb /= n;
  double aa = 0, bb = 0, ab = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i])) continue;
    aa += (a[i] - ma) * (a[i] - ma), bb += (b[i] - mb) * (b[i] - mb);
    ab += (a[i] - ma) * (b[i] - mb);
  }
  *ratio = bb > 0 ? std::sqrt(aa / bb) : 1;
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

Status CheckWindows(const RigRun& run) {
  for (const auto& [name, window] :
       {std::pair{"estimation", run.estimation}, std::pair{"validation", run.validation}}) {
    const int n = run.Last(window) - run.First(window);
    if (n >= kMinSamples) continue;
    return Error{run.source, fmt::format("{} samples in the {} window", n, name),
                 fmt::format("{} or more", kMinSamples),
                 "too little to tell an effect from noise; record longer or widen the window"};
  }
  return {};
}

void TakeOutput(const Channel& channel, FitData* data) {
  if (!channel.present()) {
    data->remarks.push_back(channel.name + " was not measured");
    return;
  }
  MeasuredChannel out{channel.name, channel.y, channel.noise.level};
  if (!(out.noise > 0)) {
    data->remarks.push_back(channel.name + " never changes: dead, left out");
    return;
  }
  const int spikes = RemoveSpikes(&out.values, channel.noise.white);
  for (size_t i = 0; i < out.values.size(); ++i) {
    if (channel.bad[i]) out.values[i] = kNone;
  }
  if (spikes > 0) data->remarks.push_back(fmt::format("{}: {} spikes left out", out.name, spikes));
  data->outputs.push_back(std::move(out));
}

}  // namespace

Result<FitData> ReadFitData(const Manifest& manifest) {
  Result<effects::RigKind> kind = effects::ParseRigKind(manifest.rig);
  if (!kind.ok()) return kind.error();
  Result<hydraulics::PhsParams> params = effects::FindPhsParams(manifest.model);
  if (!params.ok()) return params.error();
  Result<effects::RigModel> model = effects::RigModel::Create(kind.value(), params.value());
  if (!model.ok()) return model.error();
  Result<RigRun> read = ReadRigRun(manifest.runs.front(), manifest, model.value().input_names(),
                                   model.value().output_names());
  if (!read.ok()) return read.error();
  RigRun& run = read.value();
  if (Status s = CheckWindows(run); !s.ok()) return s.error();
  FitData data;
  data.kind = kind.value();
  data.source = run.source;
  data.step_s = run.step_s;
  data.estimation = {run.estimation.begin, run.estimation.end};
  data.validation = {run.validation.begin, run.validation.end};
  for (int i = 0; i < run.num_samples; ++i) data.time_s.push_back(run.Time(i));
  for (const DataFinding& f : run.findings) data.remarks.push_back(f.channel + ": " + f.text);
  std::vector<char> rest;
  for (Channel& input : run.inputs) {
    const double noise = std::max(WhiteNoise(input.y, input.bad), Quantum(input.y) / 3.46);
    data.inputs.push_back({input.name, input.y, noise});
    data.motion.push_back(SmoothPosition(input.y, input.bad, run.step_s, std::max(noise, 1e-12)));
    const std::vector<char> still = FindRest(data.motion.back(), run.step_s, 4, 2e-6, 0.5);
    if (rest.empty()) rest = still;
    for (size_t i = 0; i < rest.size(); ++i) rest[i] = rest[i] && still[i];
  }
  if (Status s = CheckExcitation(data); !s.ok()) return s.error();
  if (run.pressure.present()) data.pressure_Pa = run.pressure.y;
  for (Channel& output : run.outputs) {
    if (output.present()) output.noise = EstimateNoise(output, rest, run.step_s);
    TakeOutput(output, &data);
  }
  if (data.outputs.empty()) {
    return Error{data.source, "every output channel is dead", "a channel that changes", ""};
  }
  return data;
}

Status CheckChannels(const FitData& data, const std::vector<std::vector<double>>& predicted) {
  for (size_t c = 0; c < data.outputs.size(); ++c) {
    const MeasuredChannel& channel = data.outputs[c];
    double ratio = 1, unused = 1;
    const double own = Correlation(channel.values, predicted[c], &ratio);
    if (own < -0.6) {
      return Error{channel.name, fmt::format("runs against the model (correlation {:.2f})", own),
                   "extension and tension > 0, pressures absolute", "change its sign"};
    }
    if (own > 0.6 && (ratio > 80 || ratio < 1 / 80.0)) {
      return Error{channel.name, fmt::format("swings {:.3g} times as much as the model", ratio),
                   "the unit its name says", "mend the scale of the column"};
    }
    const std::string unit = channel.name.substr(channel.name.rfind('_'));
    for (size_t d = 0; d < c; ++d) {
      if (!data.outputs[d].name.ends_with(unit)) continue;
      const double crossed = Correlation(channel.values, predicted[d], &unused);
      const double back = Correlation(data.outputs[d].values, predicted[c], &unused);
      if (own < 0.3 && crossed > 0.7 && back > 0.7) {
        return Error{channel.name, "follows the prediction of " + data.outputs[d].name,
                     "each channel under its own name", "swap the two columns"};
      }
    }
  }
  return {};
}

}  // namespace phs::identify::search
