#include "identify/models/measured_ways.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace phs::identify::search {

using measurement::FitData;
using measurement::MeasuredChannel;
using measurement::SmoothMotion;
using measurement::SmoothPosition;
namespace {

constexpr size_t kPistons = 4;         // all driven: rigs::RigKind::kFull
constexpr double kLongestGap_s = 1.0;  // what slid meanwhile nobody knows
constexpr double kMostLost = 0.1;      // of what an output owes to the ways

double MeanSquare(const std::vector<double>& y, double about) {
  double sum = 0;
  for (const double x : y) sum += (x - about) * (x - about);
  return sum / static_cast<double>(y.size());
}

/// A way, and which of its samples were not measured; these hold what was measured before.
struct Way {
  std::vector<double> samples;
  std::vector<char> bad;
  int longest_gap = 0;  ///< [samples]
};

Way ReadWay(const MeasuredChannel& piston) {
  Way way{piston.values, std::vector<char>(piston.values.size(), 0)};
  int gap = 0;
  double last = 0;
  for (size_t i = 0; i < way.samples.size(); ++i) {
    double& x = way.samples[i];
    way.bad[i] = !std::isfinite(x);
    gap = way.bad[i] ? gap + 1 : 0;
    way.longest_gap = std::max(way.longest_gap, gap);
    (way.bad[i] ? x : last) = way.bad[i] ? last : x;
  }
  return way;
}

/// False if a way is not known well enough to drive anything.
bool TakeWays(const FitData& record, const std::vector<int>& pistons, FitData* data) {
  for (const int piston : pistons) {
    if (piston < 0) return false;
    const MeasuredChannel& measured = record.outputs[static_cast<size_t>(piston)];
    Way way = ReadWay(measured);
    if (way.longest_gap * record.step_s > kLongestGap_s) return false;
    data->motion.push_back(
        SmoothPosition(way.samples, way.bad, record.step_s, std::max(measured.noise, 1e-12)));
    data->inputs.push_back({measured.name, std::move(way.samples), measured.noise});
  }
  return data->motion.size() == kPistons;
}

}  // namespace

std::shared_ptr<const MeasuredWays> MeasuredWays::Of(const FitData& record,
                                                     const PhsOutputsOf& outputs,
                                                     const hydraulics::PhsParams& phs, int stride) {
  if (phs.cylinders.size() != kPistons) return nullptr;
  std::shared_ptr<MeasuredWays> out(new MeasuredWays);
  FitData& data = out->data_;
  data.kind = rigs::RigKind::kFull, data.options.actuators = kPistons;
  data.source = record.source, data.time_s = record.time_s, data.step_s = record.step_s;
  data.estimation = record.estimation, data.validation = record.validation;
  if (!TakeWays(record, outputs.pistons, &data)) return nullptr;
  out->piston_ = outputs.pistons;
  std::vector<std::pair<int, std::string>> which;
  for (size_t c = 0; c < kPistons; ++c) {
    which.emplace_back(outputs.forces[c], "load" + phs.cylinders[c].name + "_N");
  }
  for (size_t l = 0; l < phs.lines.size(); ++l) {
    which.emplace_back(outputs.pressures[l], "p" + phs.lines[l].name + "_Pa");
  }
  std::erase_if(which, [](const auto& output) { return output.first < 0; });
  if (!out->Take(record, which, phs, 1)) return nullptr;
  auto told = out->Told(phs);
  if (!told.ok() || !out->Take(record, told.value(), phs, stride)) return nullptr;
  return out;
}

bool MeasuredWays::Take(const FitData& record,
                        const std::vector<std::pair<int, std::string>>& which,
                        const hydraulics::PhsParams& phs, int stride) {
  data_.outputs.clear(), output_.clear();
  for (const auto& [index, name] : which) {
    data_.outputs.push_back(record.outputs[static_cast<size_t>(index)]);
    data_.outputs.back().name = name;
    output_.push_back(index);
  }
  if (which.empty()) return false;
  auto rig = RigForward::Create(data_, phs, stride);
  if (!rig.ok()) return false;
  rig_ = std::move(rig).value();
  return true;
}

