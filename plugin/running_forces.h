// Traction and braking while the vehicle runs at a held speed: what the drives and the brake blocks
// do to the axles, and the train that takes or gives the difference at the coupler.
//
//   per driven axle   torque T of the motor, > 0 forward (traction), < 0 backward (electric brake)
//   per wheel         blocks pressed on with N in all. They are clasp brakes: blocks stand on both
//                     sides, their normal forces cancel, and friction is a pure moment mu N r
//                     against the rotation, reacted by the frame
//   at the coupler    a force along the vehicle that holds the speed:
//                     -(sum of the moments above)/r, corrected by the speed error with a time
//                     constant of 0.5 s
//
// Moments rise linearly from `begin_s` over `ramp_s`, and from `end_s` on fall likewise. The coupler
// is the site "coupler" of the model: at the height of the traction rods on a single bogie, at the
// drawgear of a whole locomotive.
#pragma once

namespace phs::plugin {

struct RunningForces {
  bool active = false;           ///< false: the drives hold the speed and nothing else acts
  double drive_torque_Nm = 0;    ///< per driven axle, |T| <= 1e6
  double block_force_N = 0;      ///< N of one wheel's blocks together, 0 … 1e6
  double block_friction = 0.25;  ///< mu of blocks on wheel treads, 0 < mu <= 1
  double begin_s = 0;
  double ramp_s = 1;  ///< > 0
  double end_s = 0;   ///< 0: they stay; else >= begin_s + ramp_s

  /// Share of the moments at a time, 0 … 1.
  double Share(double time) const {
    const bool falls = end_s > 0 && time > end_s;
    const double x = falls ? 1 - (time - end_s) / ramp_s : (time - begin_s) / ramp_s;
    return x < 0 ? 0 : x > 1 ? 1 : x;
  }
};

}  // namespace phs::plugin
