#include "identify/models/record_forward.h"

#include <algorithm>

namespace phs::identify::search {

RecordForward::RecordForward(const measurement::FitData& data, int stride) : step_s_(data.step_s) {
  const auto by = static_cast<size_t>(stride);
  for (size_t k = 0; k * by < data.time_s.size(); ++k) {
    const double t = data.time_s[k * by];
    if (t >= data.estimation[1]) break;
    if (t >= data.estimation[0]) rows_.push_back(static_cast<int>(k));
  }
  for (const measurement::MeasuredChannel& channel : data.outputs) {
    MeasuredBlock& block = measured_.emplace_back();
    block.channel = channel.name, block.noise = channel.noise;
    for (const int row : rows_)
      block.values.push_back(channel.values[static_cast<size_t>(row) * by]);
  }
}

int RecordForward::StrideOf(double step_s) const {
  return std::max(1, static_cast<int>(step_s / step_s_ + 0.01));
}

Channels RecordForward::OnRows(const Channels& span) const {
  Channels out;
  for (const std::vector<double>& channel : span) {
    std::vector<double>& block = out.emplace_back();
    block.reserve(rows_.size());
    for (const int row : rows_) block.push_back(channel[static_cast<size_t>(row)]);
  }
  return out;
}

Status RecordForward::Run(const hydraulics::PhsParams& params, Span span, Channels* out) const {
  Status done = RunSpan(params, span, out);
  if (done.ok() && span == Span::kEstimation) *out = OnRows(*out);
  return done;
}

Status RecordForward::Uncertainty(const hydraulics::PhsParams& params, Span span,
                                  Channels* deviation) const {
  Status done = UncertaintySpan(params, span, deviation);
  if (done.ok() && span == Span::kEstimation) *deviation = OnRows(*deviation);
  return done;
}

Status RecordForward::EachOnRows(Status done, Span span, std::vector<Channels>* sets) const {
  if (!done.ok() || span != Span::kEstimation) return done;
  for (Channels& one : *sets) one = OnRows(one);
  return done;
}

Status RecordForward::TheoryDifferences(const hydraulics::PhsParams& params, Span span,
                                        std::vector<Channels>* differences) const {
  return EachOnRows(TheorySpan(params, span, differences), span, differences);
}

Status RecordForward::InputErrors(const hydraulics::PhsParams& params, Span span,
                                  std::vector<Channels>* draws) const {
  return EachOnRows(InputErrorsSpan(params, span, draws), span, draws);
}

}  // namespace phs::identify::search
