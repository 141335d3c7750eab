// Data sets as a whole: the same for one seed, explained by what they hide, drawn apart; and nothing of the
// product in their making.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "set_writer.h"
#include "suite.h"

namespace rigdata {
namespace {

SetWish ShortWish(std::vector<EffectWish> effects, uint64_t seed) {
  SetWish wish;
  wish.effects = std::move(effects);
  wish.seed = seed;
  wish.duration = 60;
  wish.final_step = 5e-4;
  return wish;
}

TEST(Set, SameSeedSameBitsOtherSeedOtherRecord) {
  const RigSet a = MakeRigSet(ShortWish({{"stribeck", Grade::kStrong}}, 7));
  const RigSet b = MakeRigSet(ShortWish({{"stribeck", Grade::kStrong}}, 7));
  const RigSet c = MakeRigSet(ShortWish({{"stribeck", Grade::kStrong}}, 8));
  EXPECT_EQ(a.record.channel, b.record.channel);
  EXPECT_EQ(TruthJson(a), TruthJson(b));
  EXPECT_NE(a.record.channel[kLoad], c.record.channel[kLoad]);
}

TEST(Set, CleanSetIsExplainedByTheDeclaredModelAlone) {
  const RigSet set = MakeRigSet(ShortWish({}, 21));
  for (const Channel c : {kPiston, kLoad, kPBore, kPRod}) {
    EXPECT_LT(set.declared[c], 1.05 * set.floor[c]) << kChannelNames[c];
    EXPECT_GE(set.floor[c], 0.97 * set.noise_only[c]) << kChannelNames[c];
  }
  for (const double factor : {set.base.oil_bore, set.base.gas_bore, set.base.oil_rod,
                              set.base.gas_rod, set.base.friction}) {
    EXPECT_GE(std::abs(factor - 1), 0.1);
    EXPECT_LE(std::abs(factor - 1), 0.3);
  }
  for (const Channel c : {kPBore, kPRod}) {
    for (const double p : set.record.channel[c]) {
      ASSERT_GT(p, 0.2e6);
      ASSERT_LT(p, 20e6);
    }
  }
}

TEST(Set, GradesAreSeveralTimesAndAboutTheNoise) {
  for (const uint64_t seed : {31u, 32u}) {
    const RigSet strong = MakeRigSet(ShortWish({{"piston_leakage", Grade::kStrong}}, seed));
    EXPECT_GT(strong.hidden[0].size_over_noise, 3.5);
    EXPECT_GT(std::max(strong.declared[kPBore] / strong.floor[kPBore],
                       strong.declared[kPRod] / strong.floor[kPRod]),
              3.0);
    const RigSet weak = MakeRigSet(ShortWish({{"piston_leakage", Grade::kWeak}}, seed));
    EXPECT_GT(weak.hidden[0].size_over_noise, 0.7);
    EXPECT_LT(weak.hidden[0].size_over_noise, 2.2);
  }
}

TEST(Suite, SeedsOfTuningScoringAndHoldoutAreApart) {
  std::set<uint64_t> seen;
  size_t total = 0;
  for (const char* name : {"tune", "score", "holdout"}) {
    const auto suite = ComposeSuite(name);
    ASSERT_TRUE(suite.has_value());
    std::map<SetKind, int> kinds;
    for (const SuiteEntry& e : *suite) {
      seen.insert(e.wish.seed);
      ++kinds[e.kind];
      ++total;
    }
    EXPECT_EQ(kinds[SetKind::kSingle], 2 * static_cast<int>(ListedNames().size()));
    EXPECT_GE(kinds[SetKind::kClean], 20);
    EXPECT_GE(kinds[SetKind::kPair], 20);
  }
  EXPECT_EQ(seen.size(), total);
  EXPECT_FALSE(ComposeSuite("other").has_value());
}

TEST(Suite, DrawnSetsDependOnTheSeedAloneAndKeepTheirShares) {
  const auto names = [](const SuiteEntry& e) {
    std::string text = std::to_string(e.wish.seed);
    for (const EffectWish& w : e.wish.effects) text += " " + w.name;
    return text;
  };
  const auto few = DrawSuite(5, 10), many = DrawSuite(5, 400), others = DrawSuite(6, 10);
  std::map<SetKind, int> kinds;
  std::set<uint64_t> seeds;
  for (const SuiteEntry& e : many) {
    ++kinds[e.kind];
    seeds.insert(e.wish.seed);
    EXPECT_GT(e.wish.seed, 10'000'000u);  // beyond the suites
  }
  for (size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(names(few[i]), names(many[i]));
    EXPECT_NE(names(few[i]), names(others[i]));
  }
  EXPECT_EQ(seeds.size(), many.size());
  // Shares of 400 draws; three standard deviations are 30 at most.
  EXPECT_NEAR(kinds[SetKind::kClean], 80, 30);
  EXPECT_NEAR(kinds[SetKind::kSingle], 200, 30);
  EXPECT_NEAR(kinds[SetKind::kPair], 80, 30);
  EXPECT_NEAR(kinds[SetKind::kOffList], 40, 30);
}

TEST(Suite, EveryNameCanBeDrawnInEveryForm) {
  for (const auto* names : {&ListedNames(), &OffListNames()}) {
    for (const std::string& name : *names) {
      for (uint64_t seed = 0; seed < 12; ++seed) {
        const HiddenEffect effect = DrawEffect(name, RandomSource(seed));
        TrueRig rig{NominalRig(), {}};
        EXPECT_EQ(effect.name, name);
        EXPECT_FALSE(effect.apply(1.0, &rig).empty()) << name;
        EXPECT_EQ(effect.listed, names == &ListedNames()) << name;
      }
    }
  }
  EXPECT_THROW(DrawEffect("no_such_effect", RandomSource(1)), std::logic_error);
}

// The generator must not share a line with what it judges.
TEST(Independence, NoFileHereIncludesTheProduct) {
  const std::filesystem::path folder = RIGDATA_SOURCE_DIR;
  const std::regex include("#include \"([^\"]+)\"");
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cc" && entry.path().extension() != ".h") continue;
    ++files;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const auto included = (entry.path().parent_path() / match[1].str()).lexically_normal();
      EXPECT_TRUE(std::filesystem::exists(included)) << entry.path() << line;
      // The stand-in for a shell in the scorer's test aside, nothing comes from elsewhere.
      EXPECT_TRUE(included.string().starts_with(folder.string()) ||
                  included.filename() == "execute.h")
          << entry.path() << line;
    }
  }
  EXPECT_GT(files, 40);
}

}  // namespace
}  // namespace rigdata
