// The saturated linear law: linear at first, the friction limit at last, near CONTACT between.
#include <gtest/gtest.h>

#include <cmath>

#include "creep_reference.h"

namespace phs::rail {
namespace {

TEST(ShenHedrickElkins, IsLinearAtFirstAndTheFrictionLimitAtLast) {
  const auto law = Law("shen_hedrick_elkins"), linear = Law("linear");
  CreepInput in{6e-3, 5e-3, 1e5, 1e-7, 2e-7, 1e-4, 20, 0.3};
  EXPECT_NEAR(law->Calc(in).x / linear->Calc(in).x, 1, 1e-3);
  EXPECT_NEAR(law->Calc(in).y / linear->Calc(in).y, 1, 1e-3);
  in = {6e-3, 5e-3, 1e5, 0.05, -0.02, 0, 20, 0.3};
  const CreepForce f = law->Calc(in);
  EXPECT_NEAR(std::hypot(f.x, f.y), 0.3 * 1e5, 1e-6);
  EXPECT_LT(f.x, 0);
  EXPECT_GT(f.y, 0);
}

TEST(ShenHedrickElkins, IsWithinATenthOfMuNOfContactWithoutMuchSpin) {
  const Table t = ReferenceTable("hertz_creep_table.csv");
  const auto law = Law("shen_hedrick_elkins");
  int compared = 0;
  for (int i = 0; i < t.num_rows(); ++i) {
    const CreepInput in = HertzCase(t, i);
    if (in.phi != 0) continue;
    const CreepForce f = law->Calc(in), of_fastsim = Law("fastsim")->Calc(in);
    const double limit = in.friction * in.normal;
    EXPECT_NEAR(f.x, of_fastsim.x, 0.1 * limit) << i;
    EXPECT_NEAR(f.y, of_fastsim.y, 0.1 * limit) << i;
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

}  // namespace
}  // namespace phs::rail
