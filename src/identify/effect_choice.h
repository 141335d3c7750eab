// Which of the effects tried on top of a model is taken: not always the one that explains most.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "identify/effect_search.h"
#include "identify/effect_trials.h"

namespace phs::identify::search {

/// By how much more an effect is preferred to another that contains it (FitsAsWellWithFewer).
double MarginOver(const std::string& simple, const std::string& other);

/// Simpler effects that the best of the trials contains get the form that the whole record asks
/// for, before they are weighed. `records`: what is said of each trial; `without`: the fit of
/// `model`, on top of which they were tried.
void ShapeContained(const FitProblem& problem, const FreeModel& model, const FitResult& without,
                    int best, std::vector<FullTrial>* trials, std::span<CandidateRecord> records);

/// Of those that explain practically as much as the best, the one with the fewest numbers: what
/// differs by direction must show that it does.
int FindSimplest(const FitProblem& problem, const std::vector<FullTrial>& trials,
                 std::span<const CandidateRecord> records, int best);

/// True, and said of the best plausible one, if one whose numbers are not plausible explains far
/// more: the truth is then of a form that the catalogue lacks, and no lesser effect is bent to
/// stand for it.
bool IsOverruled(const FitProblem& problem, const std::vector<FullTrial>& trials, int best,
                 std::span<CandidateRecord> records);

}  // namespace phs::identify::search
