// A model of one record on a uniform clock (a rig, a bogie): which of its samples are fitted.
#pragma once

#include "identify/fit/forward_model.h"
#include "measurement/fit_data.h"

namespace phs::identify::search {

class RecordForward : public ForwardModel {
 public:
  const std::vector<MeasuredBlock>& Measured() const final { return measured_; }
  Status Run(const hydraulics::PhsParams& params, Span span, Channels* out) const final;
  Status Uncertainty(const hydraulics::PhsParams& params, Span span,
                     Channels* deviation) const final;
  Status TheoryDifferences(const hydraulics::PhsParams& params, Span span,
                           std::vector<Channels>* differences) const final;
  Status InputErrors(const hydraulics::PhsParams& params, Span span,
                     std::vector<Channels>* draws) const final;

 protected:
  /// `data` must outlive it. `stride`: every so manyth sample is run.
  RecordForward(const measurement::FitData& data, int stride);
  /// kEstimation: in strides, from the record's start to the end of the estimation window.
  virtual Status RunSpan(const hydraulics::PhsParams& params, Span span, Channels* out) const = 0;
  virtual Status UncertaintySpan(const hydraulics::PhsParams& params, Span span,
                                 Channels* deviation) const = 0;
  virtual Status TheorySpan(const hydraulics::PhsParams& /*params*/, Span /*span*/,
                            std::vector<Channels>* differences) const {
    differences->clear();
    return {};
  }
  virtual Status InputErrorsSpan(const hydraulics::PhsParams& /*params*/, Span /*span*/,
                                 std::vector<Channels>* draws) const {
    draws->clear();
    return {};
  }
  /// Of each fitted row in what RunSpan gives for kEstimation.
  const std::vector<int>& rows() const { return rows_; }
  /// Samples of the record between two of a clock of about `step_s`.
  int StrideOf(double step_s) const;
  /// What RunSpan gave -> on the fitted rows.
  Channels OnRows(const Channels& span) const;

 private:
  Status EachOnRows(Status done, Span span, std::vector<Channels>* sets) const;

  double step_s_;
  std::vector<int> rows_;
  std::vector<MeasuredBlock> measured_;
};

}  // namespace phs::identify::search
