// A part on a bench moved by prescribed motion x(t): what force does it ask for?
//
//   o--[ m ]--[ mount ]--+--[ friction ]--|ground     F = m x" + k x + k3 x³ + c v + d v|v|
//      x                 y                              + gas(x) + A p + offset + friction(y, y', p, T, …) + loads
//
// m, k, k3, c, d, gas, A, offset: ElementParams. Gas spring: a gas of volume V0 at x = 0, p V^n constant, that x
// compresses by its area a, V = V0 - a x. With F0 = p0 a (p absolute) and L = V0/a (below 0 where x < 0 compresses)
//   gas(x) = sign(L) F0 [(1 - x/L)^-n - 1],
// 0 at x = 0, stiffness n F0/|L| there. Beyond 0.99 L it stays as it is: nobody compresses gas a hundredfold.
// Mount: play and spring of the mount laws, friction behind them,
// solved for y each sample (the friction is monotone in y's move, the mount falls: one root, found
// to the last digit, base/rising_root.h). Loads: the load laws, at x.
// F > 0 pulls in the direction of x > 0.
#pragma once

#include <vector>

#include "hydraulics/phs_system.h"
#include "rigs/rig.h"

namespace phs::rigs {

/// What the friction law saw, for looking at what remains: one value a sample.
struct ElementPlaces {
  std::vector<double> direction;  ///< of friction, -1 … 1
};

/// Force of the gas spring at `x` [m], 0 at x = 0; `part`: gas_length_m not 0.
double GasSpringForce(const hydraulics::ElementParams& part, double x);

/// What friction sees at sample `at`, between two of them by straight lines; `extra` holds further
/// channels.
hydraulics::FrictionPlace ElementPlace(const hydraulics::PhsSystem& system, const RigMotion& motion,
                                       double at, double* extra);
/// Force of the part without mass and friction; `pressure`: above static [Pa].
double ElementForce(const hydraulics::ElementParams& part, double x, double v, double pressure);

/// Force [N] at every sample. `speed`: of x, same length. `places` may be null.
void RunElementBench(const hydraulics::PhsSystem& system, const RigMotion& motion,
                     const std::vector<double>& speed, std::vector<double>* force,
                     ElementPlaces* places);

}  // namespace phs::rigs
