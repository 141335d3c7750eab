// One word for an identification, and why.
#include "identify/select/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identify/result/result_json.h"

namespace phs::identify {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

VerdictFacts Facts(double before, double after) {
  return {{{"load_cell_N", before, after, 0.02}}, {}, {}, {}};
}

TEST(Verdict, AModelThatRunsAwayWhereItWasNotFittedIsSaidSo) {
  VerdictFacts facts;
  facts.channels = {{"load_cell_N", 8, 2e9, 1e7}};
  facts.effects.push_back({.name = "hose_expansion", .rivals = {}});
  const Verdict verdict = Judge(facts);
  EXPECT_EQ(verdict.word, "not_described");
  EXPECT_THAT(verdict.reasons,
              Contains(HasSubstr("load_cell_N runs away in the validation window")));
  EXPECT_THAT(verdict.reasons, Not(Contains(HasSubstr("2000000000"))));
}

TEST(Verdict, SufficientWhereNothingIsLeftButNoise) {
  EXPECT_EQ(Judge(Facts(1.05, 1.05)).word, "sufficient");
  EXPECT_EQ(Judge(Facts(1.4, 1.4)).word, "sufficient") << "what it lacks is no larger than noise";
}

TEST(Verdict, SaysThatNothingWasTried) {
  VerdictFacts facts = Facts(5, 5);
  EXPECT_THAT(Judge(facts).reasons, Contains("nothing that was tried explains it"));
  facts.tried = false;  // --max-effects 0
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("no effect was tried")));
}

TEST(Verdict, SaysWhatWouldExplainItBeyondWhatIsPlausible) {
  VerdictFacts facts = Facts(40, 40);
  facts.beyond = {"moving_mass", {"mass_kg (4000)"}, "load_cell_N", 0.88};
  EXPECT_EQ(Judge(facts).word, "not_described");
  EXPECT_THAT(Judge(facts).reasons,
              Contains(HasSubstr("moving_mass would take 88 % of what load_cell_N shows")));
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("plausible in mass_kg (4000)")));
  EXPECT_THAT(Judge(facts).reasons, Not(Contains("nothing that was tried explains it")));
  facts.channels[0].after = 1;
  EXPECT_THAT(Judge(facts).reasons, Not(Contains(HasSubstr("moving_mass"))));
}

TEST(Verdict, WhatWouldExplainWasTriedBesideAllThatIsThere) {
  search::Identification found;
  search::CandidateRecord beyond{"moving_mass", "mass_kg", 1, 0, true, {}, "refused"};
  beyond.at_end = {"mass_kg (4000)"};
  found.candidates = {beyond};
  EXPECT_TRUE(search::WouldExplain(found).has_value());
  found.candidates.push_back({"stribeck", "", 1, 0, true, {}, "accepted"});
  EXPECT_FALSE(search::WouldExplain(found).has_value()) << "it was tried before that one came";
  found.candidates.push_back({"presliding", "", 2, 0, true, {}, "refused"});
  EXPECT_FALSE(search::WouldExplain(found).has_value()) << "the last round did not find it so";
}

TEST(Verdict, NoiseWithAColourIsNotWhatTheModelLacks) {
  VerdictFacts facts = Facts(2.8, 2.8);
  facts.channels[0].following = 0.3;
  EXPECT_EQ(Judge(facts).word, "sufficient");
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("noise with a colour")));
  facts.channels[0].following = 1.5;
  EXPECT_EQ(Judge(facts).word, "not_described");
  facts.channels[0].following = 0.3;
  facts.channels.push_back({"p_bore_Pa", 3, 3, 0.02});
  EXPECT_EQ(Judge(facts).word, "not_described") << "another channel lacks something";
}

TEST(Verdict, WhatComesAndGoesIsNoNoiseOfTheSensor) {
  VerdictFacts facts = Facts(15, 15);
  facts.channels[0].following = 0.3;
  ASSERT_EQ(Judge(facts).word, "sufficient");
  facts.channels[0].comes_and_goes = true;
  EXPECT_EQ(Judge(facts).word, "not_described");
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("comes and goes")));
  facts.channels[0].quiet_at_rest = true;
  EXPECT_EQ(Judge(facts).word, "not_described");
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("quiet where the rig stands still")));
  facts.channels[0].following = 40;
  EXPECT_EQ(Judge(facts).word, "not_described");
  EXPECT_THAT(Judge(facts).reasons, Not(Contains(HasSubstr("comes and goes"))));
}

TEST(Verdict, WhatStandsOnTwoLevelsIsSaid) {
  VerdictFacts facts = Facts(15, 15);
  EXPECT_THAT(Judge(facts).reasons, Not(Contains(HasSubstr("two levels"))));
  facts.channels[0].levels_apart = 8.8, facts.channels[0].jumps = 23;
  EXPECT_EQ(Judge(facts).word, "not_described");
  EXPECT_THAT(Judge(facts).reasons,
              Contains(HasSubstr("8.8 times the noise apart, and jumps 23 times")));
}

/// One loud stroke in the record that was fitted to, none like it in the validation window.
TEST(Verdict, WhatTheEstimationWindowShowsIsJudgedToo) {
  const ChannelLeft quiet{"load_cell_N", 1.05, 1.05, 0.02}, loud{"load_cell_N", 9, 9, 0.05};
  VerdictFacts facts = Facts(1.05, 1.05);
  facts.channels = BothWindows({quiet}, {quiet});
  EXPECT_EQ(facts.channels.size(), 1u);
  EXPECT_EQ(Judge(facts).word, "sufficient");
  facts.channels = BothWindows({quiet}, {loud});
  EXPECT_EQ(Judge(facts).word, "not_described");
  EXPECT_THAT(Judge(facts).reasons,
              Contains(HasSubstr("in the estimation window load_cell_N is left with 9.0 times")));
}

