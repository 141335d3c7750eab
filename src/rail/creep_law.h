// Tangential contact forces: one interface for linear Kalker, FASTSIM, Polach and the fast table.
//
// Axes of the contact plane: 1 = rolling direction, 2 = lateral in the plane, n = normal. Creepages
// follow CONTACT: velocity of the rail relative to the wheel divided by the reference speed, so a
// positive creepage gives a negative force *on the rail*… the force returned here is the one that
// CONTACT prints (reference/rail): Fx = -G ab C11 xi in the linear limit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs::rail {

/// Material of wheel and rail (equal).
struct ContactMaterial {
  double shear_modulus_Pa = 82e9;
  double poisson_ratio = 0.28;
};

/// Friction: constant, or falling with slip speed f(w) = f0 ((1 - A) exp(-B w) + A) (Polach).
struct FrictionLaw {
  double coefficient = 0.3;     ///< f0
  double falling_ratio = 1;     ///< A in (0, 1]; 1 = constant
  double falling_rate_s_m = 0;  ///< B [s/m]
  double At(double slip_speed) const;
};

/// One contact patch with its rigid slip.
struct CreepInput {
  double a = 0;           ///< semi-axis along rolling [m]
  double b = 0;           ///< semi-axis across [m]
  double normal = 0;      ///< N >= 0 [N]
  double xi = 0;          ///< longitudinal creepage
  double eta = 0;         ///< lateral creepage
  double phi = 0;         ///< spin creepage [1/m]
  double speed = 0;       ///< reference speed, for slip-dependent friction [m/s]
  double friction = 0.3;  ///< coefficient of this patch at its slip speed (tread and flange differ)
};

struct CreepForce {
  double x = 0;       ///< [N]
  double y = 0;       ///< [N]
  double moment = 0;  ///< about the normal [N m]
};

/// Thread-safe, allocation-free after creation.
class CreepLaw {
 public:
  virtual ~CreepLaw() = default;
  virtual CreepForce Calc(const CreepInput& input) const noexcept = 0;
  virtual std::string name() const = 0;
};

struct CreepLawParams {
  std::string method = "kalker_table";  ///< linear | fastsim | polach | kalker_table
  ContactMaterial material;
  int fastsim_strips = 40;  ///< grid of FASTSIM (and of the table's source)
  int fastsim_slices = 40;
  bool elliptic_bound = false;  ///< traction bound: parabolic (classic) or elliptic
  bool use_disk_cache = true;   ///< keep the table in $XDG_CACHE_HOME/phs
};

Result<std::unique_ptr<CreepLaw>> CreateCreepLaw(const CreepLawParams& params);
/// The methods by name, for messages and --help.
const std::vector<std::string>& CreepLawNames();

}  // namespace phs::rail
