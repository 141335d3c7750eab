// Variance-based sensitivity: how much of an output's variance each axis explains.
//
// With base points A, B and A_B^i (A with axis i from B), N of each:
//   first order  S_i  = 1 - sum (f(B) - f(A_B^i))^2 / (2 N V)
//   total        ST_i =     sum (f(A) - f(A_B^i))^2 / (2 N V),   V the variance of f over A and B.
// Source: Jansen, Analysis of variance designs for model output, Computer Physics Communications
// 117 (1999) 35; Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, table 2.
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
