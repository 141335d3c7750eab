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
    best_[Key(*trial.candidate)] = {begin, begin + static_cast<long>(count)};
  }
}

void SeenStarts::AddStarts(std::vector<Candidate>* list) const {
  for (Candidate& candidate : *list) {
    const auto known = best_.find(Key(candidate));
    if (known != best_.end()) candidate.starts.push_back(known->second);
  }
}

std::string SeenStarts::Key(const Candidate& candidate) {
  std::string key = candidate.effect + " " + VariantName(candidate);
  for (const auto& [name, value] : candidate.params.values) {
    key += " " + name + "=" + std::to_string(value);
  }
  return key;
}

}  // namespace phs::identify::search
