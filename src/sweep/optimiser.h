// The search itself, on top of runs and records of a sweep (sweep.h).
//
// NLopt proposes candidates in the unit cube; a candidate's values are rounded to six digits and
// its runs (one per case) are made by the worker pool. Everything follows from the study: a search
// that was stopped or killed is walked again, and what it has records of is read instead of made.
// A candidate with a run that did not end well counts as broken: its objective is ten times the
// largest seen so far and all its constraints are missed.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "sweep/sweep.h"

namespace phs::sweep {

struct Candidate {
  std::vector<std::string> values;  ///< choices, then parameters
  bool broken = false;              ///< a run did not end well
  double objective = 0;             ///< NaN if broken
  std::vector<double> constrained;  ///< the numbers that the constraints bound; NaN if broken
  double violation = 0;             ///< largest g; <= kKept: all constraints are kept
  int combination = 0;              ///< of the choices
  bool Kept() const;
};

struct SearchResult {
  bool all = false;  ///< the search came to its end
  std::vector<Candidate> candidates;
  /// For each combination of choices its best candidate: the least objective of those that keep all
  /// constraints, else the least violation; -1 if every one is broken.
  std::vector<int> best_of;
  int best = -1;  ///< over all combinations
};

/// Runs of the candidate with these numbers: candidate * cases + case.
Result<SearchResult> SearchOptimum(Study* study, int workers, WorkDir* work,
                                   const Progress& progress);

/// optimum.json and candidates.csv in `dir`; best/CASE/ with the files of the best candidate, which
/// name their place under the final path.
Status WriteOptimum(const Study& study, const SearchResult& result, const ResultDir& dir);

}  // namespace phs::sweep