Result<std::vector<std::pair<int, std::string>>> MeasuredWays::Told(
    const hydraulics::PhsParams& phs) const {
  Channels shown;
  if (Status s = rig_->RunSpan(phs, ForwardModel::Span::kWhole, &shown); !s.ok()) {
    return s.error();
  }
  std::vector<Channels> draws;
  if (Status s = rig_->DrawnErrors(phs, ForwardModel::Span::kWhole, &draws); !s.ok()) {
    return s.error();
  }
  std::vector<std::pair<int, std::string>> told;
  for (size_t c = 0; c < shown.size(); ++c) {
    double of_noise = 0;
    for (const Channels& draw : draws) of_noise += MeanSquare(draw[c], 0);
    of_noise /= static_cast<double>(draws.size());
    const double mean = std::accumulate(shown[c].begin(), shown[c].end(), 0.0) /
                        static_cast<double>(shown[c].size());
    if (of_noise <= kMostLost * MeanSquare(shown[c], mean)) {
      told.emplace_back(output_[c], data_.outputs[c].name);
    }
  }
  return told;
}

void MeasuredWays::PutInto(Channels&& of_phs, Channels* out) const {
  for (size_t c = 0; c < output_.size(); ++c) {
    (*out)[static_cast<size_t>(output_[c])] = std::move(of_phs[c]);
  }
}

Status MeasuredWays::Put(const hydraulics::PhsParams& phs, ForwardModel::Span span,
                         Channels* out) const {
  Channels of_phs;
  if (Status s = rig_->RunSpan(phs, span, &of_phs); !s.ok()) return s;
  PutInto(std::move(of_phs), out);
  return {};
}

std::vector<SmoothMotion> MeasuredWays::Trembling(const Channels& of_vehicle) const {
  std::vector<SmoothMotion> out = data_.motion;
  for (size_t a = 0; a < piston_.size(); ++a) {
    std::vector<double> way = of_vehicle[static_cast<size_t>(piston_[a])];
    const SmoothMotion smooth =
        SmoothPosition(way, {}, data_.step_s, std::max(data_.inputs[a].noise, 1e-12));
    for (size_t i = 0; i < way.size(); ++i) way[i] -= smooth.position[i];
    for (size_t i = 0; i < way.size(); ++i) {
      const size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, way.size() - 1);
      const double time = static_cast<double>(after - before) * data_.step_s;
      out[a].position[i] += way[i];
      out[a].speed[i] += (way[after] - way[before]) / time;
    }
    out[a].acceleration.clear();
  }
  return out;
}

Status MeasuredWays::PutTrembling(const hydraulics::PhsParams& phs, ForwardModel::Span span,
                                  const Channels& of_vehicle, Channels* out) const {
  Channels of_phs;
  if (Status s = rig_->RunAt(Trembling(of_vehicle), phs, span, &of_phs); !s.ok()) return s;
  PutInto(std::move(of_phs), out);
  return {};
}

Status MeasuredWays::PutUncertainty(const hydraulics::PhsParams& phs, ForwardModel::Span span,
                                    Channels* deviation) const {
  Channels of_phs;
  if (Status s = rig_->UncertaintySpan(phs, span, &of_phs); !s.ok()) return s;
  PutInto(std::move(of_phs), deviation);
  return {};
}

Status MeasuredWays::Errors(const hydraulics::PhsParams& phs, ForwardModel::Span span,
                            const Channels& none, std::vector<Channels>* draws) const {
  std::vector<Channels> of_phs;
  if (Status s = rig_->DrawnErrors(phs, span, &of_phs); !s.ok()) return s;
  const double share = 1 / std::sqrt(static_cast<double>(of_phs.size()));
  draws->assign(of_phs.size(), none);
  for (size_t k = 0; k < of_phs.size(); ++k) {
    for (std::vector<double>& row : of_phs[k]) {
      for (double& x : row) x *= share;
    }
    PutInto(std::move(of_phs[k]), &(*draws)[k]);
  }
  return {};
}

}  // namespace phs::identify::search
