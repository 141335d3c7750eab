// What the starts of candidates do, kept from round to round of a search.
//
// Much of a round goes into what each start does to the channels, and into its slopes. To first
// order these are the same about a model that has one more effect: so a later round takes them as
// they were about the declared one. They order who takes real steps; what is accepted is judged by
// fits alone.
#pragma once

#include <Eigen/Core>
#include <map>
#include <mutex>
#include <string>

#include "identify/fit/effect_variants.h"

namespace phs::identify::search {

/// On the rows of the residual, over the weight of each: a later round weighs them anew.
struct KnownAnswer {
  Eigen::VectorXf does;  ///< of the start: residual with it less that without
  Eigen::MatrixXf own;   ///< slopes over the candidate's own numbers
};

/// Thread-safe but for EndRound. What a round learns is known from the next one on, so that nothing
/// hangs on which thread comes first.
class KnownAnswers {
 public:
  /// Of start `start` of the candidate; null: not known.
  const KnownAnswer* Find(const Candidate& candidate, size_t start) const;
  void Keep(const Candidate& candidate, size_t start, KnownAnswer answer);
  void EndRound();

 private:
  mutable std::mutex mutex_;
  std::map<std::string, KnownAnswer> known_, new_;
};

}  // namespace phs::identify::search