TEST(Verdict, AFormThatIsOnNoListIsSaid) {
  VerdictFacts facts = Facts(5, 1.05);
  facts.effects = {{.name = "stribeck", .own_form = "c1*(v/0.02[m/s])"}};
  EXPECT_EQ(Judge(facts).word, "explained");
  EXPECT_THAT(
      Judge(facts).reasons,
      Contains("stribeck has another form than the listed ones: beside them c1*(v/0.02[m/s])"));
  EXPECT_EQ(VerdictSentence(Judge(facts), facts), "explained by stribeck");
}

TEST(Verdict, ANumberAtTheEndOfItsRangeIsSaid) {
  VerdictFacts facts = Facts(5, 1.05);
  facts.effects = {{.name = "viscous_friction", .at_end = {"exponent (0.4)"}}};
  EXPECT_EQ(Judge(facts).word, "explained");
  EXPECT_THAT(Judge(facts).reasons,
              Contains("viscous_friction ends at the edge of what is plausible in exponent (0.4): "
                       "it may lie beyond, or the law be another one"));
}

TEST(Verdict, NotDescribedWhereMuchIsLeftAndNothingFound) {
  const Verdict v = Judge(Facts(5, 5));
  EXPECT_EQ(v.word, "not_described");
  EXPECT_THAT(v.reasons, Contains(HasSubstr("5.0 times its noise and uncertainty")));
}

TEST(Verdict, NotDescribedWhereWhatWasFoundDrives) {
  VerdictFacts facts = Facts(5, 1.05);
  facts.effects = {{"unlisted", {}}};
  EXPECT_EQ(Judge(facts).word, "explained");
  facts.faults = {"the formula c1*s drives: with it the friction gives out 3 J"};
  EXPECT_EQ(Judge(facts).word, "not_described");
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("drives")));
}

TEST(Verdict, ExplainedWhereTheEffectsTakeMoreThanHalfBeyondTheNoise) {
  VerdictFacts facts = Facts(10, 1.1);
  facts.effects = {{"backlash", {}}};
  EXPECT_EQ(Judge(facts).word, "explained");
  facts.channels[0].after = 6;  // (100 - 36)/99
  EXPECT_EQ(Judge(facts).word, "explained");
  facts.channels[0].after = 9;  // (100 - 81)/99
  const Verdict v = Judge(facts);
  EXPECT_EQ(v.word, "not_described");
  EXPECT_THAT(v.reasons, Contains(HasSubstr("19 %")));
}

TEST(Verdict, UndecidableWhereAnotherExplainsAsMuch) {
  VerdictFacts facts = Facts(10, 1.1);
  facts.effects = {{"backlash", {"mount_compliance"}}};
  EXPECT_EQ(Judge(facts).word, "undecidable");
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("mount_compliance")));
  EXPECT_EQ(VerdictSentence(Judge(facts), facts),
            "cannot be told from this record: backlash or another");
  facts.effects.insert(facts.effects.begin(), {"piston_leakage", {}});
  EXPECT_EQ(VerdictSentence(Judge(facts), facts),
            "explained by piston_leakage; beside it cannot be told from this record: backlash or "
            "another");
}

TEST(Verdict, WhatContainsAnEffectIsSaidAndNoRival) {
  VerdictFacts facts = Facts(10, 1.1);
  facts.effects = {{"line_resistance", {}, {"check_restriction"}}};
  EXPECT_EQ(Judge(facts).word, "explained");
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("special case of check_restriction")));
}

TEST(Verdict, FaultsAndNumbersAtTheirEndsAreNeverSufficient) {
  VerdictFacts facts = Facts(1, 1);
  facts.faults = {"a turned sign"};
  EXPECT_EQ(Judge(facts).word, "not_described");
  facts.faults.clear();
  facts.numbers = {{"L1.oil_volume_m3", 1e-3, 2.5e-3, true}};
  EXPECT_EQ(Judge(facts).word, "not_described");
  facts.numbers[0].at_end = false;
  EXPECT_EQ(Judge(facts).word, "sufficient");
  EXPECT_THAT(Judge(facts).reasons, Contains(HasSubstr("2.5 times its declared value")));
}

// A number that ends at an end of its range, while its interval holds what is declared, is told by
// nothing: it accuses nobody.
TEST(Verdict, ANumberThatIsNotToldIsAtNoEnd) {
  search::Identification found;
  found.declared.free = {{"lines.oil_volume_m3", 1.1e-3, 0.44e-3, 2.75e-3, true, 1}};
  found.after.values = {0.44e-3};
  found.after.half_95 = {1.5};  // ln(2.5) = 0.92 lies within
  EXPECT_FALSE(search::FittedNumbers(found)[0].at_end);
  VerdictFacts facts = Facts(1, 1);
  facts.numbers = search::FittedNumbers(found);
  EXPECT_EQ(Judge(facts).word, "sufficient");
  EXPECT_THAT(Judge(facts).reasons, Not(Contains(HasSubstr("oil_volume"))));
  found.after.half_95 = {0.3};
  EXPECT_TRUE(search::FittedNumbers(found)[0].at_end);
}

}  // namespace
}  // namespace phs::identify
