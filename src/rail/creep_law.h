// Tangential contact forces: one interface for all creep laws. The laws are the rows of
// creep_laws.cc.
//
// Axes of the contact plane: 1 = rolling direction, 2 = lateral in the plane, n = normal of C
// (frames.h), pointing into the rail. Signs as CONTACT prints them for body 1, the rail:
//   creepages  (xi, eta, phi) = (velocity, rate of turn about n) of the rail's surface *relative to
//              the wheel's*, divided by the reference speed;
//   forces     on the rail, so they oppose the creepage: xi > 0 gives x < 0; in the linear limit
//                x = -G a b C11 xi,   y = -G a b C22 eta - G (a b)^1.5 C23 phi.
// The force on the wheel is the opposite. Lost power is -(x xi + y eta + moment phi) V >= 0. A
// mirror at the longitudinal plane turns the signs of eta, phi, y and moment.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs::rail {

/// Material of wheel and rail (equal).
struct ContactMaterial {
  double shear_modulus_Pa = 82e9;
  double poisson_ratio = 0.28;  ///< 0 … 0.5
};

/// Friction: constant, or falling with slip speed: f(w) = f0 ((1 - A) exp(-B w) + A).
/// Source: Polach, Creep forces in simulations of traction vehicles running on adhesion limit, Wear
/// 258 (2005) 992.
struct FrictionLaw {
  double coefficient = 0.3;     ///< f0 > 0
  double falling_ratio = 1;     ///< A in (0, 1]; 1 = constant
  double falling_rate_s_m = 0;  ///< B >= 0 [s/m]
  /// Coefficient at a slip speed >= 0 [m/s].
  double At(double slip_speed) const;
};

/// One contact patch with its rigid slip.
struct CreepInput {
  double a = 0;           ///< semi-axis along rolling [m]
  double b = 0;           ///< semi-axis across [m]
  double normal = 0;      ///< N >= 0 [N]; without normal force there is no creep force
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

/// Slope of the force against creepage [N].
struct CreepSlope {
  double x_xi = 0, x_eta = 0;
  double y_xi = 0, y_eta = 0;
};

/// Whether there is a patch that can transmit anything.
inline bool InContact(const CreepInput& in) {
  return in.normal > 0 && in.friction > 0 && in.a > 0 && in.b > 0;
}

/// Discretisation, interpolation and Polach's missing spin moment may let a patch deliver a little
/// power; the spin moment, the least certain of the three, then takes the value of no power.
inline CreepForce WithoutDelivery(const CreepInput& in, CreepForce f) {
  const double delivered = f.x * in.xi + f.y * in.eta + f.moment * in.phi;
  if (delivered > 0 && in.phi != 0) f.moment -= delivered / in.phi;
  return f;
}

/// Thread-safe, allocation-free after creation.
class CreepLaw {
 public:
  virtual ~CreepLaw() = default;
  virtual CreepForce Calc(const CreepInput& input) const noexcept = 0;
  /// The same force with its slope, by one-sided differences; for implicit steps.
  CreepForce CalcWithSlope(const CreepInput& input, CreepSlope* slope) const noexcept;
  virtual std::string name() const = 0;
};

/// Lower initial slope than theory, as measured on wet and dirty rails. The creepages that enter
/// the theory are multiplied by
///   k = k0 (alpha + (1 - alpha)/(1 + beta e)),  e = G pi a b k0 C11 w/(4 f N),
///   w = sqrt(xi^2 + s^2), s = eta + phi a if that is the larger in size, else eta.
/// Source: Spiryagin, Polach, Cole, Creep force modelling for rail traction vehicles based on the
/// Fastsim algorithm, Vehicle System Dynamics 51 (2013) 1765. The defaults switch it off.
struct SlopeReduction {
  double k0 = 1;     ///< slope at the origin, (0, 1]
  double alpha = 1;  ///< remaining part of it at large creepage, [0, 1]
  double beta = 0;   ///< how fast it falls, >= 0
  bool active() const { return k0 != 1 || (alpha != 1 && beta != 0); }
};

struct CreepLawParams {
  std::string method = "kalker_table";  ///< name of a row of CreepLaws()
  std::string option;                   ///< of the method, for laws that read one of their own
  ContactMaterial material;
  int fastsim_strips = 40;  ///< grid of FASTSIM (and of the table's source)
  int fastsim_slices = 40;
  bool elliptic_bound = false;       ///< traction bound: parabolic (classic) or elliptic
  bool use_disk_cache = true;        ///< keep the table in $XDG_CACHE_HOME/phs
  bool blended_flexibility = false;  ///< one flexibility at large creepage, as CONTACT's FASTSIM
  SlopeReduction slope_reduction;    ///< of fastsim and kalker_table
  double polach_adhesion = 1;        ///< kA of polach, (0, 1], >= kS
  double polach_slip = 1;            ///< kS of polach, (0, 1]
};

/// What may follow the name of a creep law after a colon.
struct CreepLawOption {
  std::string form;     ///< as in "NAME:form"
  std::string allowed;  ///< what `form` stands for
  /// Puts it into the parameters; false where it is not allowed. Null: the law takes no option.
  bool (*read)(const std::string& option, CreepLawParams* params) = nullptr;
};

/// One creep law.
struct CreepLawRow {
  std::string name;
  std::string text;  ///< what it is, for --help and the docs
  CreepLawOption option;
  std::unique_ptr<CreepLaw> (*make)(const CreepLawParams& params);
};
/// All of them. Names, messages, --help and the docs follow from these rows.
const std::vector<CreepLawRow>& CreepLaws();

Result<std::unique_ptr<CreepLaw>> CreateCreepLaw(const CreepLawParams& params);
/// Reads "METHOD" or "METHOD:OPTION". An error names what is allowed; `params` is then as before.
Status ChooseCreepLaw(const std::string& text, CreepLawParams* params);
/// The methods by name, for messages and --help.
std::vector<std::string> CreepLawNames();
/// "name (text), name (text), …".
std::string DescribeCreepLaws();

}  // namespace phs::rail
