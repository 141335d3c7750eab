// Suites of data sets. Every suite draws from seeds of its own: what is tuned on one is never
// scored on another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rig_set.h"

namespace rigdata {

enum class SetKind { kClean, kSingle, kPair, kOffList };
const char* KindName(SetKind kind);

struct SuiteEntry {
  std::string name;  // set_001 …
  SetKind kind = SetKind::kClean;
  SetWish wish;
};

// "tune", "score" or "holdout"; nothing for another name.
std::optional<std::vector<SuiteEntry>> ComposeSuite(const std::string& name);

// `count` sets drawn from `seed` alone: of ten, two clean, five with one effect, two with two and
// one with an effect that no list holds, on average. Their seeds lie beyond those of the suites.
std::vector<SuiteEntry> DrawSuite(uint64_t seed, int count);

}  // namespace rigdata
