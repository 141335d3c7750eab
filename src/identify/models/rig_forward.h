// A rig driven by measured motion as a fit sees it.
#pragma once

#include <list>
#include <mutex>

#include "identify/models/record_forward.h"
#include "measurement/fit_data.h"
#include "measurement/redrawn_motion.h"
#include "rigs/rig_model.h"

namespace phs::identify::search {

/// What was kept of the last runs, by what it depends on: most candidates of a search change friction
/// or instruments alone. Thread-safe.
class RunMemory {
 public:
  /// Null if there is none.
  std::shared_ptr<const rigs::KeptRun> Find(const hydraulics::PhsParams& of);
  void Keep(const hydraulics::PhsParams& of, std::shared_ptr<const rigs::KeptRun> run);

 private:
  struct Entry {
    hydraulics::PhsParams of;  ///< rigs::KeptOf
    std::shared_ptr<const rigs::KeptRun> run;
  };
  std::mutex mutex_;
  std::list<Entry> entries_;  ///< last used first
};

class RigForward final : public RecordForward {
 public:
  /// `data` must outlive it. Error: the declared model does not fit the rig.
  static Result<std::shared_ptr<const RigForward>> Create(const measurement::FitData& data,
                                                          const hydraulics::PhsParams& declared,
                                                          int stride = 1);

  Result<FormulaFrame> Frame(const hydraulics::PhsParams& params,
                             const std::string& channel) const override;
  bool TellsLines() const override { return data_.kind != rigs::RigKind::kFull; }
  FreeModel Declared(const hydraulics::PhsParams& declared) const override;
  std::vector<Candidate> Candidates(const hydraulics::PhsParams& params) const override;
  std::shared_ptr<const ForwardModel> Driven(const rigs::RigMotion& motion,
                                             double until_s) const override;
  std::shared_ptr<const ForwardModel> Coarse(double step_s) const override;
  Status RunSpan(const hydraulics::PhsParams& params, Span span, Channels* out) const override;
  /// Through what remains uncertain of the driving speed: where friction is steep (near standstill)
  /// a sample says little; and through what remains uncertain of the way (redrawn_motion.h), which
  /// presses oil and bends bristles: the larger of the two.
  Status UncertaintySpan(const hydraulics::PhsParams& params, Span span,
                         Channels* deviation) const override;
  /// At other ways of the pistons than the measured ones: [actuator], of the whole record.
  Status RunAt(const std::vector<measurement::SmoothMotion>& ways,
               const hydraulics::PhsParams& params, Span span, Channels* out) const;
  /// What each motion with fresh sensor noise changes (redrawn_motion.h): [draw], over the span.
  Status DrawnErrors(const hydraulics::PhsParams& params, Span span,
                     std::vector<Channels>* draws) const;

 private:
  RigForward(const measurement::FitData& data, std::shared_ptr<measurement::RedrawnMotion> redrawn,
             std::vector<int> output_index, int stride);
  /// Samples of the whole record -> those of `short_`.
  std::vector<double> Thin(const std::vector<double>& y) const;
  rigs::RigMotion MotionOf(const std::vector<measurement::SmoothMotion>& motion, Span span) const;
  Status AddDraws(const hydraulics::PhsParams& params, Span span, Channels* deviation) const;
  Status RunMotion(const hydraulics::PhsParams& params, const rigs::RigMotion& motion,
                   std::shared_ptr<const rigs::KeptRun>* kept, Channels* out) const;

  const measurement::FitData& data_;
  rigs::RigOptions options_;
  int stride_ = 1;
  rigs::RigMotion full_;   ///< whole record
  rigs::RigMotion short_;  ///< to the end of the estimation window, in strides
  std::shared_ptr<measurement::RedrawnMotion> redrawn_;  ///< shared with the thinned
  std::vector<int> output_index_;  ///< of each measured channel in the model's outputs
  mutable RunMemory memory_;       ///< of runs on `short_`
};

}  // namespace phs::identify::search
