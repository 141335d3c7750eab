#include "base/tridiagonal.h"

#include "base/check.h"

namespace phs {

void SolveTridiagonal(std::span<TridiagonalRow> rows, std::span<double> x) {
  PHS_CHECK(rows.size() == x.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    TridiagonalRow& row = rows[i];
    const double pivot = i > 0 ? row.diagonal - row.below * rows[i - 1].above : row.diagonal;
    const double right = i > 0 ? row.right - row.below * x[i - 1] : row.right;
    row.above /= pivot;
    x[i] = right / pivot;
  }
  for (size_t i = rows.size(); i-- > 1;) x[i - 1] -= rows[i - 1].above * x[i];
}

}  // namespace phs
