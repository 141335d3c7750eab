// A model as a fit sees it: its numbers in, the measured channels out. The search for effects knows
// no more of a model than this, so that a rig (rig_forward.h), a part on a bench
// (bench_forward.h) and a bogie on its track (bogie_forward.h) go through the same loop.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/extension.h"
#include "hydraulics/phs_params.h"
#include "rigs/rig.h"

namespace phs::identify::search {

struct FreeModel;
struct Candidate;
using Channels = std::vector<std::vector<double>>;  ///< [block or measured output][row]

/// One channel of one record on the rows that are fitted.
struct MeasuredBlock {
  std::string channel;
  std::vector<double> values;  ///< NaN: takes no part
  double noise = 0;            ///< standard deviation of the sensor noise
};

/// What a formula for one channel may depend on (formula_search.h).
struct FormulaFrame {
  std::vector<std::vector<hydraulics::ForcePlace>> places;  ///< [record][sample of the model]
  /// Values at all places -> on the rows of the channel's blocks.
  std::function<Channels(const Channels& values)> rows;
  bool has_pressure = false, has_rod_pressure = false, has_temperature = false;
  bool has_friction = false;    ///< direction and speed too
  bool has_speed = false;       ///< speed alone
  bool has_load = false;        ///< what the load cell carries
  bool has_time_waves = false;  ///< one record whose places are the rows
};

/// Immutable and thread-safe: many runs are made at the same time.
class ForwardModel {
 public:
  enum class Span {
    kEstimation,  ///< the rows of Measured()
    kWhole        ///< every sample of the record
  };
  virtual ~ForwardModel() = default;
  /// What is fitted to.
  virtual const std::vector<MeasuredBlock>& Measured() const = 0;
  /// What would have been measured. Errors: numbers that the model refuses.
  virtual Status Run(const hydraulics::PhsParams& params, Span span, Channels* out) const = 0;
  /// By how much (standard deviation) the outputs over the span are uncertain though the model be
  /// right: through what drives it.
  virtual Status Uncertainty(const hydraulics::PhsParams& params, Span span,
                             Channels* deviation) const = 0;
  /// What its theory leaves open: the outputs over the span by another respectable theory less
  /// those by its own, one set for each. None: nothing is left open.
  virtual Status TheoryDifferences(const hydraulics::PhsParams& /*params*/, Span /*span*/,
                                   std::vector<Channels>* differences) const {
    differences->clear();
    return {};
  }
  /// Draws of the error that the outputs over the span have because what drives the model was
  /// measured with noise, scaled so that their powers add up to its power: where it has a colour
  /// that Uncertainty() does not tell. None: it tells all.
  virtual Status InputErrors(const hydraulics::PhsParams& /*params*/, Span /*span*/,
                             std::vector<Channels>* draws) const {
    draws->clear();
    return {};
  }
  /// What a formula for a channel may depend on. Error: it has no such channel, or no single
  /// cylinder.
  virtual Result<FormulaFrame> Frame(const hydraulics::PhsParams& params,
                                     const std::string& channel) const;
  /// True if a law of a line (a volume, a flow) may be sought in its pressures.
  virtual bool TellsLines() const { return false; }
  /// The declared structure and what is free in it.
  virtual FreeModel Declared(const hydraulics::PhsParams& declared) const = 0;
  /// Every effect that may be missing, leaving out those already there.
  virtual std::vector<Candidate> Candidates(const hydraulics::PhsParams& params) const = 0;
  /// The same channels driven by another motion, nothing measured in them; fitted are the rows
  /// before `until_s`. Null: what drives it cannot be chosen.
  virtual std::shared_ptr<const ForwardModel> Driven(const rigs::RigMotion& /*motion*/,
                                                     double /*until_s*/) const {
    return nullptr;
  }
  /// The same near `params`, for fits that begin there: over kEstimation, what says little of some
  /// numbers for all that its theory leaves open is held at those of `params`. Null: nothing is.
  virtual std::shared_ptr<const ForwardModel> About(const hydraulics::PhsParams& /*params*/) const {
    return nullptr;
  }
  /// The same over the record on a clock of about `step_s`; a model that is fast may give itself.
  virtual std::shared_ptr<const ForwardModel> Coarse(double step_s) const = 0;
  /// True if its runs take as long as those of the whole: only its rows are fewer.
  virtual bool CoarseRunsAsLong() const { return false; }
};

inline Result<FormulaFrame> ForwardModel::Frame(const hydraulics::PhsParams& params,
                                                const std::string&) const {
  return Error{params.name, "has no single cylinder whose force could follow a formula", "", ""};
}

}  // namespace phs::identify::search
