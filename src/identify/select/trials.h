// Effects tried on top of a model: screened and shaped on the coarse record, the best fitted to the
// whole one.
#pragma once

#include <functional>
#include <vector>

#include "identify/select/screening.h"

namespace phs::identify::search {

/// A screened candidate and, for the best, its form with options and its fit to the whole record.
struct FullTrial {
  const Candidate* candidate = nullptr;
  Candidate form;
  FitResult coarse, fit;
  double promise = 1e300;  ///< criterion on the coarse record
  bool fails = false;      ///< the model cannot be run with it (screening.h)
};

/// `points`: on the coarse record (screening.h). `go_on(share)`: progress from 0 to 1, false =
/// stop. Candidates of `list` must outlive the result.
std::vector<FullTrial> TryEffects(const FitProblem& problem, const FitProblem& coarse,
                                  const FreeModel& model, const FitResult& fit,
                                  const std::vector<Point>& points,
                                  const std::vector<Candidate>& list, const Effort& effort,
                                  const std::function<bool(double)>& go_on,
                                  KnownAnswers* known = nullptr);

}  // namespace phs::identify::search
