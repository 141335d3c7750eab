// A part on a bench as a fit sees it: one or several records, the force compared in one band.
//
// The model runs at the full rate; model and measurement pass the same band limit.
#pragma once

#include "identify/fit/forward_model.h"
#include "identify/models/element_candidates.h"
#include "identify/models/element_data.h"

namespace phs::identify::element {

using search::Channels;
using Rows = std::vector<std::vector<double>>;  ///< [record][row in the band]

class BenchForward final : public search::ForwardModel {
 public:
  /// `data` must outlive it. `free`: numbers of the declared model; empty: the usual.
  /// Error: a free number that the model does not have.
  static Result<std::shared_ptr<const BenchForward>> Create(const ElementData& data,
                                                            const hydraulics::PhsParams& declared,
                                                            const std::vector<std::string>& free);

  const std::vector<search::MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const hydraulics::PhsParams& params, Span span, Channels* out) const override;
  /// Through what remains uncertain of the driving speed: where the force is steep over the speed a
  /// row says little; of a part that a force drives, through the noise of that force.
  Status Uncertainty(const hydraulics::PhsParams& params, Span span,
                     Channels* deviation) const override;
  Result<search::FormulaFrame> Frame(const hydraulics::PhsParams& params,
                                     const std::string& channel) const override;
  search::FreeModel Declared(const hydraulics::PhsParams& declared) const override;
  std::vector<search::Candidate> Candidates(const hydraulics::PhsParams& params) const override;
  std::shared_ptr<const search::ForwardModel> Driven(const rigs::RigMotion& motion,
                                                     double until_s) const override;
  std::shared_ptr<const search::ForwardModel> Coarse(double step_s) const override;

  /// Force on every row of every record, in the band.
  Result<Rows> Predict(const hydraulics::PhsParams& params) const;
  /// What the noise of the driving force makes of every row (standard deviation); empty where a
  /// motion drives.
  Result<Rows> Uncertain(const hydraulics::PhsParams& params) const;

 private:
  BenchForward(const ElementData& data, search::FreeModel declared, Sizes sizes);
  /// A signal at the full rate of every record -> on the fitted rows of those that have any.
  Channels OnFitted(const Channels& full) const;
  Status RunRecords(const hydraulics::PhsParams& params, double deviations, Channels* full) const;
  /// Driven by the force as measured (draw 0) or with fresh noise of its sensor, always the same.
  Status RunByForce(const hydraulics::PhsParams& params, unsigned draw, Channels* full) const;
  Status RunFull(const hydraulics::PhsParams& params, Channels* full) const;
  Status SpreadOfDraws(const hydraulics::PhsParams& params, Channels* deviation) const;

  const ElementData& data_;
  search::FreeModel declared_;
  Sizes sizes_;
  std::vector<search::MeasuredBlock> measured_;
};

}  // namespace phs::identify::element
