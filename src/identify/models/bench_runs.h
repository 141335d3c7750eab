// The records of a bench as one model for the search: one declared part for all records, or one for
// each, with numbers that they share and numbers of their own (joined_forward.h).
#pragma once

#include <memory>
#include <vector>

#include "identify/models/bench_forward.h"
#include "identify/models/joined_forward.h"
#include "measurement/manifest.h"

namespace phs::identify::element {

class BenchRuns {
 public:
  /// `data` must outlive it. `declared`: of the first record.
  static Result<std::unique_ptr<BenchRuns>> Create(const measurement::Manifest& manifest,
                                                   const ElementData& data,
                                                   const hydraulics::PhsParams& declared);
  std::shared_ptr<const search::ForwardModel> forward() const;
  /// What a search begins with.
  const hydraulics::PhsParams& declared() const { return declared_; }
  /// The corrected part of every record that has one of its own, or of all.
  std::vector<hydraulics::PhsParams> Models(const hydraulics::PhsParams& params) const;
  /// Force on every row of every record, in the band.
  Result<Rows> Predict(const hydraulics::PhsParams& params) const;
  /// BenchForward::Uncertain of every record.
  Result<Rows> Uncertain(const hydraulics::PhsParams& params) const;
  /// True if each record has a part of its own.
  bool own() const { return joined_ != nullptr; }

 private:
  using Asked = Result<Rows> (BenchForward::*)(const hydraulics::PhsParams&) const;
  BenchRuns() = default;
  Result<Rows> Each(Asked ask, const hydraulics::PhsParams& params) const;
  std::vector<ElementData> records_;  ///< each alone; empty: one part for all
  std::vector<std::shared_ptr<const BenchForward>> parts_;
  std::shared_ptr<const BenchForward> all_;
  std::shared_ptr<const search::JoinedForward> joined_;
  hydraulics::PhsParams declared_;
};

}  // namespace phs::identify::element
