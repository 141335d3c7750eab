// Tridiagonal equations, as splines give them (Eigen has no solver for them):
//   below[i] x[i-1] + diagonal[i] x[i] + above[i] x[i+1] = right[i]
#pragma once

#include <span>

namespace phs {

/// One row of the equations; `below` of the first and `above` of the last count as zero.
struct TridiagonalRow {
  double below = 0, diagonal = 1, above = 0, right = 0;
};

/// Solves them by elimination without pivoting (Thomas): for diagonally dominant rows. `x` gets the
/// solution and is of the same size; `rows` are lost.
void SolveTridiagonal(std::span<TridiagonalRow> rows, std::span<double> x);

}  // namespace phs
