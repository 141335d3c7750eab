// Warm starts of the search: the numbers that a candidate effect was fitted to in an earlier round.
//
// The first round tries each candidate from many starts. Later rounds fit dearer models, with the
// effects accepted so far; there the candidate starts from its numbers of the round before as well.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "identify/effect_trials.h"

namespace phs::identify::search {

class SeenStarts {
 public:
  /// Keeps the numbers of each trial that promised to say something: `first` numbers are those of
  /// the model beneath, `reference` its own mean log square.
  void Note(const std::vector<FullTrial>& trials, size_t first, double reference);
  /// Adds what is known of each candidate to its starts.
  void AddStarts(std::vector<Candidate>* list) const;

 private:
  /// Effect with places and free numbers, and the numbers that are not free.
  using Key = std::pair<std::string, std::map<std::string, double>>;
  static Key KeyOf(const Candidate& candidate);
  std::map<Key, std::vector<double>> last_;
};

}  // namespace phs::identify::search
