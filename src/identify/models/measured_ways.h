// Forces and pressures of a bogie's PHS as the answer to the measured ways of its pistons.
//
// Where every piston is measured, the likelihood of a record is that of the ways, which the whole
// vehicle decides, times that of forces and pressures given the ways, which the PHS decides alone:
//   p(ways, forces, pressures) = p(ways | vehicle, PHS) p(forces, pressures | ways, PHS)
// What presses a line is the sum of two pistons' ways that nearly cancel, so that 0.04 mm in where
// axles find their place make 15 % of it: predicted with the vehicle, gas and friction take up what
// the theory of the contact is off by. At the measured ways they do not. The ways are smoothed, and
// what stays uncertain of them counts as on a rig (rig_forward.h). What is left of their noise also
// weakens what an output seems to owe to them, by e²/s² (e: what it makes of the noise, s: all that
// it shows, rms; Fuller, Measurement Error Models, 1987, 1.1): an output that would lose more than a
// tenth stays as the vehicle predicts it. Of lines whose ways cancel that is so.
//
// A piston also trembles by less than its sensor's noise, and a smoothed way does not: a bristle
// that is moved to and fro about its bend holds less than one that is not. How much it trembles a
// run of the vehicle says, w: what the smoother takes off it, w - S(w), at instants that are not the
// measured ones. So what that does to forces and pressures is left open as theory is.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "identify/models/rig_forward.h"
#include "measurement/fit_data.h"

namespace phs::identify::search {

/// Which outputs of a record are of a PHS: indices, -1 = not measured.
struct PhsOutputsOf {
  std::vector<int> pistons, forces;  ///< of each cylinder
  std::vector<int> pressures;        ///< of each line
};

class MeasuredWays {
 public:
  /// `record` must begin at rest in the static state. Null: a piston is not measured, or missing
  /// for more than a second; no force and no pressure is told by them; the PHS has not four
  /// cylinders.
  static std::shared_ptr<const MeasuredWays> Of(const measurement::FitData& record,
                                                const PhsOutputsOf& outputs,
                                                const hydraulics::PhsParams& phs, int stride = 1);

  /// Puts forces and pressures at the measured ways in the place of what is in `out`, the outputs
  /// of the record over the span (RecordForward::RunSpan).
  Status Put(const hydraulics::PhsParams& phs, ForwardModel::Span span, Channels* out) const;
  /// The same where the pistons tremble beside what is measured, as in a run of the vehicle: its
  /// outputs, every sample of the span.
  Status PutTrembling(const hydraulics::PhsParams& phs, ForwardModel::Span span,
                      const Channels& of_vehicle, Channels* out) const;
  /// And how uncertain they are for the ways.
  Status PutUncertainty(const hydraulics::PhsParams& phs, ForwardModel::Span span,
                        Channels* deviation) const;
  /// Draws of that error (ForwardModel::InputErrors); `none`: outputs of the record without any.
  /// Where two ways nearly cancel a line's pressure has nothing else, and mostly slowly.
  Status Errors(const hydraulics::PhsParams& phs, ForwardModel::Span span, const Channels& none,
                std::vector<Channels>* draws) const;

 private:
  MeasuredWays() = default;
  /// Takes these outputs of the record, by what of the PHS they are. False: the rig refuses them.
  bool Take(const measurement::FitData& record,
            const std::vector<std::pair<int, std::string>>& which, const hydraulics::PhsParams& phs,
            int stride);
  /// Those of its outputs that the noise of the ways does not drown.
  Result<std::vector<std::pair<int, std::string>>> Told(const hydraulics::PhsParams& phs) const;
  /// The measured ways with what the smoother takes off a vehicle's [piston][sample].
  std::vector<measurement::SmoothMotion> Trembling(const Channels& of_vehicle) const;
  void PutInto(Channels&& of_phs, Channels* out) const;

  measurement::FitData data_;
  std::vector<int> output_;  ///< of data_.outputs among those of the record
  std::vector<int> piston_;  ///< of data_.inputs, too
  std::shared_ptr<const RigForward> rig_;
};

}  // namespace phs::identify::search
