// The books of energy of a run: work in = change of kinetic, potential and stored energy + losses.
//
// Every force is taken at the speed w of its own instant (plugin/half_step.h), and kinetic energy
// w.M w/2 changes by just what the forces give at w. So powers are read at the instants and added
// up by the trapezoidal rule; what is left over is of second order in the step, unless a power does
// not belong to its force: those of contacts and PHS come from slip, closing speeds and pressures,
// not from the forces that MuJoCo received.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

#include "plugin/binding.h"

namespace phs::vehicle {

/// Energies and works since the start [J].
struct EnergyBook {
  double kinetic = 0;
  double stored = 0;   ///< gravity, springs, contacts, PHS; relative to the start
  double work_in = 0;  ///< drives, train and applied forces
  double lost_creep = 0;
  double lost_contact = 0;
  double lost_dampers = 0;  ///< elements between bodies (plugin/elements.h)
  double lost_phs = 0;
  double train = 0;        ///< work at the coupler, its magnitude added up
  double lost_brakes = 0;  ///< at the blocks on the wheel treads
  double start_kinetic = 0;
  /// Work in less everything it went into.
  double Error() const;
  /// Error over the largest of work in, work at the coupler, losses and change of kinetic energy.
  double RelativeError() const;
};

/// Keeps a book while a model is stepped.
class EnergyKeeper {
 public:
  explicit EnergyKeeper(const plugin::Binding& binding) : binding_(binding) {}
  /// After every mj_step: works and losses up to the instant that the step started from.
  void Step(const mjModel* m, const mjData* d);
  /// After an mj_step with mjENBL_ENERGY, after Step: kinetic and stored energy at that instant.
  void Read(const mjModel* m, const mjData* d);
  const EnergyBook& book() const { return book_; }

 private:
  static constexpr int kPowers = 9;

  const plugin::Binding& binding_;
  EnergyBook book_;
  std::array<double, kPowers> power_{};  ///< at the instant before [W]
  std::vector<double> momentum_;
  double start_stored_ = 0;
  bool has_power_ = false;
  bool has_start_ = false;
};

}  // namespace phs::vehicle
