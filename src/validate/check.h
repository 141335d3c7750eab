// Published checks: what this program computes beside a number from outside (a paper, a standard, a
// measurement, another program, a closed formula), with the tolerance claimed. `phs validate`
// prints them all; docs quote them.
//
// One file NAME_checks.cc per field adds its rows; check_groups.h lists the fields. A reference is
// never a number of this program's own making. A row that has a measured value is held against it
// from both sides; a maker's claim or a rounded bound is orientation: shown, never held nor missed.
// What is missed and known stands in models/reference/known_misses.yaml with its reason
// (known_misses.h).
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::validate {

/// How ours is held against the reference.
enum class Claim {
  kNear,         ///< |ours - reference| <= tolerance
  kAtMost,       ///< ours <= reference + tolerance
  kAtLeast,      ///< ours >= reference - tolerance
  kOrientation,  ///< shown beside the reference, not judged
};

struct Check {
  std::string group = {};  ///< field, e.g. "creep forces"; set by the group it belongs to
  std::string what;        ///< the quantity, in the field's words
  std::string unit;        ///< of ours, reference and tolerance; "-" for none
  double ours = 0;
  double reference = 0;
  double tolerance = 0;  ///< absolute, >= 0
  Claim claim = Claim::kNear;
  std::string source = {};   ///< where the reference stands
  std::string skipped = {};  ///< why it could not be made on this machine; empty = made

  double Difference() const { return ours - reference; }
  /// False for a number that is not finite. A skipped check is no failure; orientation neither.
  bool Passed() const;
};

using Checks = std::vector<Check>;

/// The checks of the groups named (all when empty). An unknown name is an error that lists them.
Result<Checks> MakeChecks(const std::vector<std::string>& groups);

/// The folder models/reference as a table file: `name` with its extension.
Result<std::string> ReferenceFile(const std::string& name);

}  // namespace phs::validate
