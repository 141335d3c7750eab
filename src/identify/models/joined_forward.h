// Several measured runs as one model for the search: each run has a declared model of its own,
// numbers that all runs share and numbers that each has for itself.
//
// A number of one run is called "run2.L1.gas_volume_m3" (PhsParams::of_runs). Effects, their
// numbers and a formula are shared. Where runs declare different values of a shared number, the fit
// begins at their geometric mean.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "identify/fit/forward_model.h"
#include "identify/fit/search_fit.h"
#include "measurement/joined_data.h"

namespace phs::identify::search {

/// One run.
struct JoinedPart {
  std::shared_ptr<const ForwardModel> forward;
  hydraulics::PhsParams declared;
};

class JoinedForward final : public ForwardModel {
 public:
  /// `shared`: names of free numbers with one value for all. `data` gives what a whole run is
  /// joined by; null: kWhole is not asked for. `lead` lists the candidates; null: the first part.
  /// Error: a shared name that is not free.
  static Result<std::shared_ptr<const JoinedForward>> Create(
      std::vector<JoinedPart> parts, const std::vector<std::string>& shared,
      std::shared_ptr<const measurement::JoinedData> data,
      std::shared_ptr<const ForwardModel> lead = nullptr);

  const std::vector<MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const hydraulics::PhsParams& params, Span span, Channels* out) const override;
  Status Uncertainty(const hydraulics::PhsParams& params, Span span,
                     Channels* deviation) const override;
  /// One error for all runs.
  Status TheoryDifferences(const hydraulics::PhsParams& params, Span span,
                           std::vector<Channels>* differences) const override;
  Status InputErrors(const hydraulics::PhsParams& params, Span span,
                     std::vector<Channels>* draws) const override;
  Result<FormulaFrame> Frame(const hydraulics::PhsParams& params,
                             const std::string& channel) const override;
  bool TellsLines() const override;
  FreeModel Declared(const hydraulics::PhsParams& declared) const override;
  std::vector<Candidate> Candidates(const hydraulics::PhsParams& params) const override;
  std::shared_ptr<const ForwardModel> Driven(const rigs::RigMotion& motion,
                                             double until_s) const override;
  std::shared_ptr<const ForwardModel> About(const hydraulics::PhsParams& params) const override;
  std::shared_ptr<const ForwardModel> Coarse(double step_s) const override;
  bool CoarseRunsAsLong() const override { return parts_.front().forward->CoarseRunsAsLong(); }

  /// The model of one run with the numbers and effects of the whole.
  hydraulics::PhsParams ParamsOf(const hydraulics::PhsParams& all, size_t run) const;
  /// What a search begins with: the first run's model, with the own numbers of all.
  const hydraulics::PhsParams& declared() const { return declared_; }

 private:
  using Asked = Status (ForwardModel::*)(const hydraulics::PhsParams&, Span, Channels*) const;
  using AskedSets = Status (ForwardModel::*)(const hydraulics::PhsParams&, Span,
                                             std::vector<Channels>*) const;
  JoinedForward() = default;
  /// Sets of every run, side by side; none where a run has none.
  Status EachSet(AskedSets ask, const hydraulics::PhsParams& params, Span span,
                 std::vector<Channels>* out) const;
  Status Each(Asked ask, const hydraulics::PhsParams& params, Span span, Channels* out) const;
  /// What whole runs gave, on the joined clock.
  Channels Join(const std::vector<Channels>& runs) const;

  std::vector<JoinedPart> parts_;
  std::vector<char> fitted_;  ///< of each run: it has rows of its own in Measured()
  std::shared_ptr<const measurement::JoinedData> data_;
  std::shared_ptr<const ForwardModel> lead_;
  std::vector<std::string> shared_, own_;  ///< free numbers
  FreeModel free_;
  hydraulics::PhsParams declared_;
  std::vector<MeasuredBlock> measured_;
};

/// Name of a number that run `run`, counted from 0, has for itself.
std::string NameOfRun(size_t run, const std::string& number);

}  // namespace phs::identify::search
