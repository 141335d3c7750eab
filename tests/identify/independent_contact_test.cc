// The contact of the independent bogie (tests/rigdata/bogie_curve) against elastic half-spaces, as
// the product's own in tests/rail/half_space_test.cc. It stands here as the files of the
// independent bogie include nothing from elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/data_path.h"
#include "tests/rail/half_space.h"
#include "tests/rigdata/bogie_curve/wheel_on_rail.h"

namespace bogie_curve {
namespace {

double MeanRadiusOf(const WheelLoad& load) {
  double sum = 0, normal = 0;
  for (const Patch& p : load.patches) {
    sum += p.ellipse.normal * p.rolling_radius, normal += p.ellipse.normal;
  }
  return sum / normal;
}

// Under 150 kN, `y` outwards, without roll.
double OwnRadius(const WheelOnRail& wheel, double y) {
  AxlePlace axle;
  axle.y = y;
  axle.speed = {20, 0, 0}, axle.turn.setZero(), axle.forward = 20;
  double high = -0.630, low = -0.610;
  for (int i = 0; i < 50; ++i) {
    axle.z = 0.5 * (low + high);
    (-wheel.Load(axle).force.z() < 150e3 ? high : low) = axle.z;
  }
  return MeanRadiusOf(wheel.Load(axle));
}

// The same pair by elastic half-spaces: no ellipse, no virtual penetration.
double HalfSpaceRadius(const WheelOnRail& wheel, double y) {
  const WheelRailPair& pair = wheel.pair();
  const double shift = y + pair.half_tape - wheel.rail_place();
  const auto radius = [&](double u) {
    const double at = std::clamp(u - shift, pair.wheel.first(), pair.wheel.last());
    return pair.radius + pair.wheel.At(at).z;
  };
  const auto gap = [&](double x, double u) {
    return pair.rail.At(u).z - radius(u) + x * x / (2 * radius(u));
  };
  const Material& steel = pair.material;
  phs::rail::HalfSpace space(12, 90, 1e-3, 0.6e-3, -14e-3,
                             (1 - steel.poisson) / (std::numbers::pi * steel.shear_modulus));
  space.Solve(gap, 150e3);
  return space.Mean(radius);
}

// Where the load goes over to the flange root the radius rises by 0.4 to 2.6 per shift; a wheel has
// that of half-spaces within an eighth of a millimetre of the place where they have it. From 5.4 to
// 5.6 mm it rises by 3.8, half again as steeply: in the curve of 300 m the bogie hunts there.
TEST(IndependentContact, FindsItsRadiusNearWhereHalfSpacesDoAndMoreSteeplyAtTheRoot) {
  WheelRailPair pair;
  pair.wheel =
      Section::Read(phs::FindData("profile", "models/profiles", "S1002", {".prw"}).value(), false);
  pair.rail =
      Section::Read(phs::FindData("profile", "models/profiles", "UIC60", {".prr"}).value(), true);
  const WheelOnRail wheel(pair);
  constexpr double kStep = 0.25e-3;
  double before = HalfSpaceRadius(wheel, 3.75e-3);
  for (double y = 4e-3; y < 5.8e-3; y += kStep) {
    const double reference = HalfSpaceRadius(wheel, y);
    EXPECT_NEAR((OwnRadius(wheel, y) - reference) * kStep / (reference - before), 0, 0.125e-3)
        << "y = " << y;
    before = reference;
  }
  const auto rise = [&](double (*of)(const WheelOnRail&, double)) {
    return (of(wheel, 5.6e-3) - of(wheel, 5.4e-3)) / 0.2e-3;
  };
  EXPECT_NEAR(rise(OwnRadius), 3.8, 0.3);
  EXPECT_NEAR(rise(HalfSpaceRadius), 2.6, 0.2);
}

}  // namespace
}  // namespace bogie_curve
