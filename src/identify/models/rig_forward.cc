#include "identify/models/rig_forward.h"

#include <algorithm>
#include <cmath>

#include "identify/fit/effect_variants.h"
#include "identify/models/own_candidates.h"
#include "identify/models/speed_spread.h"

namespace phs::identify::search {

using measurement::DeviationOfDraws;
using measurement::FitData;
using measurement::MeasuredChannel;
using measurement::RedrawnMotion;
using measurement::SmoothMotion;

using hydraulics::PhsParams;
using rigs::RigModel;
using rigs::RigMotion;
using rigs::RigPrediction;

namespace {

/// Steps per sample: a thinned record shows nothing of a line that rings faster than its samples.
constexpr int kMostOfThinned = 5;

}  // namespace

Result<std::shared_ptr<const RigForward>> RigForward::Create(const FitData& data,
                                                             const PhsParams& declared,
                                                             int stride) {
  Result<RigModel> model = RigModel::Create(data.kind, declared, data.options);
  if (!model.ok()) return model.error();
  const auto& names = model.value().output_names();
  std::vector<int> index;
  for (const MeasuredChannel& channel : data.outputs) {
    index.push_back(
        static_cast<int>(std::find(names.begin(), names.end(), channel.name) - names.begin()));
  }
  auto redrawn = std::make_shared<RedrawnMotion>(data);
  return std::shared_ptr<const RigForward>(
      new RigForward(data, std::move(redrawn), std::move(index), stride));
}

RigForward::RigForward(const FitData& data, std::shared_ptr<RedrawnMotion> redrawn,
                       std::vector<int> output_index, int stride)
    : RecordForward(data, stride),
      data_(data),
      options_(data.options),
      stride_(stride),
      redrawn_(std::move(redrawn)),
      output_index_(std::move(output_index)) {
  if (stride > 1) options_.most_substeps = kMostOfThinned;
  full_ = MotionOf(data.motion, Span::kWhole);
  short_ = MotionOf(data.motion, Span::kEstimation);
}

std::vector<double> RigForward::Thin(const std::vector<double>& y) const {
  std::vector<double> out;
  for (size_t i = 0; i < y.size() && data_.time_s[i] < data_.estimation[1]; i += stride_) {
    out.push_back(y[i]);
  }
  return out;
}

RigMotion RigForward::MotionOf(const std::vector<SmoothMotion>& motion, Span span) const {
  const bool whole = span == Span::kWhole;
  RigMotion out;
  out.t0_s = data_.time_s.front();
  out.step_s = whole ? data_.step_s : data_.step_s * stride_;
  for (const SmoothMotion& m : motion) {
    out.position_m.push_back(whole ? m.position : Thin(m.position));
    out.speed_m_s.push_back(whole ? m.speed : Thin(m.speed));
    if (m.acceleration.empty()) continue;
    out.acceleration_m_s2.push_back(whole ? m.acceleration : Thin(m.acceleration));
  }
  out.pressure_Pa = whole ? data_.pressure_Pa : Thin(data_.pressure_Pa);
  return out;
}

std::shared_ptr<const rigs::KeptRun> RunMemory::Find(const PhsParams& of) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    if (entry->of != of) continue;
    entries_.splice(entries_.begin(), entries_, entry);
    return entry->run;
  }
  return nullptr;
}

void RunMemory::Keep(const PhsParams& of, std::shared_ptr<const rigs::KeptRun> run) {
  constexpr size_t kMost = 16, kMostNumbers = 1 << 24;  // 128 MB
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool known = std::any_of(entries_.begin(), entries_.end(),
                                 [&](const Entry& entry) { return entry.of == of; });
  if (known) return;
  const size_t most = std::min(kMost, kMostNumbers / std::max<size_t>(run->num_numbers(), 1));
  if (most == 0) return;
  entries_.push_front({of, std::move(run)});
  while (entries_.size() > most) entries_.pop_back();
}

Status RigForward::RunMotion(const PhsParams& params, const RigMotion& motion,
                             std::shared_ptr<const rigs::KeptRun>* kept, Channels* out) const {
  Result<RigModel> rig = RigModel::Create(data_.kind, params, options_);
  if (!rig.ok()) return rig.status();
  RigPrediction prediction;
  if (Status s = rig.value().Run(motion, &prediction, kept); !s.ok()) return s;
  out->clear();
  for (const int index : output_index_) out->push_back(std::move(prediction.channels[index]));
  return {};
}

Status RigForward::RunSpan(const PhsParams& params, Span span, Channels* out) const {
  std::shared_ptr<const rigs::KeptRun> kept;
  if (span == Span::kWhole) return RunMotion(params, full_, &kept, out);
  const PhsParams of = rigs::KeptOf(data_.kind, params);
  kept = memory_.Find(of);
  const bool known = kept != nullptr;
  Status done = RunMotion(params, short_, &kept, out);
  if (!known && kept != nullptr) memory_.Keep(of, std::move(kept));
  return done;
}

