// Variance-based sensitivity: how much of an output's variance each axis explains.
//
// With base points A, B and A_B^i (A with axis i from B), N of each:
//   first order  S_i  =     sum (f(B) - mean) (f(A_B^i) - f(A)) / (N V)
//   total        ST_i =     sum (f(A) - f(A_B^i))^2 / (2 N V),   V the variance of f over A and B.
// An axis that does nothing has exactly S_i = ST_i = 0, whatever N. Source: Saltelli et al.,
// Comput. Phys. Commun. 181 (2010) 259, table 2 (b) and, after Jansen 1999, (f).
#pragma once

#include <vector>

namespace phs::sweep {

struct SobolIndex {
  double first = 0;
  double total = 0;
  double first_error = 0;  ///< standard error of each, from the scatter over the base points
  double total_error = 0;
};

/// `values`: base points by rows of (dimensions + 2) runs A, B, A_B^1 …; a base point with a value
/// that is not finite is left out. Empty if fewer than 4 base points remain or nothing varies.
std::vector<SobolIndex> SobolIndices(const std::vector<double>& values, int dimensions);

}  // namespace phs::sweep
