#include "sweep/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "sweep/sensitivity.h"

namespace phs::sweep {
namespace {

TEST(LatinHypercube, EachAxisHasOnePointInEachCell) {
  const int n = 37;
  const auto points = LatinHypercube(n, 4, 5);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    std::set<int> cells;
    for (const auto& point : points) {
      ASSERT_GT(point[axis], 0.0);
      ASSERT_LT(point[axis], 1.0);
      cells.insert(static_cast<int>(point[axis] * n));
    }
    EXPECT_EQ(cells.size(), static_cast<std::size_t>(n));
  }
  EXPECT_EQ(points, LatinHypercube(n, 4, 5));
  EXPECT_NE(points, LatinHypercube(n, 4, 6));
}

// Shuffle and place follow from the draws of MT19937 alone: pinned, so that a study made on another
// machine or by a later version has the same runs.
TEST(LatinHypercube, DrawsThePinnedPoints) {
  const auto points = LatinHypercube(3, 2, 5);
  EXPECT_EQ(points[0], (std::vector<double>{0.62357743449198699, 0.32648166587265831}));
  EXPECT_EQ(points[1], (std::vector<double>{0.94377594666245079, 0.8294703966627518}));
  EXPECT_EQ(points[2], (std::vector<double>{0.068906384675453111, 0.36327367803702754}));
}

// First points of Sobol's sequence after the origin: Bratley and Fox, ACM TOMS 14 (1988) 88.
TEST(SobolPoints, FirstPointsWithoutShift) {
  const auto points = SobolPoints(3, 2, 0);
  EXPECT_EQ(points[0], (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(points[1], (std::vector<double>{0.75, 0.25}));
  EXPECT_EQ(points[2], (std::vector<double>{0.25, 0.75}));
}

// With the origin, the first 2^k points of each axis are the multiples of 2^-k in some order.
TEST(SobolPoints, EveryAxisIsEvenlySpread) {
  const int n = 255;
  const auto points = SobolPoints(n, kMostSobolDimensions, 0);
  for (std::size_t axis = 0; axis < kMostSobolDimensions; ++axis) {
    std::set<double> places;
    for (const auto& point : points) {
      EXPECT_EQ(point[axis] * 256, std::floor(point[axis] * 256));
      places.insert(point[axis]);
    }
    EXPECT_EQ(places.size(), static_cast<std::size_t>(n)) << axis;
  }
}

// Joe and Kuo's table new-joe-kuo-6.21201: s = 2, a = 1, m = {1, 3} for the third axis.
TEST(SobolPoints, ThirdAxisHasJoeAndKuosDirectionNumbers) {
  const auto points = SobolPoints(4, 3, 0);
  const double third[] = {0.5, 0.25, 0.75, 0.625};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(points[i][2], third[i]) << i;
}

TEST(SobolPoints, ShiftKeepsTheEvenSpread) {
  const auto points = SobolPoints(256, 3, 9);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double mean = 0;
    for (const auto& point : points) mean += point[axis] / 256;
    EXPECT_NEAR(mean, 0.5, 0.005);  // random points: 0.018
  }
}

TEST(Distribution, QuantilesAreThoseOfTheClosedForms) {
  using Kind = Distribution::Kind;
  EXPECT_DOUBLE_EQ((Distribution{Kind::kUniform, 2, 6, 0, 0, 0}.Quantile(0.25)), 3);
  EXPECT_NEAR((Distribution{Kind::kLogUniform, 1, 100, 0, 0, 0}.Quantile(0.5)), 10, 1e-12);
  const Distribution triangle{Kind::kTriangular, 0, 4, 1, 0, 0};
  EXPECT_NEAR(triangle.Quantile(0.25), 1, 1e-12);          // F(mode) = (mode - min)/(max - min)
  EXPECT_NEAR(triangle.Quantile(1 - 1.0 / 12), 3, 1e-12);  // 1 - F = (4 - x)^2/12
  const double inf = std::numeric_limits<double>::infinity();
  const Distribution normal{Kind::kNormal, -inf, inf, 0, 10, 2};
  EXPECT_NEAR(normal.Quantile(0.975), 10 + 2 * 1.959963984540054, 1e-13);
  EXPECT_NEAR(normal.Quantile(1e-9), 10 - 2 * 5.997807015007687, 1e-12);
  EXPECT_EQ(normal.Quantile(0), -inf);
  EXPECT_EQ(normal.Quantile(1), inf);
  const Distribution cut{Kind::kNormal, 9, 11, 0, 10, 2};
  EXPECT_NEAR(cut.Quantile(0.5), 10, 1e-9);
  EXPECT_NEAR(cut.Quantile(0), 9, 1e-9);
  EXPECT_NEAR(cut.Quantile(1), 11, 1e-9);
}

TEST(RunSeed, DependsOnStudyAndRun) {
  std::set<std::uint32_t> seeds;
  for (std::uint64_t study = 0; study < 20; ++study) {
    for (std::uint64_t run = 0; run < 500; ++run) seeds.insert(RunSeed(study, run));
  }
  EXPECT_EQ(seeds.size(), 10000u);
  EXPECT_LT(*seeds.rbegin(), 1u << 31);
}

// Ishigami's function with a = 7, b = 0.1: S = 0.3139, 0.4424, 0; ST = 0.5576, 0.4424, 0.2437
// (closed form: Homma and Saltelli, Reliability Engineering and System Safety 52 (1996) 1).
TEST(SobolIndices, IshigamiWithin0p02) {
  const int n = 4096, d = 3;
  std::vector<double> values;
  const auto f = [](const std::vector<double>& u) {
    const double pi = std::acos(-1.0);
    const double x = pi * (2 * u[0] - 1), y = pi * (2 * u[1] - 1), z = pi * (2 * u[2] - 1);
    return std::sin(x) + 7 * std::pow(std::sin(y), 2) + 0.1 * std::pow(z, 4) * std::sin(x);
  };
  for (const auto& u : SobolPoints(n, 2 * d, 3)) {
    const std::vector<double> a(u.begin(), u.begin() + d), b(u.begin() + d, u.end());
    values.push_back(f(a));
    values.push_back(f(b));
    for (std::size_t i = 0; i < d; ++i) {
      std::vector<double> mixed = a;
      mixed[i] = b[i];
      values.push_back(f(mixed));
    }
  }
  const auto indices = SobolIndices(values, d);
  ASSERT_EQ(indices.size(), 3u);
  const double first[] = {0.3139, 0.4424, 0}, total[] = {0.5576, 0.4424, 0.2437};
  for (std::size_t i = 0; i < d; ++i) {
    EXPECT_NEAR(indices[i].first, first[i], 0.02) << i;
    EXPECT_NEAR(indices[i].total, total[i], 0.02) << i;
    EXPECT_LT(indices[i].first_error, 0.05);
  }
}

TEST(SobolIndices, AnAxisThatDoesNothingHasExactlyNone) {
  std::vector<double> values;
  for (const auto& u : SobolPoints(8, 4, 3)) {
    for (double x : {u[0], u[2], u[2], u[0]}) values.push_back(std::exp(x));  // A, B, A_B^1, A_B^2
  }
  const auto indices = SobolIndices(values, 2);
  EXPECT_EQ(indices[1].first, 0);
  EXPECT_EQ(indices[1].total, 0);
  EXPECT_GT(indices[0].total, 0.5);
}

TEST(SobolIndices, LeavesOutBasePointsWithALostRunAndSaysNothingOfAConstant) {
  std::vector<double> values;
  for (int i = 0; i < 40; ++i) values.push_back(std::sin(7.0 * i));
  const auto all = SobolIndices(values, 2);
  values.insert(values.begin() + 8, {1, 2, std::nan(""), 3});
  const auto holed = SobolIndices(values, 2);
  ASSERT_EQ(holed.size(), all.size());
  EXPECT_EQ(holed[0].first, all[0].first);
  EXPECT_TRUE(SobolIndices(std::vector<double>(40, 3.0), 2).empty());
}

}  // namespace
}  // namespace phs::sweep
