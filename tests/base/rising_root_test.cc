#include "base/rising_root.h"

#include <gtest/gtest.h>

#include <cmath>

namespace phs {
namespace {

TEST(RisingRoot, CubeRootOfTwoFromEitherSideAndFromTheRootItself) {
  const auto f = [](double x) { return x * x * x - 2; };
  for (const double near : {-40.0, 0.0, std::cbrt(2.0), 1.3, 90.0}) {
    const auto root = RisingRoot(f, {near, 0.01, 200, 1e-14});
    ASSERT_TRUE(root) << near;
    EXPECT_NEAR(*root, std::cbrt(2.0), 1e-14) << near;
  }
}

TEST(RisingRoot, AFlatPartBeforeTheRiseHidesNothing) {
  const auto f = [](double x) { return std::pow(std::max(0.0, x - 3), 1.5) - 1e-6; };
  const auto root = RisingRoot(f, {0, 1e-4, 10, 1e-12});
  ASSERT_TRUE(root);
  EXPECT_NEAR(*root, 3 + 1e-4, 1e-12);
}

TEST(RisingRoot, ItsOwnPlaceNeedsNoOther) {
  EXPECT_EQ(RisingRoot([](double x) { return std::max(0.0, x); }, {0, 1, 8, 1e-9}), 0.0);
}

TEST(RisingRoot, NoneBeyondReachNorWithoutANumber) {
  const auto f = [](double x) { return x - 5; };
  EXPECT_FALSE(RisingRoot(f, {0, 0.1, 4.9, 1e-9}));
  EXPECT_TRUE(RisingRoot(f, {0, 0.1, 5.1, 1e-9}));
  EXPECT_FALSE(RisingRoot([](double) { return std::nan(""); }, {0, 1, 8, 1e-9}));
  EXPECT_FALSE(RisingRoot([](double x) { return x < 1 ? -1 : std::nan(""); }, {0, 1, 8, 1e-9}));
}

TEST(RisingRoot, FewValuesWhereTheFunctionIsNearlyALine) {
  int values = 0;
  const auto f = [&](double x) {
    ++values;
    return x - 0.37 + 0.05 * x * x;
  };
  ASSERT_TRUE(RisingRoot(f, {0, 0.1, 10, 1e-13}));
  EXPECT_LE(values, 12);
}

}  // namespace
}  // namespace phs
