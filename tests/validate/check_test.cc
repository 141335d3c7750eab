#include "validate/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/base/scratch_dir.h"
#include "validate/known_misses.h"

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

TEST(Check, OrientationIsNeverMissedUnlessItIsNoNumber) {
  EXPECT_TRUE(Row(48, 7, 0, Claim::kOrientation).Passed());
  EXPECT_FALSE(Row(std::nan(""), 7, 0, Claim::kOrientation).Passed());
}

Check Named(const char* what, double ours) {
  Check check = Row(ours, 1, 0.5, Claim::kNear);
  check.group = "g";
  check.what = what;
  return check;
}

TEST(KnownMisses, AListedMissIsNoFailureAndCarriesItsReason) {
  const Judgement j = Judge({Named("a", 1), Named("b", 9)}, {{"g", "b", "for a reason"}});
  EXPECT_TRUE(j.Passed());
  EXPECT_EQ(j.Count(Verdict::kHolds), 1);
  EXPECT_EQ(j.Count(Verdict::kKnownMiss), 1);
  EXPECT_EQ(j.rows[1].reason, "for a reason");
}

TEST(KnownMisses, AnyOtherMissARowThatHoldsAgainAndARowThatIsNotThereFail) {
  EXPECT_FALSE(Judge({Named("a", 9)}, {}).Passed());
  const Judgement again = Judge({Named("a", 1)}, {{"g", "a", "r"}});
  EXPECT_FALSE(again.Passed());
  EXPECT_EQ(again.Count(Verdict::kHoldsAgain), 1);
  const Judgement gone = Judge({Named("a", 1)}, {{"g", "b", "r"}});
  EXPECT_FALSE(gone.Passed());
  ASSERT_EQ(gone.unknown_rows.size(), 1u);
  // Rows of a group that was not asked for play no part.
  EXPECT_TRUE(Judge({Named("a", 1)}, {{"other group", "b", "r"}}).Passed());
}

TEST(KnownMisses, TheFileNeedsAReasonForEachRowAndEachRowOnce) {
  ScratchDir dir;
  const auto load = [&](const std::string& text) {
    const auto known = LoadKnownMisses(dir.Write("misses.yaml", text));
    return known.ok() ? std::string() : known.error().Line();
  };
  EXPECT_EQ(load("misses:\n  - {group: g, what: a, reason: r}\n"), "");
  EXPECT_NE(load("misses:\n  - {group: g, what: a}\n").find("reason"), std::string::npos);
  EXPECT_NE(load("misses:\n  - {group: g, what: a, reason: ''}\n").find("is empty"),
            std::string::npos);
  EXPECT_NE(load("misses:\n  - {group: g, what: a, reason: r}\n"
                 "  - {group: g, what: a, reason: r}\n")
                .find("twice"),
            std::string::npos);
}

// Every row of `phs validate` holds, or is listed as missed; with a source, a unit and a name of
// its own, and with a tolerance that it could miss.
TEST(Checks, AllHoldOrAreListedAndNameTheirSource) {
  const auto checks = MakeChecks({});
  ASSERT_TRUE(checks.ok()) << checks.error().Line();
  const auto path = ReferenceFile("known_misses.yaml");
  ASSERT_TRUE(path.ok()) << path.error().Line();
  const auto known = LoadKnownMisses(path.value());
  ASSERT_TRUE(known.ok()) << known.error().Line();
  const Judgement judgement = Judge(checks.value(), known.value());
  for (const KnownMiss& miss : judgement.unknown_rows) ADD_FAILURE() << "no row " << miss.what;
  EXPECT_GE(judgement.rows.size(), 40u);
  std::set<std::string> seen;
  for (const JudgedCheck& row : judgement.rows) {
    const Check& check = row.check;
    EXPECT_TRUE(row.verdict != Verdict::kMissed && row.verdict != Verdict::kHoldsAgain)
        << check.group << ": " << check.what << " ours " << check.ours << " reference "
        << check.reference << " tolerance " << check.tolerance << " " << check.unit;
    EXPECT_FALSE(check.source.empty()) << check.what;
    EXPECT_FALSE(check.unit.empty()) << check.what;
    EXPECT_TRUE(seen.insert(check.group + check.what).second) << "twice: " << check.what;
    // Nothing passes by being compared with itself.
    EXPECT_TRUE(check.claim == Claim::kOrientation || check.ours != check.reference) << check.what;
  }
}

}  // namespace
}  // namespace phs::validate
