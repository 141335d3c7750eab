// Carter's strips as a creep law: sticks, slides, and is near FASTSIM where the patch is wide.
#include <gtest/gtest.h>

#include <cmath>

#include "creep_reference.h"

namespace phs::rail {
namespace {

TEST(LineContact, FollowsFastsimOnAPatchFarWiderThanLong) {
  const auto law = Law("line_contact"), fastsim = Law("fastsim");
  for (double xi : {-2e-3, -3e-4, 1e-4, 1e-3}) {
    const CreepInput in{1e-3, 8e-3, 3e4, xi, 0, 0, 20, 0.3};
    EXPECT_NEAR(law->Calc(in).x, fastsim->Calc(in).x, 0.1 * 0.3 * 3e4) << xi;
    EXPECT_LT(law->Calc(in).x * xi, 0);
  }
}

TEST(LineContact, SlidesAtTheFrictionLimitAgainstTheSlip) {
  const CreepForce f = Law("line_contact")->Calc({5e-3, 5e-3, 1e5, 0.06, -0.08, 0, 20, 0.3});
  EXPECT_NEAR(f.x, -0.6 * 3e4, 1);
  EXPECT_NEAR(f.y, 0.8 * 3e4, 1);
}

}  // namespace
}  // namespace phs::rail
