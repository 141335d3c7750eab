// Pistons behind mountings that yield, and a body that carries driven ends along, over one step.
//
// Unknown are the ways w of these pistons and the way s of the body; backward Euler in all:
//   piston:  P_i(w) + stop_i + friction_i(w_i/h) - F_i = 0,   F_i = mount_i(x_i + a_i s - w_i)
//   body:    R(s) + sum a_i F_i = 0,   rigid mounting: w_i = a_i s, F_i = P_i + stop_i + friction_i
// P: pressure force, F > 0 tension. All stand in one potential of the ways: where it falls no more
// they balance. It is convex but where a bristle, bent farther than its speed holds it, gives way
// as it slides. Newton's method, with a search along its way.
#pragma once

#include "hydraulics/compiled_phs.h"

namespace phs::hydraulics {

/// Pressures at the end of a step as the pistons' ways over it make them.
class ChamberPressures {
 public:
  virtual ~ChamberPressures() = default;
  /// Solves them for the ways of all pistons [m].
  virtual void Solve(const double* way) = 0;
  /// d(pressure force of each piston)/d(way of those that are `moved`) there [N/m].
  virtual void Stiffness(const int* moved, int count, double (*of_each)[kMaxCylinders]) const = 0;
  virtual const Instant& at() const = 0;
};

/// How a step begins: driven ends, mean speeds of those that are given, state.
struct MountStep {
  const CompiledPhs& sys;
  double h;
  const double* x;
  const double* v;
  const double* state;

  bool IsMounted(int cylinder) const { return sys.cylinders[cylinder].mount_state >= 0; }
  double PistonAtStart(int cylinder) const {
    const int mount = sys.cylinders[cylinder].mount_state;
    return x[cylinder] - (mount >= 0 ? state[mount] : 0);
  }
};

/// Way of one piston that balances, the others' as they are in `way`: a guess, and the solution,
/// the last that the pressures were solved for.
void BalancePiston(const MountStep& step, int cylinder, ChamberPressures* chambers, double* way);

/// The ways of all mounted pistons and of the body (null: none): guesses, and the solution. Ways of
/// rigid pistons that are given stay as they are. False where Newton's method does not end.
bool BalanceAll(const MountStep& step, const CarriedBody* body, ChamberPressures* chambers,
                double* way, double* body_way);

}  // namespace phs::hydraulics
