// Friction while the seals swell, against the closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

double FrictionAt(const PhsParams& params, double time, double speed) {
  return Drive(Compile(params), time, 1e-3, [speed](double t) { return speed * t; }).friction;
}

TEST(SealSwelling, GrowsExponentiallyInBothDirections) {
  const PhsParams plain = Quarter();
  const PhsParams swollen = With(plain, "seal_swelling", {{"growth", 0.5}, {"time_s", 2}});
  for (double speed : {3e-3, -3e-3}) {
    for (double t : {0.5, 2.0, 6.0}) {
      const double expected = 1 + 0.5 * (1 - std::exp(-t / 2));
      EXPECT_NEAR(FrictionAt(swollen, t, speed) / FrictionAt(plain, t, speed), expected, 1e-2);
    }
  }
}

}  // namespace
}  // namespace phs::effects
