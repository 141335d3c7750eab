// Friction of one cylinder: level over speed, and how the level is reached.
//
// Static: F = level(v) min(|v|/v_ramp, 1) sgn(v).
// It is continuous and steep through zero, and creeps under load.
//
// Presliding (default): the elasto-plastic single-state model of Dupont, Hayward, Armstrong and
// Altpeter (IEEE Trans. Automatic Control 47 (2002) 787), with a blending that integrates exactly:
//   F = sigma0 z + sigma1 dz/dt + c v,     dz/dt = v (1 - alpha z/z_s),    z_s = level(v)/sigma0
//   alpha = 0 for |z| < z_b = r z_s or where z and v point in opposite directions,
//   alpha = (|z| - z_b)/(z_s - z_b) beyond.
// Below z_b the displacement is purely elastic: the piston sticks without creep however long it is
// held or shaken. For v of one sign the plastic part is a Riccati equation with the solution
//   q = (z_s - |z|)/(|z| + z_s - z_b),   q(x) = q(0) exp(-k x),
//   k = (2 z_s - z_b)/(z_s (z_s - z_b))
// so the update over any step is exact and unconditionally stable.
// With presliding_creeps instead the bristle of Dahl (1968) and of Canudas de Wit, Olsson, Astrom
// and Lischinsky (LuGre, IEEE Trans. Automatic Control 40 (1995) 419), with Dahl's exponent i:
//   dz/dt = v g^i,   g = 1 - sgn(v) z/z_s.   i = 1: z_s - |z| falls as exp(-x/z_s) in sliding;
//   else g^(1-i) = g(0)^(1-i) + (i - 1) x/z_s: exact over any step. It creeps when shaken.
// With presliding_share < 1 only that share of the level sticks, the rest follows the static law.
// Signs: F adds to the tension force, F > 0 for extension (v > 0). Stored energy sigma0 z²/2;
// lost power F v - sigma0 z dz/dt >= 0.
#pragma once

#include <cmath>
#include <vector>

#include "hydraulics/extension.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// What a friction level may depend on beside speed.
struct FrictionPlace {
  double bore_rise = 0;  ///< p_bore above static [Pa]
  double rod_rise = 0;   ///< p_rod above static [Pa]
  double piston = 0;     ///< y [m]
  double rested = 1;     ///< dwell state phi, 0 just moved … 1 long at rest
  double time = 0;       ///< [s]
  double warmer = 0;     ///< temperature above the model's [K]
};

struct FrictionForce {
  double force = 0;          ///< [N]
  double bristle_speed = 0;  ///< dz/dt [m/s]
  double lost_power = 0;     ///< [W]
};

class Friction {
 public:
  Friction() = default;
  Friction(const FrictionParams& params, const FrictionTerms& terms);

  FrictionModel model() const { return model_; }
  bool has_dwell() const { return terms_.dwell_extra_N != 0; }
  bool depends_on_pressure() const {
    return terms_.pressure_bore_N_per_Pa != 0 || terms_.pressure_rod_N_per_Pa != 0 ||
           terms_.pressure_difference_N_per_Pa != 0 || terms_.further != nullptr;
  }
  /// Largest d(force)/d(position) [N/m]: that of a creeping bristle is behind a reversal, g = 2.
  double stiffness() const { return creeps_ ? std::exp2(exponent_) * sigma0_ : sigma0_; }
  /// Largest d(force)/d(speed) near zero speed [N s/m].
  double MaxDamping() const;

  /// Level [N] >= 0 for motion of direction `sign` at |v| = `speed`.
  double Level(int sign, double speed, const FrictionPlace& place) const;
  /// Force at bristle deflection z [m] and speed v.
  FrictionForce Calc(double v, double z, const FrictionPlace& place) const;
  /// d(force)/d(speed) where the piston goes faster, not below zero [N s/m].
  double Damping(double v, double z, const FrictionPlace& place) const;
  /// Direction of the friction, -1 … 1: z over its final value, or the ramp through zero speed.
  double Direction(double v, double z, const FrictionPlace& place) const;
  /// Bristle deflection after h seconds at constant v. Exact.
  double Advance(double h, double v, double z, const FrictionPlace& place) const;
  /// Dwell state eta = 1 - phi (0 = long at rest) after h seconds at constant v. Exact.
  double AdvanceDwell(double h, double v, double eta) const;
  double DwellRate(double v, double eta) const;
  double Energy(double z) const { return 0.5 * sigma0_ * z * z; }

 private:
  double Curve(int sign, double speed) const;
  double PositionFactor(double piston) const;
  double Viscous(double v) const;
  double Further(double v, double z, const FrictionPlace& place) const;

  FrictionModel model_ = FrictionModel::kNone;
  FrictionCurve curve_ = FrictionCurve::kTable;
  FrictionTerms terms_;
  double scale_ = 1;
  // Branch 0: extension, 1: retraction; speeds rising from the first point beside zero.
  std::vector<double> speed_[2], level_[2];
  double coulomb_[2] = {0, 0}, breakaway_[2] = {0, 0}, viscous_[2] = {0, 0}, ramp_[2] = {1, 1};
  double extra_[2] = {0, 0}, extra_viscous_[2] = {0, 0};
  double stribeck_speed_ = 1;
  double sigma0_ = 0, sigma1_ = 0, ratio_ = 0, share_ = 1;
  double exponent_ = 1;  ///< of the creeping bristle
  bool creeps_ = false;
};

}  // namespace phs::hydraulics
