#include "suite.h"

#include <cstdio>
#include <utility>

namespace rigdata {
namespace {

constexpr int kCleanSets = 20;
constexpr int kPairs = 24;

// First seed of each suite; they lie far further apart than a suite is long.
constexpr std::pair<const char*, uint64_t> kFirstSeed[] = {
    {"tune", 1'000'000}, {"score", 2'000'000}, {"holdout", 3'000'000}};

constexpr uint64_t kBeyondSuites = 1'000'000'000;

// 0 hydraulic, 1 friction, 2 mounting, 3 instrument, 4 environment, by place in ListedNames().
int FamilyOf(int index) {
  if (index < 10) return 0;
  if (index < 16) return 1;
  if (index < 19) return 2;
  if (index < 23) return 3;
  return index == 23 ? 4 : (index == 24 ? 1 : 0);
}

// Two effects; of different families in three cases of four.
std::pair<int, int> DrawPair(RandomSource& random) {
  const int count = static_cast<int>(ListedNames().size());
  const bool mixed = random.Uniform() < 0.75;
  for (;;) {
    const int a = random.Integer(count), b = random.Integer(count);
    if (a == b) continue;
    if (mixed == (FamilyOf(a) != FamilyOf(b))) return {a, b};
  }
}

void Name(std::vector<SuiteEntry>* suite) {
  for (size_t i = 0; i < suite->size(); ++i) {
    char label[32];
    std::snprintf(label, sizeof label, "set_%03zu", i + 1);
    (*suite)[i].name = label;
  }
}

// Of three pairs, one has a weak partner; so has one of three single effects.
SuiteEntry DrawEntry(RandomSource& random) {
  const double kind = random.Uniform();
  const auto grade = [&] { return random.Uniform() < 0.3 ? Grade::kWeak : Grade::kStrong; };
  const auto one_of = [&](const std::vector<std::string>& names) {
    return names[static_cast<size_t>(random.Integer(static_cast<int>(names.size())))];
  };
  SuiteEntry entry;
  if (kind < 0.2) {
    entry.kind = SetKind::kClean;
  } else if (kind < 0.7) {
    entry.kind = SetKind::kSingle;
    entry.wish.effects = {{one_of(ListedNames()), grade()}};
  } else if (kind < 0.9) {
    entry.kind = SetKind::kPair;
    const auto [a, b] = DrawPair(random);
    entry.wish.effects = {{ListedNames()[static_cast<size_t>(a)], Grade::kStrong},
                          {ListedNames()[static_cast<size_t>(b)], grade()}};
  } else {
    entry.kind = SetKind::kOffList;
    entry.wish.effects = {{one_of(OffListNames()), Grade::kStrong}};
  }
  return entry;
}

}  // namespace

std::vector<SuiteEntry> DrawSuite(uint64_t seed, int count) {
  std::vector<SuiteEntry> suite;
  for (int i = 0; i < count; ++i) {
    // A stream of its own for each: more sets from the same seed begin with the same ones.
    RandomSource random(seed, "blind set " + std::to_string(i));
    suite.push_back(DrawEntry(random));
    suite.back().wish.seed = kBeyondSuites + random.NextBits() % kBeyondSuites;
  }
  Name(&suite);
  return suite;
}

const char* KindName(SetKind kind) {
  switch (kind) {
    case SetKind::kClean:
      return "clean";
    case SetKind::kSingle:
      return "single";
    case SetKind::kPair:
      return "pair";
    case SetKind::kOffList:
      return "off_list";
  }
  return "";
}

std::optional<std::vector<SuiteEntry>> ComposeSuite(const std::string& name) {
  uint64_t seed = 0;
  for (const auto& [suite, first] : kFirstSeed) {
    if (name == suite) seed = first;
  }
  if (seed == 0) return std::nullopt;

  RandomSource random(seed, "suite");
  std::vector<SuiteEntry> suite;
  const auto add = [&](SetKind kind, std::vector<EffectWish> effects) {
    SuiteEntry entry;
    entry.kind = kind;
    entry.wish.effects = std::move(effects);
    suite.push_back(std::move(entry));
  };
  for (const std::string& effect : ListedNames()) {
    add(SetKind::kSingle, {{effect, Grade::kStrong}});
    add(SetKind::kSingle, {{effect, Grade::kWeak}});
  }
  for (int i = 0; i < kCleanSets; ++i) add(SetKind::kClean, {});
  for (int i = 0; i < kPairs; ++i) {
    const auto [a, b] = DrawPair(random);
    const Grade second = random.Uniform() < 0.3 ? Grade::kWeak : Grade::kStrong;
    add(SetKind::kPair, {{ListedNames()[a], Grade::kStrong}, {ListedNames()[b], second}});
  }
  for (const std::string& effect : OffListNames()) {
    add(SetKind::kOffList, {{effect, Grade::kStrong}});
  }
  // Shuffled, so that a set's number says nothing.
  for (int i = static_cast<int>(suite.size()) - 1; i > 0; --i) {
    std::swap(suite[i], suite[random.Integer(i + 1)]);
  }
  for (size_t i = 0; i < suite.size(); ++i) suite[i].wish.seed = seed + 1 + i;
  Name(&suite);
  return suite;
}

}  // namespace rigdata
