#include "identify/models/bench_forward.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "identify/models/element_places.h"
#include "measurement/redrawn_motion.h"
#include "rigs/element_drive.h"

namespace phs::identify::element {

using hydraulics::PhsParams;
using rigs::RigModel;
using rigs::RigPrediction;
using search::Candidate;
using search::FormulaFrame;
using search::FreeModel;

Result<std::shared_ptr<const BenchForward>> BenchForward::Create(
    const ElementData& data, const PhsParams& declared, const std::vector<std::string>& free) {
  const Sizes sizes = MeasureSizes(data);
  Result<FreeModel> model = DeclaredElement(declared, free, sizes);
  if (!model.ok()) return model.error();
  if (Result<RigModel> rig = BenchOf(declared, data.records.front()); !rig.ok()) {
    return rig.error();
  }
  return std::shared_ptr<const BenchForward>(
      new BenchForward(data, std::move(model.value()), sizes));
}

BenchForward::BenchForward(const ElementData& data, FreeModel declared, Sizes sizes)
    : data_(data), declared_(std::move(declared)), sizes_(sizes) {
  for (const ElementRecord& r : data_.records) {
    if (std::find(r.fitted.begin(), r.fitted.end(), 1) == r.fitted.end()) continue;
    search::MeasuredBlock& block = measured_.emplace_back();
    block.channel = data_.compared, block.noise = data_.noise;
    for (size_t k = 0; k < r.fitted.size(); ++k) {
      const double nothing = std::numeric_limits<double>::quiet_NaN();
      if (r.InEstimation(k)) block.values.push_back(r.fitted[k] ? r.row_value[k] : nothing);
    }
  }
}

namespace {

/// The force with fresh noise of its sensor; draw 0: as it is.
std::vector<double> Disturbed(std::vector<double> force, double deviation, unsigned draw) {
  std::mt19937 random(draw);
  std::normal_distribution<double> normal;
  if (draw == 0) return force;
  for (double& f : force) f += deviation * normal(random);
  return force;
}

/// A side channel at rest at its mean; empty stays empty.
std::vector<double> Settled(const std::vector<double>& channel, size_t count) {
  if (channel.empty()) return {};
  const double sum = std::accumulate(channel.begin(), channel.end(), 0.0);
  return std::vector<double>(count, sum / static_cast<double>(channel.size()));
}

}  // namespace

Channels BenchForward::OnFitted(const Channels& full) const {
  Channels out;
  for (size_t i = 0; i < data_.records.size(); ++i) {
    const ElementRecord& r = data_.records[i];
    if (std::find(r.fitted.begin(), r.fitted.end(), 1) == r.fitted.end()) continue;
    const std::vector<double> rows = r.band.Apply(full[i]);
    std::vector<double>& block = out.emplace_back();
    for (size_t k = 0; k < rows.size(); ++k) {
      if (r.InEstimation(k)) block.push_back(rows[k]);
    }
  }
  return out;
}

Status BenchForward::RunRecords(const PhsParams& params, double deviations, Channels* full) const {
  full->clear();
  for (const ElementRecord& record : data_.records) {
    Result<RigModel> rig = BenchOf(params, record);
    if (!rig.ok()) return rig.status();
    rigs::RigMotion motion = record.motion;
    if (deviations != 0) {
      for (size_t i = 0; i < motion.speed_m_s[0].size(); ++i) {
        motion.speed_m_s[0][i] += deviations * record.speed_deviation[i];
      }
    }
    RigPrediction prediction;
    if (Status s = rig.value().Run(motion, &prediction); !s.ok()) return s;
    full->push_back(std::move(prediction.channels[0]));
  }
  return {};
}

Status BenchForward::RunByForce(const PhsParams& params, unsigned draw, Channels* full) const {
  full->clear();
  for (const ElementRecord& record : data_.records) {
    Result<RigModel> rig = BenchOf(params, record);
    if (!rig.ok()) return rig.status();
    rigs::RigMotion motion = record.motion;
    motion.position_m = {Disturbed(record.force_N, data_.force_noise_N, draw)};
    const rigs::ElementStart start{record.start_m, record.start_m_s};
    const Status s =
        rigs::RunElementByForce(rig.value().system(), motion, start, 1, &full->emplace_back());
    if (!s.ok()) return s;
  }
  return {};
}

Status BenchForward::RunFull(const PhsParams& params, Channels* full) const {
  return data_.by_force ? RunByForce(params, 0, full) : RunRecords(params, 0, full);
}

Status BenchForward::Run(const PhsParams& params, Span span, Channels* out) const {
  if (Status s = RunFull(params, out); !s.ok()) return s;
  if (span == Span::kEstimation) *out = OnFitted(*out);
  return {};
}

Status BenchForward::Uncertainty(const PhsParams& params, Span span, Channels* deviation) const {
  if (data_.by_force) {
    if (Status s = SpreadOfDraws(params, deviation); !s.ok()) return s;
  } else {
    Channels slow;
    if (Status s = RunRecords(params, 1, deviation); !s.ok()) return s;
    if (Status s = RunRecords(params, -1, &slow); !s.ok()) return s;
    for (size_t r = 0; r < slow.size(); ++r) {
      for (size_t i = 0; i < slow[r].size(); ++i) {
        (*deviation)[r][i] = 0.5 * ((*deviation)[r][i] - slow[r][i]);
      }
    }
  }
  if (span == Span::kEstimation) *deviation = OnFitted(*deviation);
  return {};
}

Status BenchForward::SpreadOfDraws(const PhsParams& params, Channels* deviation) const {
  constexpr double kReach = 0.05;  // [s]
  Channels plain;
  if (Status s = RunByForce(params, 0, &plain); !s.ok()) return s;
  std::vector<Channels> drawn(plain.size());  // [record][draw]
  for (unsigned draw = 1; draw <= measurement::RedrawnMotion::kDraws; ++draw) {
    Channels one;
    if (Status s = RunByForce(params, draw, &one); !s.ok()) return s;
    for (size_t r = 0; r < one.size(); ++r) drawn[r].push_back(std::move(one[r]));
  }
  deviation->clear();
  for (size_t r = 0; r < plain.size(); ++r) {
    deviation->push_back(
        measurement::DeviationOfDraws(drawn[r], plain[r], data_.records[r].motion.step_s, kReach));
  }
  return {};
}

Result<FormulaFrame> BenchForward::Frame(const PhsParams& params,
                                         const std::string& channel) const {
  if (channel != "force_N" || data_.by_force ||
      params.friction.model == hydraulics::FrictionModel::kNone) {
    return ForwardModel::Frame(params, channel);
  }
  Result<FormulaPlaces> places = PlacesOf(data_, params);
  if (!places.ok()) return places.error();
  FormulaFrame frame;
  frame.places = std::move(places.value());
  frame.rows = [this](const Channels& full) { return OnFitted(full); };
  frame.has_pressure = data_.has_pressure, frame.has_temperature = data_.has_temperature;
  frame.has_friction = true;
  return frame;
}

FreeModel BenchForward::Declared(const PhsParams&) const { return declared_; }

std::vector<Candidate> BenchForward::Candidates(const PhsParams& params) const {
  Sizes sizes = sizes_;
  sizes.ramp_m_s = params.friction.ramp_speed_m_s;
  if (Result<RigModel> rig = BenchOf(params, data_.records.front()); rig.ok()) {
    const hydraulics::FrictionPlace place;
    const double level = rig.value().system().friction(0).Level(1, sizes.speed_m_s, place);
    if (level > 0) sizes.friction_N = level;
  }
  FreeModel model = declared_;
  model.params = params;
  return ListElementCandidates(model, data_, sizes);
}

std::shared_ptr<const search::ForwardModel> BenchForward::Driven(const rigs::RigMotion& motion,
                                                                 double until_s) const {
  const ElementRecord& made = data_.records.front();
  if (made.extra != nullptr || data_.by_force) return nullptr;
  struct Own {
    ElementData data;
    std::shared_ptr<const search::ForwardModel> forward;
  };
  const auto own = std::make_shared<Own>();
  own->data.noise = data_.noise, own->data.position_noise_m = data_.position_noise_m;
  own->data.has_pressure = data_.has_pressure, own->data.has_temperature = data_.has_temperature;
  own->data.compare_below_Hz = data_.compare_below_Hz;
  ElementRecord& r = own->data.records.emplace_back();
  r.motion = motion, r.estimation = {0, until_s};
  const auto count = static_cast<size_t>(motion.num_samples());
  r.motion.pressure_Pa = Settled(made.motion.pressure_Pa, count);
  r.motion.temperature_K = Settled(made.motion.temperature_K, count);
  r.speed_deviation.assign(count, 0.0), r.force_N.assign(count, 0.0);
  r.band = measurement::BandLimit(motion.step_s, data_.compare_below_Hz);
  for (size_t i = 0; i < count; i += static_cast<size_t>(r.band.stride())) {
    r.row_sample.push_back(static_cast<int>(i));
    r.row_value.push_back(0), r.row_force_N.push_back(0);
    r.fitted.push_back(r.estimation.Contains(r.Time(static_cast<int>(i))));
  }
  r.scored.assign(r.fitted.size(), 0);
  own->forward =
      std::shared_ptr<const BenchForward>(new BenchForward(own->data, declared_, sizes_));
  return {own, own->forward.get()};
}

std::shared_ptr<const search::ForwardModel> BenchForward::Coarse(double) const {
  return std::shared_ptr<const search::ForwardModel>(new BenchForward(*this));
}

Result<Rows> BenchForward::Uncertain(const PhsParams& params) const {
  Channels full;
  Rows out;
  if (!data_.by_force) return out;
  if (Status s = SpreadOfDraws(params, &full); !s.ok()) return s.error();
  for (size_t r = 0; r < full.size(); ++r) {
    std::vector<double>& rows = out.emplace_back();
    for (const int i : data_.records[r].row_sample) rows.push_back(full[r][static_cast<size_t>(i)]);
  }
  return out;
}

Result<Rows> BenchForward::Predict(const PhsParams& params) const {
  Channels full;
  if (Status s = RunFull(params, &full); !s.ok()) return s.error();
  Rows out;
  for (size_t r = 0; r < full.size(); ++r) out.push_back(data_.records[r].band.Apply(full[r]));
  return out;
}

}  // namespace phs::identify::element
