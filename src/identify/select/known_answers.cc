#include "identify/select/known_answers.h"

#include <fmt/format.h>

namespace phs::identify::search {
namespace {

std::string KeyOf(const Candidate& candidate, size_t start) {
  // Two variants of one effect may have one name, and starts of their own.
  std::string key = candidate.effect + " " + VariantName(candidate);
  for (const double value : candidate.starts[start]) key += fmt::format(" {}", value);
  return key;
}

}  // namespace

const KnownAnswer* KnownAnswers::Find(const Candidate& candidate, size_t start) const {
  const std::lock_guard lock(mutex_);
  const auto found = known_.find(KeyOf(candidate, start));
  return found == known_.end() ? nullptr : &found->second;
}

void KnownAnswers::Keep(const Candidate& candidate, size_t start, KnownAnswer answer) {
  const std::lock_guard lock(mutex_);
  new_.emplace(KeyOf(candidate, start), std::move(answer));
}

void KnownAnswers::EndRound() {
  known_.merge(new_);
  new_.clear();
}

}  // namespace phs::identify::search
