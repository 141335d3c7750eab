#include "identify/bench_forward.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "identify/element_places.h"

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
    block.channel = "force_N", block.noise = data_.noise_N;
    for (size_t k = 0; k < r.fitted.size(); ++k) {
      const double nothing = std::numeric_limits<double>::quiet_NaN();
      if (r.InEstimation(k)) block.values.push_back(r.fitted[k] ? r.row_force_N[k] : nothing);
    }
  }
}

namespace {

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

Status BenchForward::Run(const PhsParams& params, Span span, Channels* out) const {
  if (Status s = RunRecords(params, 0, out); !s.ok()) return s;
  if (span == Span::kEstimation) *out = OnFitted(*out);
  return {};
}

Status BenchForward::Uncertainty(const PhsParams& params, Span span, Channels* deviation) const {
  Channels slow;
  if (Status s = RunRecords(params, 1, deviation); !s.ok()) return s;
  if (Status s = RunRecords(params, -1, &slow); !s.ok()) return s;
  for (size_t r = 0; r < slow.size(); ++r) {
    for (size_t i = 0; i < slow[r].size(); ++i) {
      (*deviation)[r][i] = 0.5 * ((*deviation)[r][i] - slow[r][i]);
    }
  }
  if (span == Span::kEstimation) *deviation = OnFitted(*deviation);
  return {};
}

Result<FormulaFrame> BenchForward::Frame(const PhsParams& params,
                                         const std::string& channel) const {
  if (channel != "force_N" || params.friction.model == hydraulics::FrictionModel::kNone) {
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
  if (made.extra != nullptr) return nullptr;
  struct Own {
    ElementData data;
    std::shared_ptr<const search::ForwardModel> forward;
  };
  const auto own = std::make_shared<Own>();
  own->data.noise_N = data_.noise_N, own->data.position_noise_m = data_.position_noise_m;
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
    r.row_sample.push_back(static_cast<int>(i)), r.row_force_N.push_back(0);
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

Result<Rows> BenchForward::Predict(const PhsParams& params) const {
  Channels full;
  if (Status s = RunRecords(params, 0, &full); !s.ok()) return s.error();
  Rows out;
  for (size_t r = 0; r < full.size(); ++r) out.push_back(data_.records[r].band.Apply(full[r]));
  return out;
}

}  // namespace phs::identify::element
