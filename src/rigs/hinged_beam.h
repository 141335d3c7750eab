// The trailing axle of the full rig: a beam hinged at the frame, moved by cylinders 3 and 4.
//   I theta'' = -c theta' - M_h(theta') - lever (F3 - F4),   x3 = lever theta, x4 = -lever theta
// F tension forces, theta > 0 extends cylinder 3. M_h: hinge friction, regularised over 1e-4 rad/s.
// One step is backward Euler in theta with all PHS states advanced along the trial motion; the
// moments rise with the move, so secants find it (implicit_move.h). Where the beam's own mountings
// yield they begin where beam and pistons balance together (PhsSystem::BalanceBody). Play in the
// joints: effect `backlash` on cylinders 3 and 4.
// A bristle that was bent farther than its speed holds gives way as it slides: about a turn a long
// step (20 ms) may so have two solutions, some micrometres apart, both as near to that of short
// steps.
#pragma once

#include <vector>

#include "hydraulics/phs_system.h"
#include "rigs/implicit_move.h"
#include "rigs/rig.h"

namespace phs::rigs {

class HingedBeam {
 public:
  /// At rest at time t with cylinders 1 and 2 at x1, x2.
  HingedBeam(const hydraulics::PhsSystem& system, const BeamParams& params, double t, double x1,
             double x2);

  /// Outputs now, cylinders 1 and 2 moving at v1, v2.
  void Calc(double v1, double v2, hydraulics::PhsOutputs* out) const;
  /// Advances the beam and the PHS by h, cylinders 1 and 2 moving to x1, x2.
  void Step(double h, double x1, double x2);
  double angle() const { return angle_; }

 private:
  double Imbalance(const hydraulics::CarriedBody& beam, double h, double move, double* v);

  const hydraulics::PhsSystem& system_;
  BeamParams params_;
  double x_[4];            ///< of the cylinders [m]
  double before_[4] = {};  ///< mean speeds of the cylinders over the last step [m/s]
  double way_[4] = {};     ///< of pistons behind yielding mountings, over the last step [m]
  double angle_ = 0, speed_ = 0, last_speed_ = 0;  ///< now, and speed one step before
  MoveGuess guess_;
  std::vector<double> state_, rate_, next_;
  hydraulics::Instant instants_[2];  ///< now, and at the end of the step that is tried
  int now_ = 0;
};

}  // namespace phs::rigs
