#include <algorithm>
#include <cmath>

#include "base/data_path.h"
#include "base/words.h"
#include "validate/check_groups.h"

namespace phs::validate {

bool Check::Passed() const {
  if (!skipped.empty()) return true;
  if (!std::isfinite(ours)) return false;
  switch (claim) {
    case Claim::kNear:
      return std::abs(Difference()) <= tolerance;
    case Claim::kAtMost:
      return Difference() <= tolerance;
    case Claim::kAtLeast:
      return Difference() >= -tolerance;
    case Claim::kOrientation:
      return true;
  }
  return false;
}

Result<Checks> MakeChecks(const std::vector<std::string>& groups) {
  std::vector<std::string> known;
  for (const CheckGroup& group : kCheckGroups) known.emplace_back(group.name);
  for (const std::string& name : groups) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      return Error{"--group", "no group " + Quoted(name), JoinWords(known),
                   DidYouMean(name, known)};
    }
  }
  Checks checks;
  for (const CheckGroup& group : kCheckGroups) {
    if (!groups.empty() && std::find(groups.begin(), groups.end(), group.name) == groups.end()) {
      continue;
    }
    const std::size_t first = checks.size();
    if (Status s = group.add(&checks); !s.ok()) return s.error();
    for (std::size_t i = first; i < checks.size(); ++i) checks[i].group = group.name;
  }
  return checks;
}

Result<std::string> ReferenceFile(const std::string& name) {
  return FindData("reference data", "models/reference", name, {""});
}

}  // namespace phs::validate
