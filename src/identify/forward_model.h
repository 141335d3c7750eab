// A model as a fit sees it: its numbers in, the measured channels out. The search for effects knows
// no more of a model than this, so that a rig (rig_forward.h) and a bogie on its track
// (bogie_forward.h) go through the same loop.
#pragma once

#include <memory>
#include <vector>

#include "base/result.h"
#include "hydraulics/extension.h"
#include "hydraulics/phs_params.h"

namespace phs::identify::search {

struct FreeModel;
struct Candidate;
using Channels = std::vector<std::vector<double>>;  ///< [measured output][row]

/// Immutable and thread-safe: many runs are made at the same time.
class ForwardModel {
 public:
  enum class Span {
    kEstimation,  ///< in strides, from the record's start to the end of the estimation window
    kWhole        ///< every sample of the record
  };
  virtual ~ForwardModel() = default;
  /// What would have been measured. Errors: numbers that the model refuses.
  virtual Status Run(const hydraulics::PhsParams& params, Span span, Channels* out) const = 0;
  /// By how much (standard deviation) the outputs over the span are uncertain though the model be
  /// right: through what drives it, or through what its theory leaves open.
  virtual Status Uncertainty(const hydraulics::PhsParams& params, Span span,
                             Channels* deviation) const = 0;
  /// What a force of the (first) cylinder may depend on at `rows` of kEstimation, as the model says
  /// it. Error: no rig of one cylinder.
  virtual Result<std::vector<hydraulics::ForcePlace>> Places(const hydraulics::PhsParams& params,
                                                             const std::vector<int>& rows) const;
  /// The declared structure and what is free in it.
  virtual FreeModel Declared(const hydraulics::PhsParams& declared) const = 0;
  /// Every effect that may be missing, leaving out those already there.
  virtual std::vector<Candidate> Candidates(const hydraulics::PhsParams& params) const = 0;
  /// The same over the record in strides of so many samples.
  virtual std::shared_ptr<const ForwardModel> Thinned(int stride) const = 0;
};

inline Result<std::vector<hydraulics::ForcePlace>> ForwardModel::Places(
    const hydraulics::PhsParams& params, const std::vector<int>&) const {
  return Error{params.name, "has no single cylinder whose force could follow a formula", "", ""};
}

}  // namespace phs::identify::search
