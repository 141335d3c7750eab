// The books of energy of a run: work in = change of kinetic, potential and stored energy + losses.
//
// MuJoCo's step is M (v1 - v0) = h f0 (f at the start of the step), so kinetic energy changes by
// exactly h f0 . (v0 + v1)/2 (constant M). Losses are booked over that same mean speed: the
// plugin's powers P0 hold at v0, and P over the step = P0 - Q . (v1 - v0)/2 with Q the generalised
// force of the contacts or of the PHS. Without this, the first-order energy of the step (a mass on
// a circle is given h/2 |F|^2/m by its centripetal force) would be taken for an error of the
// physics. What the powers claim and what the forces do stays compared: P0 comes from slip and
// closing speeds, Q from the forces that MuJoCo received.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "plugin/binding.h"

namespace phs::vehicle {

/// Energies and works since the start [J].
struct EnergyBook {
  double kinetic = 0;
  double stored = 0;   ///< gravity, springs, contacts, PHS; relative to the start
  double work_in = 0;  ///< drives
  double lost_creep = 0;
  double lost_contact = 0;
  double lost_dampers = 0;  ///< dampers of joints and linkages, without lent damping
  double lost_phs = 0;
  double train = 0;        ///< work at the coupler, its magnitude added up
  double lost_brakes = 0;  ///< at the blocks on the wheel treads
  double lent = 0;         ///< kinetic energy of the inertia that lent damping adds (binding.h)
  double start_kinetic = 0;
  /// Work in less everything it went into.
  double Error() const;
  /// Error over the largest of work in, work at the coupler, losses and change of kinetic energy.
  double RelativeError() const;
};

/// Keeps a book while a model is stepped.
class EnergyKeeper {
 public:
  EnergyKeeper(const mjModel* m, const plugin::Binding& binding);
  /// Before mj_step.
  void Before(const mjModel* m, const mjData* d);
  /// After mj_step with mjENBL_ENERGY: stores at the start of the step just made. Call before
  /// After.
  void Read(const mjData* d);
  /// After mj_step: what the step did.
  void After(const mjModel* m, const mjData* d);
  const EnergyBook& book() const { return book_; }

 private:
  /// Springs and dampers along tendons, at the start of the step just made.
  void ReadLinkages(const mjModel* m, const mjData* d);

  const plugin::Binding& binding_;
  EnergyBook book_;
  std::vector<double> damping_;  ///< of the joints, without what is lent
  std::vector<double> speed_;    ///< at the start of the step
  std::vector<double> spring_;   ///< forces of joint and linkage springs at the start of the step
  std::vector<double> link_damper_;  ///< forces of linkage dampers, the same
  double start_stored_ = 0;
  bool has_start_ = false;
};

}  // namespace phs::vehicle
