#include "validate/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace phs::validate {
namespace {

Check Row(double ours, double reference, double tolerance, Claim claim) {
  Check check;
  check.ours = ours;
  check.reference = reference;
  check.tolerance = tolerance;
  check.claim = claim;
  return check;
}

TEST(Check, EachClaimHoldsUpToItsToleranceAndNotBeyond) {
  EXPECT_TRUE(Row(1.5, 1, 0.5, Claim::kNear).Passed());
  EXPECT_FALSE(Row(1.51, 1, 0.5, Claim::kNear).Passed());
  EXPECT_FALSE(Row(0.49, 1, 0.5, Claim::kNear).Passed());
  EXPECT_TRUE(Row(-9, 1, 0.5, Claim::kAtMost).Passed());
  EXPECT_FALSE(Row(1.51, 1, 0.5, Claim::kAtMost).Passed());
  EXPECT_TRUE(Row(9, 1, 0.5, Claim::kAtLeast).Passed());
  EXPECT_FALSE(Row(0.49, 1, 0.5, Claim::kAtLeast).Passed());
}

TEST(Check, ANumberThatIsNotFiniteNeverPasses) {
  for (double bad : {std::nan(""), -std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(Row(bad, 1, 1e9, Claim::kAtMost).Passed());
  }
}

TEST(Checks, AnUnknownGroupNamesTheNearest) {
  const auto checks = MakeChecks({"crep"});
  ASSERT_FALSE(checks.ok());
  EXPECT_NE(checks.error().Line().find("did you mean 'creep'"), std::string::npos)
      << checks.error().Line();
}

// Every row of `phs validate`: within its tolerance, with a source, a unit and a name of its own.
TEST(Checks, AllHoldAndNameTheirSource) {
  const auto checks = MakeChecks({});
  ASSERT_TRUE(checks.ok()) << checks.error().Line();
  EXPECT_GE(checks.value().size(), 4u);
  std::set<std::string> seen;
  for (const Check& check : checks.value()) {
    EXPECT_TRUE(check.Passed()) << check.group << ": " << check.what << " ours " << check.ours
                                << " reference " << check.reference << " tolerance "
                                << check.tolerance << " " << check.unit;
    EXPECT_FALSE(check.source.empty()) << check.what;
    EXPECT_FALSE(check.unit.empty()) << check.what;
    EXPECT_TRUE(seen.insert(check.group + check.what).second) << "twice: " << check.what;
  }
}

}  // namespace
}  // namespace phs::validate
