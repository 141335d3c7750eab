// Slopes of creep laws in closed form against differences.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "creep_reference.h"
#include "rail/creep_table.h"

namespace phs::rail {
namespace {

const CreepTable& Fine() {
  static const CreepTable table = CreepTable::Build({40, 40, false}, 2);
  return table;
}

TEST(CreepSlope, OfTheTableEqualsCentredDifferences) {
  std::mt19937 random(23);
  std::uniform_real_distribution<> one(-1, 1);
  const double h = 1e-5;
  double rms = 0, largest = 0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double size = 0.05 * std::exp(5 * std::abs(one(random)));  // 0.05 … 7
    const NormalisedCreepage c{size * one(random), size * one(random), 2 * size * one(random),
                               0.5 + 0.4 * one(random)};
    NormalisedSlope s;
    CreepTable::Cell cell;
    const NormalisedForce f = Fine().At(c, &s, &cell);
    const NormalisedForce same = Fine().At(c);
    EXPECT_EQ(f.x, same.x);
    EXPECT_EQ(f.y, same.y);
    EXPECT_EQ(f.moment, same.moment);
    // Beside it, in the same cell or not, of the same shape or not, the cell changes no bit.
    const double beside = i % 2 == 0 ? 0.01 : 0.3;
    const double chi = i % 3 == 0 ? c.chi + 0.01 : c.chi;
    const NormalisedCreepage near{c.u * (1 + beside * one(random)),
                                  c.v + size * beside * one(random), c.w, chi};
    const NormalisedForce with = Fine().At(near, cell), without = Fine().At(near);
    EXPECT_EQ(with.x, without.x);
    EXPECT_EQ(with.y, without.y);
    EXPECT_EQ(with.moment, without.moment);
    const auto at = [&](double du, double dv) {
      return Fine().At({c.u + du, c.v + dv, c.w, c.chi});
    };
    const NormalisedForce u1 = at(h, 0), u0 = at(-h, 0), v1 = at(0, h), v0 = at(0, -h);
    for (const double error : {s.x_u - (u1.x - u0.x) / (2 * h), s.y_u - (u1.y - u0.y) / (2 * h),
                               s.x_v - (v1.x - v0.x) / (2 * h), s.y_v - (v1.y - v0.y) / (2 * h)}) {
      rms += error * error / (4 * count);
      largest = std::max(largest, std::abs(error));
    }
  }
  std::printf("  slope: rms %.2e, largest %.2e\n", std::sqrt(rms), largest);
  EXPECT_LT(std::sqrt(rms), 1e-4);
  EXPECT_LT(largest, 0.01);  // across an edge of the cube
}

TEST(CreepSlope, OfTheLawEqualsDifferencesAndTheLinearLimitAtRest) {
  const auto table = Law("kalker_table");
  const auto linear = Law("linear");
  std::mt19937 random(29);
  std::uniform_real_distribution<> one(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const CreepInput in{6e-3,
                        4e-3 + 2e-3 * one(random),
                        8e4,
                        4e-3 * one(random),
                        4e-3 * one(random),
                        0.5 * one(random),
                        20,
                        0.3};
    CreepSlope s, differences;
    const CreepForce f = table->CalcWithSlope(in, &s, nullptr);
    const CreepForce same = table->CreepLaw::CalcWithSlope(in, &differences, nullptr);
    EXPECT_EQ(f.x, same.x);
    EXPECT_EQ(f.y, same.y);
    EXPECT_EQ(f.moment, same.moment);
    const double size = 1e-2 * in.friction * in.normal / 1e-3;  // a hundredth of the linear slope
    EXPECT_NEAR(s.x_xi, differences.x_xi, size);
    EXPECT_NEAR(s.x_eta, differences.x_eta, size);
    EXPECT_NEAR(s.y_xi, differences.y_xi, size);
    EXPECT_NEAR(s.y_eta, differences.y_eta, size);
  }
  const CreepInput rest{6e-3, 5e-3, 8e4, 0, 0, 0, 10, 0.3};
  CreepSlope s, expected;
  const CreepForce none = table->CalcWithSlope(rest, &s, nullptr);
  EXPECT_EQ(none.x, 0);
  EXPECT_EQ(none.y, 0);
  linear->CalcWithSlope(rest, &expected, nullptr);
  EXPECT_NEAR(s.x_xi / expected.x_xi, 1, 0.02);
  EXPECT_NEAR(s.y_eta / expected.y_eta, 1, 0.02);
  EXPECT_NEAR(s.x_eta / expected.x_xi, 0, 1e-6);
  EXPECT_NEAR(s.y_xi / expected.x_xi, 0, 1e-6);
}

}  // namespace
}  // namespace phs::rail
