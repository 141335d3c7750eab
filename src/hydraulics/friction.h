// Friction of one cylinder: level over speed, and how the level is reached.
//
// Static: F = level(v) min(|v|/v_ramp, 1) sgn(v): continuous, steep through zero; creeps under
// load.
// Presliding (default): a bristle z of stiffness sigma0 is bent and yields (bristle.h, or another
// by an effect):
//   F = sigma0 z + sigma1 dz/dt,     dz/dt = v (1 - yield),    z_s = share level(v)/sigma0
// The part of the level that does not stick, 1 - share, follows the static law.
// Effects change the level and add forces beside (friction_laws.h).
// Signs: F adds to the tension force, F > 0 for extension (v > 0). Stored energy sigma0 z²/2;
// lost power F v - sigma0 z dz/dt >= 0.
#pragma once

#include <string>
#include <vector>

#include "hydraulics/bristle.h"
#include "hydraulics/friction_laws.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

struct FrictionForce {
  double force = 0;          ///< [N]
  double bristle_speed = 0;  ///< dz/dt [m/s]
  double lost_power = 0;     ///< [W]
};

class Friction {
 public:
  Friction() = default;
  explicit Friction(const FrictionParams& params, FrictionLaws laws = {});

  FrictionModel model() const { return model_; }
  bool depends_on_pressure() const { return depends_on_pressure_; }
  /// Largest d(force)/d(position) [N/m].
  double stiffness() const { return laws_.bristle ? laws_.bristle->Steepest() * sigma0_ : sigma0_; }
  /// Largest d(force)/d(speed) near zero speed [N s/m].
  double MaxDamping() const;

  /// Level [N] >= 0 for motion of direction `sign` at |v| = `speed`.
  double Level(int sign, double speed, const FrictionPlace& place) const;
  /// Force at bristle deflection z [m] and speed v.
  FrictionForce Calc(double v, double z, const FrictionPlace& place) const;
  /// d(force)/d(speed) where the piston goes faster, not below zero [N s/m]; `force`: that of Calc.
  double Damping(double force, double v, double z, const FrictionPlace& place) const;
  /// Direction of the friction, -1 … 1: z over its final value, or the ramp through zero speed.
  double Direction(double v, double z, const FrictionPlace& place) const;
  /// Bristle deflection after h seconds at constant v. Exact.
  double Advance(double h, double v, double z, const FrictionPlace& place) const;
  double Energy(double z) const { return 0.5 * sigma0_ * z * z; }

  /// Memories of the level laws and states of the forces beside, in their order.
  int num_memories() const { return static_cast<int>(memory_names_.size()); }
  const std::string& MemoryName(int k) const { return memory_names_[static_cast<size_t>(k)]; }
  /// Their rates; `place` holds them.
  void CalcMemoryRates(double v, double z, const FrictionPlace& place, double* rate) const;
  /// After h seconds at constant v; `memory` may be that of `place`.
  void AdvanceMemories(double h, double v, double z, const FrictionPlace& place,
                       double* memory) const;

 private:
  double Curve(int side, double speed) const;
  double Yield(double along, double z_s) const;
  double ForceBeside(double v, double z, const FrictionPlace& place) const;
  ForcePlace PlaceOfForces(double v, double z, const FrictionPlace& place) const;

  FrictionModel model_ = FrictionModel::kNone;
  FrictionCurve curve_ = FrictionCurve::kTable;
  FrictionLaws laws_;
  std::vector<const LevelLaw*> with_memory_;
  std::vector<int> memory_of_;  ///< of each level law; -1 = none
  std::vector<int> state_of_;   ///< first of each force
  std::vector<std::string> memory_names_;
  bool depends_on_pressure_ = false, needs_direction_ = false;
  double scale_ = 1;
  // Branch 0: extension, 1: retraction; speeds rising from the first point beside zero.
  std::vector<double> speed_[2], level_[2];
  double coulomb_[2] = {0, 0}, breakaway_[2] = {0, 0}, viscous_[2] = {0, 0}, ramp_[2] = {1, 1};
  double stribeck_speed_ = 1;
  double sigma0_ = 0, sigma1_ = 0, share_ = 1;
  ElastoPlastic declared_;
};

}  // namespace phs::hydraulics
