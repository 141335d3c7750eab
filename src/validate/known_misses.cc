#include "validate/known_misses.h"

#include <algorithm>

#include "base/words.h"
#include "base/yaml.h"

namespace phs::validate {
namespace {

bool SameRow(const KnownMiss& miss, const Check& check) {
  return miss.group == check.group && miss.what == check.what;
}

Verdict VerdictOf(const Check& check, bool listed) {
  if (!check.skipped.empty()) return Verdict::kSkipped;
  if (!check.Passed()) return listed ? Verdict::kKnownMiss : Verdict::kMissed;
  if (check.claim == Claim::kOrientation) return Verdict::kOrientation;
  return listed ? Verdict::kHoldsAgain : Verdict::kHolds;
}

}  // namespace

Result<std::vector<KnownMiss>> LoadKnownMisses(const std::string& path) {
  Result<YamlMap> file = YamlMap::Load(path);
  if (!file.ok()) return file.error();
  std::vector<KnownMiss> known;
  for (YamlMap entry : file.value().Maps("misses")) {
    KnownMiss miss{entry.Text("group"), entry.Text("what"), entry.Text("reason")};
    if (miss.reason.empty()) entry.Fail("reason", "is empty", "why the row is missed");
    for (const KnownMiss& other : known) {
      if (other.group == miss.group && other.what == miss.what) {
        entry.Fail("what", Quoted(miss.what) + " is listed twice", "each row once");
      }
    }
    known.push_back(std::move(miss));
  }
  if (Status s = file.value().Finish(); !s.ok()) return s.error();
  return known;
}

int Judgement::Count(Verdict verdict) const {
  return static_cast<int>(std::count_if(
      rows.begin(), rows.end(), [&](const JudgedCheck& row) { return row.verdict == verdict; }));
}

bool Judgement::Passed() const {
  return Count(Verdict::kMissed) == 0 && Count(Verdict::kHoldsAgain) == 0 && unknown_rows.empty();
}

Judgement Judge(const Checks& checks, const std::vector<KnownMiss>& known) {
  Judgement judgement;
  for (const Check& check : checks) {
    const auto listed = std::find_if(known.begin(), known.end(),
                                     [&](const KnownMiss& m) { return SameRow(m, check); });
    JudgedCheck row{check, VerdictOf(check, listed != known.end())};
    if (row.verdict == Verdict::kKnownMiss) row.reason = listed->reason;
    judgement.rows.push_back(std::move(row));
  }
  for (const KnownMiss& miss : known) {
    const bool made = std::any_of(checks.begin(), checks.end(),
                                  [&](const Check& c) { return c.group == miss.group; });
    const bool found =
        std::any_of(checks.begin(), checks.end(), [&](const Check& c) { return SameRow(miss, c); });
    if (made && !found) judgement.unknown_rows.push_back(miss);
  }
  return judgement;
}

}  // namespace phs::validate
