// Levi and Chartet's saturation: the mean power of linear force and friction limit, and its option.
#include <gtest/gtest.h>

#include <cmath>

#include "creep_reference.h"

namespace phs::rail {
namespace {

TEST(LeviChartet, IsThePowerMeanOfLinearForceAndFrictionLimit) {
  for (const auto& [text, n] : {std::pair{"levi_chartet", 2.0}, {"levi_chartet:3.5", 3.5}}) {
    CreepLawParams params;
    ASSERT_TRUE(ChooseCreepLaw(text, &params).ok()) << text;
    const auto law = Law(params), linear = Law("linear");
    for (double xi : {1e-5, 1e-3, 3e-3, 0.05}) {
      const CreepInput in{6e-3, 5e-3, 1e5, xi, -0.5 * xi, 0, 20, 0.3};
      const CreepForce f = law->Calc(in), free = linear->Calc(in);
      const double size = std::hypot(f.x, f.y), of_free = std::hypot(free.x, free.y);
      EXPECT_NEAR(std::pow(size, -n) / (std::pow(of_free, -n) + std::pow(3e4, -n)), 1, 1e-9) << xi;
      EXPECT_NEAR(f.y / f.x, free.y / free.x, 1e-12);
    }
  }
  CreepLawParams params;
  EXPECT_FALSE(ChooseCreepLaw("levi_chartet:0.5", &params).ok());
}

}  // namespace
}  // namespace phs::rail
