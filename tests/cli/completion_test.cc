// phs --complete: what a shell offers for a half-written command line; options that are mistyped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/base/execute.h"

namespace phs {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string Offers(const std::string& words) { return ExecutePhs("--complete " + words).text; }

TEST(Completion, Verbs) {
  EXPECT_THAT(Offers("''"), HasSubstr("identify\tFind the physical effect"));
  EXPECT_THAT(Offers("comp"), StartsWith("compare\t"));
  EXPECT_EQ(Offers("nothing_like_it"), "");
}

TEST(Completion, OptionsOfTheVerb) {
  const std::string offers = Offers("compare curve_r550 --bog");
  EXPECT_THAT(offers, StartsWith("--bogies\tBogies, separated by commas"));
  EXPECT_THAT(Offers("modes --be"), StartsWith("--beside\t"));
  EXPECT_THAT(Offers("contact --whee"), StartsWith("--wheel")) << "options in groups";
}

TEST(Completion, NamesOfWhatShips) {
  EXPECT_THAT(Offers("simulate curve_r55"), StartsWith("curve_r550\t"));
  EXPECT_THAT(Offers("simulate --quiet curve_r55"), StartsWith("curve_r550\t"));
  EXPECT_THAT(Offers("modes --bogie rigid_l"), StartsWith("rigid_link\t"));
  EXPECT_THAT(Offers("compare curve_r550 --bogies phs,rigid_l"), StartsWith("phs,rigid_link\t"));
  EXPECT_THAT(Offers("simulate x --track s_cur"), StartsWith("s_curve\t"));
  EXPECT_THAT(Offers("show external_leak"), StartsWith("external_leakage\t"));
}

TEST(Completion, ChoicesAndFiles) {
  EXPECT_EQ(Offers("simulate x --format ''"), "text\t\njson\t\n");
  EXPECT_EQ(Offers("list scen"), "scenarios\t\n");
  EXPECT_EQ(Offers("simulate x --out ''"), "") << "a file: the shell knows better";
  EXPECT_EQ(Offers("simulate x y"), "") << "no second scenario";
}

TEST(NearMiss, AnOptionIsAnsweredByTheNearest) {
  const Output out = ExecutePhs("modes --bogi phs 2>&1");
  EXPECT_EQ(out.code, 2);
  EXPECT_THAT(out.text, StartsWith("phs modes: no option '--bogi'; allowed: "));
  EXPECT_THAT(out.text, HasSubstr("did you mean '--bogie'?\n"));
  // What stands behind "=" is no part of the name, and a value is no option.
  EXPECT_THAT(ExecutePhs("modes --bogie=phs --out= 2>&1").text, Not(HasSubstr("no option")));
  EXPECT_THAT(ExecutePhs("modes --frequency=1 --formt=json 2>&1").text,
              HasSubstr("did you mean '--format'?"));
}

}  // namespace
}  // namespace phs
