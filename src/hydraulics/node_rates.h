// Rates of what a node remembers: memories of its volume laws, temperatures of its gases and their
// walls.
//
// Gas heat balance dT/dt = relax - kappa dV/dt with dV/dt = V_p dp/dt + V_T dT/dt, and the volume
// balance of the node S dp/dt - sum V_T dT/dt = dD/dt solved for dp/dt.
#pragma once

#include <algorithm>

#include "hydraulics/compiled_phs.h"

namespace phs::hydraulics {

/// A of the slow states: the diagonal, and what couples a state with the next one (a gas with its
/// wall).
struct SlowMatrix {
  explicit SlowMatrix(int count) {
    for (double* row : {diagonal, over_next, of_next}) std::fill(row, row + count, 0.0);
  }
  double diagonal[kMaxStates];   ///< d(rate of i)/d(state i)
  double over_next[kMaxStates];  ///< d(rate of i)/d(state i + 1)
  double of_next[kMaxStates];    ///< d(rate of i + 1)/d(state i)

  /// Solves (1 - a A) x = b in place of b, for the states from `first` to `end`.
  void SolveShifted(double a, int first, int end, double* b) const {
    for (int i = first; i < end; ++i) {
      const double d = 1 - a * diagonal[i];
      if (over_next[i] == 0 || i + 1 >= end) {
        b[i] /= d;
        continue;
      }
      const double up = -a * over_next[i], down = -a * of_next[i], e = 1 - a * diagonal[i + 1];
      const double x = (b[i] * e - up * b[i + 1]) / (d * e - up * down);
      b[i + 1] = (b[i + 1] - down * x) / e;
      b[i++] = x;
    }
  }
};

/// `inflow`: dD/dt [m3/s]. Writes the rates of the node's states and their part of A. Returns
/// dD/dp [m3/Pa] where the gas keeps the heat of its compression: what a fast change meets.
double CalcNodeRates(const Node& node, const NodeState& at, double ambient, double inflow,
                     const double* state, double* rate, SlowMatrix* slow);

}  // namespace phs::hydraulics
