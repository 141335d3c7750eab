// Checks that are known to be missed, each with its reason: models/reference/known_misses.yaml.
//
//   misses:
//     - {group: hydraulics, what: "the row's own words", reason: "why, in a sentence"}
//
// A listed row that is missed is no failure. Any other miss is one, and so is a listed row that
// holds again or that no check is called after: the file says no less and no more than what is so.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "validate/check.h"

namespace phs::validate {

struct KnownMiss {
  std::string group;
  std::string what;
  std::string reason;
};

/// Errors: file:line and key; an empty reason; a row given twice.
Result<std::vector<KnownMiss>> LoadKnownMisses(const std::string& path);

enum class Verdict { kHolds, kMissed, kKnownMiss, kHoldsAgain, kOrientation, kSkipped };

struct JudgedCheck {
  Check check;
  Verdict verdict = Verdict::kHolds;
  std::string reason = {};  ///< of a known miss
};

struct Judgement {
  std::vector<JudgedCheck> rows;
  std::vector<KnownMiss> unknown_rows;  ///< listed, but no check of the groups made is called so
  int Count(Verdict verdict) const;
  /// No miss that is not listed, and none listed that holds again or does not exist.
  bool Passed() const;
};

/// `checks`: whole groups. Listed rows of groups that were not made play no part.
Judgement Judge(const Checks& checks, const std::vector<KnownMiss>& known);

}  // namespace phs::validate
