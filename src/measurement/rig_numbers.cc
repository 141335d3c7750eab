#include "measurement/rig_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace phs::measurement {
namespace {

using json = nlohmann::ordered_json;
using Series = std::vector<double>;
using Span = std::array<double, 2>;

Span Whole(const DrivenRig& rig) {
  const rigs::RigMotion& motion = rig.input.motion;
  return {motion.t0_s, motion.t0_s + motion.num_samples() * motion.step_s};
}

Span SpanOf(const Window& window, const DrivenRig& rig) {
  return window.empty() ? Whole(rig) : Span{window.begin, window.end};
}

/// Of the numbers that are told after the first period of a generated wave.
Span Settled(const Manifest& manifest, const DrivenRig& rig) {
  if (!manifest.signal) return SpanOf(rig.input.run.validation, rig);
  Span span = Whole(rig);
  double begin = 0;
  for (const auto& parts : manifest.signal->signals) {
    if (parts.empty() || !parts.front().IsWave()) continue;
    const rigs::SignalParams& wave = parts.front();
    begin = std::max(begin, wave.start_s + wave.Wait() + 1 / wave.frequency_Hz);
  }
  if (begin < span[1] - rig.input.motion.step_s) span[0] = begin;
  return span;
}

const Series* PredictedOf(const DrivenRig& rig, const std::string& name) {
  const auto& names = rig.model.output_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return nullptr;
  return &rig.predicted.channels[static_cast<size_t>(found - names.begin())];
}

/// A measured channel, NaN where a sample takes no part; empty: not measured.
Series MeasuredOf(const DrivenRig& rig, const std::string& name) {
  for (const Channel& channel : rig.input.run.outputs) {
    if (channel.name != name || !channel.present()) continue;
    Series y = channel.y;
    for (size_t i = 0; i < y.size(); ++i) {
      if (channel.bad[i]) y[i] = std::numeric_limits<double>::quiet_NaN();
    }
    return y;
  }
  return {};
}

/// P of one cylinder's pressures.
Series ForceOf(const Series& bore, const Series& rod, const DrivenRig& rig) {
  const auto& cylinder = rig.model.system().params().cylinders.front();
  Series force(bore.size());
  for (size_t i = 0; i < bore.size(); ++i) {
    force[i] = rod[i] * cylinder.RodArea() - bore[i] * cylinder.BoreArea();
  }
  return force;
}

/// Empty where the rig does not predict both pressures of one cylinder.
Series HydraulicForce(const DrivenRig& rig) {
  const Series* bore = PredictedOf(rig, "p_bore_Pa");
  const Series* rod = PredictedOf(rig, "p_rod_Pa");
  return bore == nullptr || rod == nullptr ? Series() : ForceOf(*bore, *rod, rig);
}

double Largest(const Series& y) {
  double largest = 0;
  for (double value : y) largest = std::max(largest, std::abs(value));
  return largest;
}

double Rms(const Series& y) {
  double sum = 0;
  for (double value : y) sum += value * value;
  return y.empty() ? 0 : std::sqrt(sum / static_cast<double>(y.size()));
}

json ScoreWindow(const DrivenRig& rig, const Window& window) {
  json out = json::object();
  for (size_t k = 0; k < rig.input.run.outputs.size(); ++k) {
    const Channel& channel = rig.input.run.outputs[k];
    if (!channel.present()) continue;
    out[channel.name] = ToJson(Score(rig.Times(), MeasuredOf(rig, channel.name),
                                     rig.predicted.channels[k], SpanOf(window, rig)));
  }
  return out;
}

/// Against the record: its noise, what it says about itself, the errors.
void AddRecord(const DrivenRig& rig, json* result) {
  const RigRun& run = rig.input.run;
  json noise = json::object(), findings = json::array();
  for (const auto* list : {&run.inputs, &run.outputs}) {
    for (const Channel& channel : *list) {
      if (channel.present()) noise[channel.name] = channel.noise.level;
    }
  }
  for (const DataFinding& f : run.findings) {
    findings.push_back({{"channel", f.channel}, {"text", f.text}});
  }
  (*result)["noise"] = noise;
  (*result)["data_findings"] = findings;
  if (!run.estimation.empty()) {
    (*result)["estimation"] = {run.estimation.begin, run.estimation.end};
    (*result)["channels_estimation"] = ScoreWindow(rig, run.estimation);
  }
  if (!run.validation.empty()) {
    (*result)["validation"] = {run.validation.begin, run.validation.end};
  }
  (*result)["channels"] = ScoreWindow(rig, run.validation);
}

void AddSizes(const DrivenRig& rig, json* result) {
  json extremes = json::object(), largest = json::object(), rms = json::object();
  for (size_t k = 0; k < rig.model.output_names().size(); ++k) {
    const std::string& name = rig.model.output_names()[k];
    const Series& y = rig.predicted.channels[k];
    const auto [low, high] = std::minmax_element(y.begin(), y.end());
    extremes[name] = {{"least", *low}, {"most", *high}};
    largest[name] = Largest(y);
    rms[name] = Rms(y);
  }
  (*result)["extremes"] = extremes;
  (*result)["largest"] = largest;
  (*result)["rms"] = rms;
}

void AddHydraulicForce(const Manifest& manifest, const DrivenRig& rig, json* result) {
  const Series force = HydraulicForce(rig);
  if (force.empty()) return;
  (*result)["largest"]["hydraulic_N"] = Largest(force);
  (*result)["rms"]["hydraulic_N"] = Rms(force);
  json& out = (*result)["hydraulic_force"];
  out["against_load_cell"] = ToJson(ScoreHydraulicForce(manifest, rig));
  const Series bore = MeasuredOf(rig, "p_bore_Pa"), rod = MeasuredOf(rig, "p_rod_Pa");
  if (bore.empty() || rod.empty()) return;
  out["against_pressures"] =
      ToJson(Score(rig.Times(), ForceOf(bore, rod, rig), force, Settled(manifest, rig)));
}

Status AddComparison(const Manifest& manifest, const DrivenRig& rig, json* result) {
  const auto path = FindManifest(manifest.compare_with);
  if (!path.ok()) return path.error();
  const auto other = LoadManifest(path.value(), WindowNeed::kNone);
  if (!other.ok()) return other.error();
  const std::string where = manifest.path + ": compare_with";
  if (!HasClock(other.value())) {
    return Error{where, "names a rig without a clock: " + other.value().rig, kRigsWithClock, ""};
  }
  const auto driven = DriveRig(other.value());
  if (!driven.ok()) return driven.error();
  const DrivenRig& base = driven.value();
  if (base.model.output_names() != rig.model.output_names() ||
      base.input.motion.step_s != rig.input.motion.step_s ||
      base.input.motion.num_samples() != rig.input.motion.num_samples()) {
    return Error{where, "has other channels or another clock than this rig",
                 "a manifest of the same rig with the same duration and sample", ""};
  }
  json& out = (*result)["compared_with"];
  out = {{"manifest", manifest.compare_with}};
  const Span span = Settled(manifest, rig);
  for (size_t k = 0; k < rig.model.output_names().size(); ++k) {
    out[rig.model.output_names()[k]] =
        ToJson(Score(rig.Times(), base.predicted.channels[k], rig.predicted.channels[k], span));
  }
  if (const Series force = HydraulicForce(rig); !force.empty()) {
    out["hydraulic_N"] = ToJson(Score(rig.Times(), HydraulicForce(base), force, span));
  }
  return {};
}

}  // namespace

ChannelScore ScoreHydraulicForce(const Manifest& manifest, const DrivenRig& rig) {
  Series load = MeasuredOf(rig, "load_cell_N");
  if (load.empty()) load = *PredictedOf(rig, "load_cell_N");
  return Score(rig.Times(), load, HydraulicForce(rig), Settled(manifest, rig));
}

Result<json> RigNumbers(const Manifest& manifest, const DrivenRig& rig) {
  const RigCase& input = rig.input;
  json result = {{"rig", manifest.rig}, {"declared", manifest.model}};
  result["data"] = input.measured() ? json(input.run.source) : json("generated signals");
  if (input.compared()) AddRecord(rig, &result);
  AddSizes(rig, &result);
  AddHydraulicForce(manifest, rig, &result);
  if (!manifest.compare_with.empty()) {
    if (Status s = AddComparison(manifest, rig, &result); !s.ok()) return s.error();
  }
  return result;
}

}  // namespace phs::measurement
