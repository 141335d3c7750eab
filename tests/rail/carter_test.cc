#include "rail/carter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace phs::rail {
namespace {

// Carter 1926: F/(mu N) = 1 - (1 - |xi| R/(mu a))^2, and 1 beyond.
TEST(Carter, RollingLineContact) {
  EXPECT_NEAR(CalcCarter(1e-4, 0.5, 6e-3, 0.3), -(1 - std::pow(1 - 1e-4 * 0.5 / (0.3 * 6e-3), 2)),
              1e-15);
  EXPECT_EQ(CalcCarter(-1, 0.5, 6e-3, 0.3), 1);
}

// Strips of an ellipse, half width a cos t, load ~ cos^3 t dt. For little creep the force of a strip is
// 2 xi R/(mu a cos t) of its load: int cos^2/int cos^3 = (pi/4)/(2/3) = 3 pi/8 of the line's.
TEST(Carter, StripsOfAnEllipseCreepMoreThanItsMiddle) {
  const double little = 1e-9;
  EXPECT_NEAR(CalcCarterStrips(little, 0.5, 6e-3, 0.3) / CalcCarter(little, 0.5, 6e-3, 0.3),
              3 * M_PI / 8, 1e-4);
  EXPECT_NEAR(CalcCarterStrips(0.1, 0.5, 6e-3, 0.3), -1, 1e-12);
}

}  // namespace
}  // namespace phs::rail
