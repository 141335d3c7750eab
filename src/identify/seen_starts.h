// Where an effect stood when it was last looked at, others still missing: a start beside them. The
// first look at a model is thorough; the later ones, at dearer models, begin from what it found.
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
