#include "identify/models/element_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measurement/channel_noise.h"
#include "measurement/data_checks.h"
#include "measurement/excitation.h"
#include "measurement/motion_smoother.h"
#include "measurement/rig_data.h"
#include "measurement/sampling_check.h"
#include "measurement/series.h"
#include "measurement/stuck_bit.h"

namespace phs::identify::element {

using measurement::BandLimit;
using measurement::Channel;
using measurement::DataFinding;
using measurement::Manifest;
using measurement::Quantile;
using measurement::Quantum;
using measurement::ReadRigRun;
using measurement::RigRun;
using measurement::RunSpec;
using measurement::SmoothMotion;
using measurement::SmoothPosition;
using measurement::WhiteNoise;
namespace {

constexpr int kMinRows = 100;

void TakeRows(const RigRun& run, double band_Hz, bool by_force, ElementRecord* record) {
  record->band = BandLimit(run.step_s, band_Hz);
  record->row_force_N = record->band.Apply(record->force_N);
  record->row_value = by_force ? record->band.Apply(run.inputs[0].y) : record->row_force_N;
  const int n = run.num_samples, spread = record->band.spread();
  std::vector<int> bad_before(static_cast<size_t>(n) + 1, 0);
  for (int i = 0; i < n; ++i) {
    const size_t k = static_cast<size_t>(i);
    bad_before[k + 1] = bad_before[k] + (run.inputs[0].bad[k] || run.outputs[0].bad[k]);
  }
  for (int i = 0; i < n; i += record->band.stride()) {
    const int first = std::max(0, i - spread), last = std::min(n, i + spread + 1);
    const bool good =
        bad_before[static_cast<size_t>(last)] == bad_before[static_cast<size_t>(first)];
    const double t = run.Time(i);
    record->row_sample.push_back(i);
    record->fitted.push_back(good && record->estimation.Contains(t));
    record->scored.push_back(good && record->validation.Contains(t));
  }
}

Result<ElementRecord> MakeRecord(RigRun& run, double band_Hz, bool by_force) {
  ElementRecord record;
  record.source = run.source;
  record.estimation = run.estimation;
  record.validation = run.validation;
  Channel& x = run.inputs[0];
  const double noise = std::max(WhiteNoise(x.y, x.bad), Quantum(x.y) / std::sqrt(12.0));
  const SmoothMotion smooth = SmoothPosition(x.y, x.bad, run.step_s, std::max(noise, 1e-12));
  record.motion.t0_s = run.t0_s;
  record.motion.step_s = run.step_s;
  record.motion.position_m = {smooth.position};
  record.motion.speed_m_s = {run.speed.present() ? run.speed.y : smooth.speed};
  if (!run.speed.present()) record.motion.acceleration_m_s2 = {smooth.acceleration};
  record.speed_deviation = smooth.speed_deviation;
  if (run.pressure.present()) record.motion.pressure_Pa = run.pressure.y;
  if (run.temperature.present()) record.motion.temperature_K = run.temperature.y;
  record.force_N = run.outputs[0].y;
  record.extra = run.extra;
  record.start_m = smooth.position.front(), record.start_m_s = record.motion.speed_m_s[0].front();
  TakeRows(run, band_Hz, by_force, &record);
  return record;
}

/// A motion in millimetres, spikes, and stretches in which motion or force stands still to the last
/// digit, at an end of its range or elsewhere: mended or left out, with a word.
void LeaveOutFaults(RigRun* run) {
  Channel &x = run->inputs[0], &force = run->outputs[0];
  measurement::MendInputScale({}, &x, &run->findings);
  measurement::MarkMotionSpikes(&x, &run->findings);
  measurement::ReadBackStuckBit(*run, &force, &run->findings);
  measurement::MarkSpikes(&force, &run->findings);
  for (measurement::Channel* channel : {&x, &force}) {
    channel->noise.white = WhiteNoise(channel->y, channel->bad);
    channel->noise.quantum = Quantum(channel->y);
    measurement::MarkStuck(channel, *run, &run->findings);
  }
}

/// The reading at which a motion begins that stays farther than ten of its swings from zero; else
/// 0. Its zero says nothing of the part: the force of a spring would be a small difference of large
/// numbers.
double FarZero(const Channel& x) {
  constexpr double kFar = 10;
  const double reach = Quantile(x.y, 0.99) - Quantile(x.y, 0.01);
  return std::abs(Quantile(x.y, 0.5)) > kFar * reach ? x.y.front() : 0;
}

/// Every run with its faults left out, what was found in `data`.
Result<std::vector<RigRun>> ReadRuns(const Manifest& manifest, ElementData* data) {
  std::vector<RigRun> runs;
  double zero = 0;
  for (const RunSpec& spec : manifest.runs) {
    Result<RigRun> read = ReadRigRun(spec, manifest, {"x_m"}, {"force_N"});
    if (!read.ok()) return read.error();
    runs.push_back(std::move(read.value()));
    RigRun& run = runs.back();
    LeaveOutFaults(&run);
    if (runs.size() == 1) zero = FarZero(run.inputs[0]);
    for (double& x : run.inputs[0].y) x -= zero;
    if (zero != 0) {
      run.findings.push_back(
          {"x_m", fmt::format("stands {:.3g} m from zero: positions count from there", zero)});
    }
    if (Status s = measurement::CheckSampling(run.inputs[0], run, &run.findings); !s.ok())
      data->too_fast = s.error();
    data->has_pressure &= run.pressure.present();
    data->has_temperature &= run.temperature.present();
    for (const DataFinding& f : run.findings) {
      data->findings.push_back(
          {f.channel, (manifest.runs.size() > 1 ? run.source + ": " : "") + f.text});
    }
  }
  return runs;
}

}  // namespace

int ElementData::CountRows(bool fitted) const {
  int count = 0;
  for (const ElementRecord& r : records) {
    const std::vector<char>& rows = fitted ? r.fitted : r.scored;
    count += static_cast<int>(std::count(rows.begin(), rows.end(), 1));
  }
  return count;
}

Result<ElementData> ReadElementData(const Manifest& manifest) {
  ElementData data;
  data.compare_below_Hz = manifest.compare_below_Hz;
  data.candidates = manifest.candidates, data.own = manifest.own;
  data.by_force = manifest.options.driven_by == rigs::Drive::kForce;
  if (data.by_force) data.compared = "x_m";
  data.has_pressure = data.has_temperature = true;
  Result<std::vector<RigRun>> read = ReadRuns(manifest, &data);
  if (!read.ok()) return read.error();
  std::vector<RigRun>& runs = read.value();
  std::vector<const RigRun*> all;
  all.reserve(runs.size());
  for (const RigRun& run : runs) all.push_back(&run);
  if (Status s = measurement::CheckExcitation(all, 0); !s.ok()) return s.error();
  double square = 0;
  for (RigRun& run : runs) {
    Result<ElementRecord> record = MakeRecord(run, manifest.compare_below_Hz, data.by_force);
    if (!record.ok()) return record.error();
    // White noise of the full rate, as much of it as the band lets through.
    const double share = record.value().band.passes_all()
                             ? 1
                             : std::min(1.0, 2 * manifest.compare_below_Hz * run.step_s);
    const auto noise = [](const Channel& c) {
      return std::max(WhiteNoise(c.y, c.bad), Quantum(c.y) / std::sqrt(12.0));
    };
    const Channel& compared = data.by_force ? run.inputs[0] : run.outputs[0];
    square += std::pow(noise(compared), 2) * share / static_cast<double>(runs.size());
    data.force_noise_N = std::max(data.force_noise_N, noise(run.outputs[0]));
    data.position_noise_m =
        std::max(data.position_noise_m, WhiteNoise(run.inputs[0].y, run.inputs[0].bad));
    data.records.push_back(std::move(record.value()));
  }
  data.noise = std::sqrt(square);
  if (!(data.noise > 0)) {
    return Error{manifest.runs.front().data, data.compared + " never changes: the channel is dead",
                 "a channel that follows the motion", "check the column"};
  }
  for (const bool fitted : {true, false}) {
    if (data.CountRows(fitted) >= kMinRows) continue;
    const bool no_window = std::all_of(
        data.records.begin(), data.records.end(),
        [&](const ElementRecord& r) { return (fitted ? r.estimation : r.validation).empty(); });
    if (no_window) {
      return Error{manifest.path,
                   fmt::format("no run has {} window", fitted ? "an estimation" : "a validation"),
                   fitted ? "estimation: [begin, end] in seconds"
                          : "validation: [begin, end] in seconds, apart from estimation"};
    }
    return Error{manifest.path,
                 fmt::format("{} samples in the {} windows", data.CountRows(fitted),
                             fitted ? "estimation" : "validation"),
                 fmt::format("{} or more", kMinRows),
                 "too little to tell an effect from noise; record longer or widen the windows"};
  }
  return data;
}

}  // namespace phs::identify::element
