#include "measurement/rig_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/words.h"
#include "measurement/channel_noise.h"
#include "measurement/data_checks.h"
#include "measurement/standstill.h"
#include "measurement/stuck_bit.h"
#include "rigs/rig_signal.h"

namespace phs::measurement {
namespace {

using measurement::Manifest;
using rigs::RigKind;
using rigs::RigModel;
using rigs::RigMotion;

Result<RigCase> Generated(const Manifest& manifest, const RigModel& model) {
  const rigs::RigSignals& signals = *manifest.signal;
  const std::vector<std::string>& inputs = model.input_names();
  if (manifest.options.driven_by == rigs::Drive::kPressure) {
    return Error{manifest.path + ": signal", "has no pressures that belong to the motion",
                 "data:", "driven_by: position predicts them"};
  }
  RigCase out;
  out.motion.step_s = signals.sample_s;
  out.motion.position_m.assign(inputs.size(),
                               std::vector<double>(static_cast<size_t>(signals.num_samples()), 0));
  for (size_t k = 0; k < signals.channels.size(); ++k) {
    const auto found = std::find(inputs.begin(), inputs.end(), signals.channels[k]);
    if (found == inputs.end()) {
      return Error{manifest.path + ": signal." + signals.channels[k], "is no driven channel",
                   JoinWords(inputs), DidYouMean(signals.channels[k], inputs)};
    }
    for (const rigs::SignalParams& part : signals.signals[k]) {
      if (part.force == found->ends_with("_N")) continue;
      return Error{manifest.path + ": signal." + *found, "is given in another quantity",
                   found->ends_with("_N") ? "amplitude_N, levels_N, rate_N_s"
                                          : "amplitude_m, levels_m, speed_m_s"};
    }
    out.motion.position_m[static_cast<size_t>(found - inputs.begin())] =
        rigs::GenerateSignals(signals.signals[k], signals.num_samples(), signals.sample_s);
  }
  return out;
}

/// A position is smoothed, with its speeds; `rest`: samples at which nothing moves.
void TakeInput(Channel& input, double step_s, RigMotion* motion, std::vector<char>* rest) {
  const double noise = std::max(WhiteNoise(input.y, input.bad), Quantum(input.y) / std::sqrt(12.0));
  input.noise.level = noise;
  if (!input.name.ends_with("_m")) {
    motion->position_m.push_back(input.y);
    motion->speed_m_s.push_back(rigs::DifferentiateMotion(input.y, step_s));
    motion->acceleration_m_s2.push_back(
        rigs::DifferentiateMotion(motion->speed_m_s.back(), step_s));
    return;
  }
  SmoothMotion smooth = SmoothPosition(input.y, input.bad, step_s, std::max(noise, 1e-12));
  const std::vector<char> still = FindRest(smooth, step_s, 4, 2e-6, 0.5);
  if (rest->empty()) *rest = still;
  for (size_t i = 0; i < rest->size(); ++i) (*rest)[i] = (*rest)[i] && still[i];
  motion->position_m.push_back(std::move(smooth.position));
  motion->speed_m_s.push_back(std::move(smooth.speed));
  motion->acceleration_m_s2.push_back(std::move(smooth.acceleration));
}

Result<RigCase> Measured(const Manifest& manifest, const RigModel& model) {
  Result<measurement::RigRun> read =
      measurement::ReadRigRun(manifest.runs.front(), manifest, model.input_names(),
                              model.output_names(), OutputNeed::kNone);
  if (!read.ok()) return read.error();
  RigCase out;
  out.run = std::move(read.value());
  measurement::RigRun& run = out.run;
  out.motion.t0_s = run.t0_s;
  out.motion.step_s = run.step_s;
  std::vector<char> rest;  // stays empty where no position is measured: noise of the whole record
  for (measurement::Channel& input : run.inputs) {
    TakeInput(input, run.step_s, &out.motion, &rest);
  }
  for (measurement::Channel& output : run.outputs) {
    if (!output.present()) continue;
    measurement::ReadBackStuckBit(run, &output, &run.findings);
    output.noise = measurement::EstimateNoise(output, rest, run.step_s);
    measurement::MarkSpikes(&output, &run.findings);
    measurement::MarkStuck(&output, run, &run.findings);
  }
  if (model.kind() == RigKind::kElement && run.pressure.present()) {
    out.motion.pressure_Pa = run.pressure.y;
  }
  if (model.kind() == RigKind::kElement && run.temperature.present()) {
    out.motion.temperature_K = run.temperature.y;
  }
  return out;
}

}  // namespace

Result<RigCase> ReadRigCase(const Manifest& manifest, const RigModel& model) {
  return manifest.signal ? Generated(manifest, model) : Measured(manifest, model);
}

bool RigCase::compared() const {
  return std::any_of(run.outputs.begin(), run.outputs.end(),
                     [](const Channel& output) { return output.present(); });
}

Status CheckStroke(const RigModel& model, const RigMotion& motion,
                   const std::vector<std::vector<double>>& piston) {
  if (model.kind() == RigKind::kElement) return {};
  const bool by_force = model.input_names().front().ends_with("_N");
  const bool mounted = model.system().has_mounts() || by_force;
  for (size_t c = 0; c < motion.position_m.size(); ++c) {
    if (!by_force && !model.input_names()[c].ends_with("_m")) continue;
    const auto& cylinder = model.system().params().cylinders[c];
    const double stop = cylinder.end_stop.clearance_m;
    const double limit = mounted ? stop + cylinder.end_stop.transition_m : stop;
    const std::vector<double>& x = mounted ? piston[c] : motion.position_m[c];
    for (size_t i = 0; i < x.size(); ++i) {
      if (std::abs(x[i]) <= limit) continue;
      const double t = motion.t0_s + static_cast<double>(i) * motion.step_s;
      return Error{
          model.input_names()[c],
          fmt::format("at {:.6g} s the piston of cylinder {} is driven to {:.4g} m, beyond "
                      "its stop",
                      t, cylinder.name, x[i]),
          fmt::format("-{0:g} to {0:g} m", stop),
          "check the unit and the zero of the channel, or the model's end_stop.clearance_m"};
    }
  }
  return {};
}

}  // namespace phs::measurement
