// The precharge of blow-off accumulators: sought about the declared one, and not found in it.
#include <gtest/gtest.h>

#include "identify/fit/accept.h"
#include "identify/fit/search_fit.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {
namespace {

hydraulics::PhsParams WithPrecharge(double precharge_Pa) {
  hydraulics::PhsParams params = phs_model::FindPhsParams("quarter_setup2").value();
  for (auto& line : params.lines) line.accumulator_precharge_Pa = precharge_Pa;
  return params;
}

Candidate PrechargeOf(const hydraulics::PhsParams& params) {
  for (const Candidate& c : ListCandidates(params, rigs::RigKind::kQuarter)) {
    if (c.effect == "accumulator_precharge" && c.params.targets.empty()) return c;
  }
  ADD_FAILURE() << "no such candidate";
  return {};
}

TEST(PrechargeTest, StartsLieAboutTheDeclaredOne) {
  for (const double declared : {10e6, 15e6, 19e6}) {
    const Candidate c = PrechargeOf(WithPrecharge(declared));
    double below = 0, above = 1e9;  // the nearest
    for (const auto& start : c.starts) {
      EXPECT_GE(start[0], c.free[0].low);
      EXPECT_LE(start[0], c.free[0].high);
      if (start[0] < declared) below = std::max(below, start[0]);
      if (start[0] > declared) above = std::min(above, start[0]);
    }
    EXPECT_NEAR(below / declared, 0.99, 1e-9) << "half a per cent is found from here";
    EXPECT_NEAR(above / declared, 1.01, 1e-9);
  }
}

TEST(PrechargeTest, OneWithinItsIntervalOfTheDeclaredIsNotMissing) {
  const Candidate c = PrechargeOf(WithPrecharge(15e6));
  FitResult fit;
  fit.half_95 = {3e-3};
  for (const auto& [value, there] : {std::pair{14.93e6, true}, {15.06e6, true}, {14.99e6, false}}) {
    fit.values = {value};
    EXPECT_EQ(IsThere(c, fit, 0), there) << value;
  }
}

}  // namespace
}  // namespace phs::identify::search