Status RigForward::UncertaintySpan(const PhsParams& params, Span span, Channels* deviation) const {
  const RigMotion& motion = span == Span::kWhole ? full_ : short_;
  const int stride = span == Span::kWhole ? 1 : stride_;
  const auto run = [&](double deviations, Channels* out) {
    RigMotion shifted = motion;
    for (size_t a = 0; a < shifted.speed_m_s.size(); ++a) {
      for (size_t i = 0; i < shifted.speed_m_s[a].size(); ++i) {
        shifted.speed_m_s[a][i] += deviations * data_.motion[a].speed_deviation[i * stride];
      }
    }
    std::shared_ptr<const rigs::KeptRun> kept;
    return RunMotion(params, shifted, &kept, out);
  };
  Status done = SpreadOverSpeed(run, deviation);
  if (!done.ok()) return done;
  return AddDraws(params, span, deviation);
}

Status RigForward::RunAt(const std::vector<SmoothMotion>& ways, const PhsParams& params, Span span,
                         Channels* out) const {
  std::shared_ptr<const rigs::KeptRun> kept;
  return RunMotion(params, MotionOf(ways, span), &kept, out);
}

Status RigForward::DrawnErrors(const PhsParams& params, Span span,
                               std::vector<Channels>* draws) const {
  draws->clear();
  Channels plain;
  if (Status s = RunSpan(params, span, &plain); !s.ok()) return s;
  for (const std::vector<SmoothMotion>& draw : redrawn_->Draws()) {
    Channels& error = draws->emplace_back();
    if (Status s = RunAt(draw, params, span, &error); !s.ok()) return s;
    for (size_t c = 0; c < error.size(); ++c) {
      for (size_t i = 0; i < error[c].size(); ++i) error[c][i] -= plain[c][i];
      if (!std::all_of(error[c].begin(), error[c].end(),
                       [](double y) { return std::isfinite(y); })) {
        return Error{params.name, "no finite answer to the motion with other noise"};
      }
    }
  }
  return {};
}

Status RigForward::AddDraws(const PhsParams& params, Span span, Channels* deviation) const {
  constexpr double kReach = 0.05;  // [s]
  std::vector<Channels> draws;
  if (Status s = DrawnErrors(params, span, &draws); !s.ok()) return s;
  const double step = span == Span::kWhole ? full_.step_s : short_.step_s;
  for (size_t c = 0; c < deviation->size(); ++c) {
    std::vector<std::vector<double>> errors;
    errors.reserve(draws.size());
    for (Channels& draw : draws) errors.push_back(std::move(draw[c]));
    const std::vector<double> none((*deviation)[c].size(), 0.0);
    const std::vector<double> drawn = DeviationOfDraws(errors, none, step, kReach);
    for (size_t i = 0; i < drawn.size(); ++i) {
      (*deviation)[c][i] = std::max((*deviation)[c][i], drawn[i]);
    }
  }
  return {};
}

Result<FormulaFrame> RigForward::Frame(const PhsParams& params, const std::string& channel) const {
  if (data_.kind != rigs::RigKind::kQuarter && data_.kind != rigs::RigKind::kCylinder) {
    return ForwardModel::Frame(params, channel);
  }
  constexpr double kRamp = 2e-4;  // [m/s]
  PhsParams bare = params;        // pressures themselves, without the errors of their sensors
  std::erase_if(bare.effects, [](const auto& e) { return e.name.starts_with("sensor_"); });
  Result<RigModel> rig = RigModel::Create(data_.kind, bare, options_);
  if (!rig.ok()) return rig.error();
  RigPrediction prediction;
  if (Status s = rig.value().Run(short_, &prediction); !s.ok()) return s.error();
  const auto& cylinder = params.cylinders.front();
  const auto rest = [&](const std::string& line) {
    const int l = params.FindLine(line);
    return l >= 0 ? params.lines[static_cast<size_t>(l)].static_pressure_Pa : 0;
  };
  const double bore = rest(cylinder.bore_line), rod = rest(cylinder.rod_line);
  FormulaFrame frame;
  std::vector<hydraulics::ForcePlace>& out = frame.places.emplace_back();
  for (const int row : rows()) {
    const auto i = static_cast<size_t>(row);
    hydraulics::ForcePlace at;
    at.time = short_.t0_s + row * short_.step_s;
    at.piston = prediction.channels[0][i];
    at.speed = short_.speed_m_s[0][i];
    at.direction = std::clamp(at.speed / kRamp, -1.0, 1.0);
    at.bore_rise = prediction.channels[2][i] - bore;
    at.rod_rise = prediction.channels[3][i] - rod;
    at.force = prediction.channels[1][i];
    at.temperature = rig.value().system().Ambient(at.time) - params.temperature_K;
    out.push_back(at);
  }
  frame.rows = [](const Channels& values) { return values; };
  frame.has_pressure = true, frame.has_rod_pressure = data_.kind == rigs::RigKind::kQuarter;
  frame.has_friction = channel == "load_cell_N", frame.has_speed = true;
  frame.has_load = true;
  frame.has_time_waves = true;
  return frame;
}

