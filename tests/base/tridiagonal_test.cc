#include "base/tridiagonal.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

namespace phs {
namespace {

// What is put back into the equations gives the right sides.
RC_GTEST_PROP(SolveTridiagonal, MeetsItsEquations, ()) {
  const auto number = [] { return 0.01 * *rc::gen::inRange(-100, 101); };
  std::vector<TridiagonalRow> rows(*rc::gen::inRange<size_t>(1, 30));
  for (TridiagonalRow& row : rows) {
    row = {number(), 0, number(), number()};
    row.diagonal = (1.01 + std::abs(row.below) + std::abs(row.above)) * (number() < 0 ? -1 : 1);
  }
  const std::vector<TridiagonalRow> kept = rows;
  std::vector<double> x(rows.size());
  SolveTridiagonal(rows, x);
  for (size_t i = 0; i < x.size(); ++i) {
    double left = kept[i].diagonal * x[i];
    if (i > 0) left += kept[i].below * x[i - 1];
    if (i + 1 < x.size()) left += kept[i].above * x[i + 1];
    RC_ASSERT(std::abs(left - kept[i].right) < 1e-12);
  }
}

// -x'' = 2 on five points with zero ends: the parabola, exactly.
TEST(SolveTridiagonal, GivesTheParabola) {
  std::vector<TridiagonalRow> rows(5, {-1, 2, -1, 2});
  std::vector<double> x(5);
  SolveTridiagonal(rows, x);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(x[i], (i + 1) * (5 - i), 1e-13);
}

}  // namespace
}  // namespace phs
