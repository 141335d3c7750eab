#include "identify/measured_ways.h"

#include <algorithm>
#include <cmath>

namespace phs::identify::search {

using measurement::FitData;
using measurement::MeasuredChannel;
using measurement::SmoothPosition;
namespace {

constexpr size_t kCylinders = 4;       // all driven: rigs::RigKind::kFull
constexpr double kLongestGap_s = 1.0;  // what slid meanwhile nobody knows

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
  return data->motion.size() == kCylinders;
}

}  // namespace

std::shared_ptr<const MeasuredWays> MeasuredWays::Of(const FitData& record,
                                                     const PhsOutputsOf& outputs,
                                                     const hydraulics::PhsParams& phs, int stride) {
  if (phs.cylinders.size() != kCylinders) return nullptr;
  std::shared_ptr<MeasuredWays> out(new MeasuredWays);
  FitData& data = out->data_;
  data.kind = rigs::RigKind::kFull, data.options.actuators = kCylinders;
  data.source = record.source, data.time_s = record.time_s, data.step_s = record.step_s;
  data.estimation = record.estimation, data.validation = record.validation;
  if (!TakeWays(record, outputs.pistons, &data)) return nullptr;
  const auto take = [&](int index, const std::string& name) {
    if (index < 0) return;
    data.outputs.push_back(record.outputs[static_cast<size_t>(index)]);
    data.outputs.back().name = name;
    out->output_.push_back(index);
  };
  for (size_t c = 0; c < kCylinders; ++c) {
    take(outputs.forces[c], "load" + phs.cylinders[c].name + "_N");
  }
  for (size_t l = 0; l < phs.lines.size(); ++l) {
    take(outputs.pressures[l], "p" + phs.lines[l].name + "_Pa");
  }
  if (data.outputs.empty()) return nullptr;
  auto rig = RigForward::Create(data, phs, stride);
  if (!rig.ok()) return nullptr;
  out->rig_ = std::move(rig).value();
  return out;
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

Status MeasuredWays::PutUncertainty(const hydraulics::PhsParams& phs, ForwardModel::Span span,
                                    Channels* deviation) const {
  Channels of_phs;
  if (Status s = rig_->UncertaintySpan(phs, span, &of_phs); !s.ok()) return s;
  for (std::vector<double>& row : of_phs) {
    for (double& x : row) x = std::abs(x);
  }
  PutInto(std::move(of_phs), deviation);
  return {};
}

}  // namespace phs::identify::search
