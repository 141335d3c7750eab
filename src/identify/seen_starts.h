// Where an effect was at its best while others were still missing: a start beside them. The first
// look at a model is thorough; the later ones, at dearer models, begin from what it found.
#pragma once

#include <map>
#include <string>
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
  static std::string Key(const Candidate& candidate);
  std::map<std::string, std::vector<double>> best_;
};

}  // namespace phs::identify::search
