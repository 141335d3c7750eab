// A part on a bench moved by prescribed motion x(t): what force does it ask for?
//
//   o--[ m ]--[ mount ]--+--[ friction ]--|ground     F = m x" + k x + A p + offset
//      x                 y                              + friction(y, y', p, T, …) + loads
//
// m, k, A, offset: ElementParams. Mount: play and spring of the mount laws, friction behind them,
// solved for y each sample (the friction is monotone in y's move, the mount falls: one root, found
// by bisection). Loads: the load laws, at x.
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

/// Force [N] at every sample. `speed`: of x, same length. `places` may be null.
void RunElementBench(const hydraulics::PhsSystem& system, const RigMotion& motion,
                     const std::vector<double>& speed, std::vector<double>* force,
                     ElementPlaces* places);

}  // namespace phs::rigs
