// From measured data to a corrected model: one search for every rig.
//
// Forward: candidates are screened and fitted (trials.h) on top of the model so far, about its best
// fit, a robust one, and with each declared number held that the fit has moved by a tenth; the best
// that passes the rule of acceptance (accept.h) is added, and so on. Then what the others made
// superfluous goes, and what remains is described by a formula. The validation window is not looked
// at.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "identify/select/identification.h"
#include "identify/select/screening.h"

namespace phs::identify::search {

struct SearchOptions {
  Effort effort;
  SearchRule rule;
  bool formula = true;  ///< what no effect explains is described
  /// Two effects that the next test is to tell apart (test_question.h); none: what the record leaves
  /// open.
  std::vector<std::string> between = {};
};

/// Progress from 0 to 1; false cancels.
using Progress = std::function<bool(double)>;

Result<Identification> Identify(FitProblem* problem, const hydraulics::PhsParams& declared,
                                const SearchOptions& options, const Progress& progress);

}  // namespace phs::identify::search
