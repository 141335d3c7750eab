#include "identify/select/known_answers.h"

namespace phs::identify::search {
namespace {

std::string KeyOf(const Candidate& candidate, size_t start) {
  return candidate.effect + " " + VariantName(candidate) + " " + std::to_string(start);
}

}  // namespace

const KnownAnswer* KnownAnswers::Find(const Candidate& candidate, size_t start) const {
  const std::lock_guard lock(mutex_);
  const auto found = known_.find(KeyOf(candidate, start));
  return found == known_.end() ? nullptr : &found->second;
}

void KnownAnswers::Keep(const Candidate& candidate, size_t start, KnownAnswer answer) {
  const std::lock_guard lock(mutex_);
  known_.emplace(KeyOf(candidate, start), std::move(answer));
}

}  // namespace phs::identify::search
