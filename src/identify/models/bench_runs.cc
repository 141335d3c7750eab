#include "identify/models/bench_runs.h"

#include <algorithm>
#include <iterator>

namespace phs::identify::element {

using hydraulics::PhsParams;
using measurement::Manifest;

Result<std::unique_ptr<BenchRuns>> BenchRuns::Create(const Manifest& manifest,
                                                     const ElementData& data,
                                                     const PhsParams& declared) {
  auto out = std::unique_ptr<BenchRuns>(new BenchRuns);
  auto all = BenchForward::Create(data, declared, manifest.free);
  if (!all.ok()) return all.error();
  out->all_ = all.value(), out->declared_ = declared;
  if (!measurement::HasOwnModels(manifest)) return out;
  for (const ElementRecord& record : data.records) {
    ElementData& one = out->records_.emplace_back(data);
    one.records = {record};
  }
  std::vector<search::JoinedPart> parts;
  for (size_t r = 0; r < out->records_.size(); ++r) {
    const auto own = measurement::DeclaredModel(measurement::OfRun(manifest, r));
    if (!own.ok()) return own.error();
    auto forward = BenchForward::Create(out->records_[r], own.value(), manifest.free);
    if (!forward.ok()) return forward.error();
    out->parts_.push_back(forward.value());
    parts.push_back({forward.value(), own.value()});
  }
  auto joined =
      search::JoinedForward::Create(std::move(parts), manifest.shared, nullptr, out->all_);
  if (!joined.ok()) {
    Error error = joined.error();
    error.where = manifest.path + ": " + error.where;
    return error;
  }
  out->joined_ = joined.value(), out->declared_ = joined.value()->declared();
  return out;
}

std::shared_ptr<const search::ForwardModel> BenchRuns::forward() const {
  if (joined_ != nullptr) return joined_;
  return all_;
}

std::vector<PhsParams> BenchRuns::Models(const PhsParams& params) const {
  if (joined_ == nullptr) return {params};
  std::vector<PhsParams> out;
  for (size_t r = 0; r < parts_.size(); ++r) {
    out.push_back(joined_->ParamsOf(params, r));
    out.back().of_runs.clear();
  }
  return out;
}

Result<Rows> BenchRuns::Each(Asked ask, const PhsParams& params) const {
  if (joined_ == nullptr) return (all_.get()->*ask)(params);
  Rows out;
  for (size_t r = 0; r < parts_.size(); ++r) {
    Result<Rows> own = (parts_[r].get()->*ask)(joined_->ParamsOf(params, r));
    if (!own.ok()) return own.error();
    std::move(own.value().begin(), own.value().end(), std::back_inserter(out));
  }
  return out;
}

Result<Rows> BenchRuns::Predict(const PhsParams& params) const {
  return Each(&BenchForward::Predict, params);
}

Result<Rows> BenchRuns::Uncertain(const PhsParams& params) const {
  return Each(&BenchForward::Uncertain, params);
}

}  // namespace phs::identify::element
