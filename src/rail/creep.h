// One contact patch, its creepages and creep forces.
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

namespace phs::rail {

/// Material of wheel and rail (equal).
struct ContactMaterial {
  double shear_modulus_Pa = 82e9;
  double poisson_ratio = 0.28;  ///< 0 … 0.5
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

}  // namespace phs::rail
