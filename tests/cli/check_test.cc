// phs simulate and compare --check: exit code 1 and the limit that is missed, by how much.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

using testing::HasSubstr;
using testing::Not;

class CheckTest : public testing::Test {
 protected:
  CheckTest() { dir_.Write("short.yaml", "track: curve_r550\nspeed_km_h: 60\nduration_s: 0.05\n"); }
  /// What it writes to standard error.
  Output Errors(const std::string& verb, const std::string& limits,
                const std::string& more = "") const {
    return ExecutePhs(verb + " " + dir_.File("short.yaml") + " --quiet --check " +
                      dir_.Write("limits.yaml", limits) + " " + more + " 2>&1 >/dev/null");
  }
  ScratchDir dir_;
};

TEST_F(CheckTest, KeptLimitsAreSilent) {
  const Output out = Errors("simulate", "limits:\n  - {quantity: run.min_Q_N, at_least: 1e3}\n");
  EXPECT_EQ(out.code, 0);
  EXPECT_EQ(out.text, "");
}

TEST_F(CheckTest, EveryMissedLimitIsOneLineAndJUnitHasIt) {
  const Output out = Errors("compare",
                            "limits:\n  - {quantity: run.min_Q_N, bogie: phs, at_least: 1e9}\n"
                            "  - {quantity: run.steps, at_most: 1}\n"
                            "  - {quantity: ratios.phs_over_rigid_link.run.steps, at_most: 1}\n",
                            "--bogies phs,rigid_link --junit " + dir_.File("new/junit.xml"));
  EXPECT_EQ(out.code, 1);
  EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 3) << out.text;
  EXPECT_THAT(out.text, HasSubstr("phs: phs: run.min_Q_N is "));
  EXPECT_THAT(out.text, HasSubstr(" too little"));
  EXPECT_THAT(out.text, HasSubstr("rigid_link: run.steps is 51, at most 1 allowed: 50 too much"));
  std::ifstream file(dir_.File("new/junit.xml"));
  const std::string xml{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(xml, HasSubstr("tests=\"6\" failures=\"3\""));
}

// No row of dashes and no "nan": one line says why there are no means.
TEST_F(CheckTest, ARunThatNeverCameToTheSteadyCurveSaysSo) {
  const Output out =
      ExecutePhs("simulate " + dir_.File("short.yaml") + " --quiet --out " + dir_.File("out"));
  EXPECT_EQ(out.code, 0);
  EXPECT_THAT(out.text, HasSubstr("! phs: the run ends after 0.05 s, before its last axle has come "
                                  "to the steady curve: s = 340 to 440 m"));
  EXPECT_THAT(out.text, Not(HasSubstr("angle of attack, lead")));
  EXPECT_THAT(out.text, Not(HasSubstr("nan")));
}

TEST_F(CheckTest, WrongLimitsAreBadInputBeforeAnyRun) {
  const Output out = Errors("simulate", "limits:\n  - {quantity: run.min_Q_N, atleast: 1}\n");
  EXPECT_EQ(out.code, 3);
  EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
}

TEST_F(CheckTest, UnknownQuantityNamesTheNearest) {
  const Output out = Errors("simulate", "limits:\n  - {quantity: run.min_Q, at_least: 1}\n");
  EXPECT_EQ(out.code, 3);
  EXPECT_THAT(out.text, HasSubstr("did you mean 'run.min_Q_N'?"));
}

}  // namespace
}  // namespace phs
