#include "identify/seen_starts.h"

namespace phs::identify::search {

void SeenStarts::Note(const std::vector<FullTrial>& trials, size_t first, double reference) {
  constexpr double kPromise = 0.005;  // ln of the mean square
  for (const FullTrial& trial : trials) {
    if (trial.predicted > reference - kPromise) continue;
    const size_t count = trial.candidate->free.size();
    const std::vector<double>& all = trial.coarse.ok ? trial.coarse.values : trial.start;
    if (all.size() < first + count) continue;
    const auto begin = all.begin() + static_cast<long>(first);
    last_[KeyOf(*trial.candidate)] = {begin, begin + static_cast<long>(count)};
  }
}

void SeenStarts::AddStarts(std::vector<Candidate>* list) const {
  for (Candidate& candidate : *list) {
    const auto known = last_.find(KeyOf(candidate));
    if (known != last_.end()) candidate.starts.push_back(known->second);
  }
}

SeenStarts::Key SeenStarts::KeyOf(const Candidate& candidate) {
  return {candidate.effect + " " + VariantName(candidate), candidate.params.values};
}

}  // namespace phs::identify::search