FreeModel RigForward::Declared(const PhsParams& declared) const {
  return DeclaredModel(declared, data_.free);
}

namespace {

/// A wave of which a sixth or less is seen cannot be told from a ramp that bends, and runs away
/// beyond the window.
void BoundPeriods(double longest, std::vector<FreeParameter>* free) {
  for (FreeParameter& p : *free) {
    if (p.name.ends_with(".period_s")) p.high = std::max(std::min(p.high, longest), 1.01 * p.low);
  }
}

/// What begins or ends in the record does so between a tenth and five sixths of the estimation
/// window, so that it is seen without and with; its starts are counted from the window's begin.
void BoundOnsets(const std::array<double, 2>& window, std::vector<FreeParameter>* free,
                 std::vector<std::vector<double>>* starts) {
  for (size_t i = 0; i < free->size(); ++i) {
    FreeParameter& p = (*free)[i];
    if (!IsInstant(p.name)) continue;
    const double length = window[1] - window[0];
    p.low = window[0] + 0.1 * length, p.high = window[0] + length * 5 / 6;
    p.logarithmic = false, p.scale = length / 10;
    for (std::vector<double>& start : *starts) start[i] += window[0];
  }
}

/// Starts are where the bounds allow them.
void BoundStarts(const std::vector<FreeParameter>& free, std::vector<std::vector<double>>* starts) {
  for (std::vector<double>& start : *starts) {
    for (size_t i = 0; i < free.size(); ++i) {
      start[i] = std::clamp(start[i], free[i].low, free[i].high);
    }
  }
}

}  // namespace

std::vector<Candidate> RigForward::Candidates(const PhsParams& params) const {
  std::vector<Candidate> out = ListCandidates(params, data_.kind);
  const double longest = 6 * (data_.estimation[1] - data_.estimation[0]);
  for (Candidate& candidate : out) {
    BoundPeriods(longest, &candidate.free);
    BoundOnsets(data_.estimation, &candidate.free, &candidate.starts);
    BoundStarts(candidate.free, &candidate.starts);
    for (EffectOption& option : candidate.options) {
      BoundPeriods(longest, &option.free);
      BoundOnsets(data_.estimation, &option.free, &option.starts);
      BoundStarts(option.free, &option.starts);
    }
  }
  const auto& asked = data_.candidates;
  std::erase_if(out, [&](const Candidate& c) {
    return !asked.empty() && std::find(asked.begin(), asked.end(), c.effect) == asked.end();
  });
  AddOwnCandidates(data_.own, params, &out);
  return out;
}

std::shared_ptr<const ForwardModel> RigForward::Driven(const RigMotion& motion,
                                                       double until_s) const {
  if (data_.options.extra != nullptr) return nullptr;
  struct Own {
    FitData data;
    std::shared_ptr<const ForwardModel> forward;
  };
  const auto own = std::make_shared<Own>();
  FitData& d = own->data;
  d.kind = data_.kind, d.options = data_.options, d.step_s = motion.step_s;
  d.estimation = {0, until_s};
  const auto count = static_cast<size_t>(motion.num_samples());
  for (size_t i = 0; i < count; ++i) {
    d.time_s.push_back(motion.t0_s + static_cast<double>(i) * motion.step_s);
  }
  const std::vector<double> none(count, 0.0);
  for (size_t a = 0; a < motion.position_m.size(); ++a) {
    d.motion.push_back(
        {motion.position_m[a], motion.speed_m_s[a], motion.acceleration_m_s2[a], none, none});
    d.inputs.push_back({data_.inputs[a].name, motion.position_m[a], data_.inputs[a].noise});
  }
  for (const MeasuredChannel& c : data_.outputs) d.outputs.push_back({c.name, none, c.noise});
  auto made = std::shared_ptr<RigForward>(
      new RigForward(d, std::make_shared<RedrawnMotion>(d), output_index_, 1));
  if (motion.step_s > data_.step_s) made->options_.most_substeps = kMostOfThinned;
  own->forward = std::move(made);
  return {own, own->forward.get()};
}

std::shared_ptr<const ForwardModel> RigForward::Coarse(double step_s) const {
  return std::shared_ptr<const ForwardModel>(
      new RigForward(data_, redrawn_, output_index_, StrideOf(step_s)));
}

}  // namespace phs::identify::search
