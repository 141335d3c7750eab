#include "measurement/rig_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/words.h"
#include "measurement/channel_noise.h"
#include "measurement/data_checks.h"
#include "measurement/standstill.h"
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
    out.motion.position_m[static_cast<size_t>(found - inputs.begin())] =
        rigs::GenerateSignal(signals.signals[k], signals.num_samples(), signals.sample_s);
  }
  return out;
}

Result<RigCase> Measured(const Manifest& manifest, const RigModel& model) {
  Result<measurement::RigRun> read = measurement::ReadRigRun(
      manifest.runs.front(), manifest, model.input_names(), model.output_names());
  if (!read.ok()) return read.error();
  RigCase out;
  out.run = std::move(read.value());
  measurement::RigRun& run = out.run;
  out.motion.t0_s = run.t0_s;
  out.motion.step_s = run.step_s;
  std::vector<char> rest;
  for (measurement::Channel& input : run.inputs) {
    const double noise = std::max(measurement::WhiteNoise(input.y, input.bad),
                                  measurement::Quantum(input.y) / std::sqrt(12.0));
    input.noise.level = noise;
    measurement::SmoothMotion smooth =
        measurement::SmoothPosition(input.y, input.bad, run.step_s, std::max(noise, 1e-12));
    const std::vector<char> still = measurement::FindRest(smooth, run.step_s, 4, 2e-6, 0.5);
    if (rest.empty()) rest = still;
    for (size_t i = 0; i < rest.size(); ++i) rest[i] = rest[i] && still[i];
    out.motion.position_m.push_back(std::move(smooth.position));
    out.motion.speed_m_s.push_back(std::move(smooth.speed));
    out.motion.acceleration_m_s2.push_back(std::move(smooth.acceleration));
  }
  for (measurement::Channel& output : run.outputs) {
    if (!output.present()) continue;
    output.noise = measurement::EstimateNoise(output, rest, run.step_s);
    measurement::MarkSpikes(&output, &run.findings);
    measurement::MarkStuck(&output, run, &run.findings);
  }
  if (model.kind() == RigKind::kElement && run.pressure.present()) {
    out.motion.pressure_Pa = run.pressure.y;
  }
  return out;
}

}  // namespace

Result<RigCase> ReadRigCase(const Manifest& manifest, const RigModel& model) {
  return manifest.signal ? Generated(manifest, model) : Measured(manifest, model);
}

Status CheckStroke(const RigModel& model, const RigMotion& motion,
                   const std::vector<std::vector<double>>& piston) {
  if (model.kind() == RigKind::kElement) return {};
  const bool mounted = model.system().has_mounts();
  for (size_t c = 0; c < motion.position_m.size(); ++c) {
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
