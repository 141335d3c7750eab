// Whether a fitted effect is accepted, and if not, why: the words that stand in the result.
#pragma once

#include <string>
#include <vector>

#include "identify/effect_search.h"

namespace phs::identify::search {

inline constexpr const char* kNotPlausible = "value not plausible";
inline constexpr const char* kBeaten = "another explains more";

/// True if the amount of the candidate ended on a bound: not plausible, or not there. Where it has
/// two amounts, one of them may be nil. A precharge within 0.2 % of the declared one, which no
/// gauge tells from it, is not there either. `model` ends with the candidate's numbers.
bool OnBound(const FreeModel& model, const FitResult& fit, const Candidate& candidate);

/// The same of any of `effects`, whose numbers follow the first `declared` of `model` in turn.
bool AnyOnBound(const FreeModel& model, const FitResult& fit, size_t declared,
                const std::vector<AcceptedEffect>& effects);

/// True if the record tells the amounts of the candidate: 95 % within a quarter of their range to
/// either side. One that trades against another effect's (two resistances, one behind the other)
/// is not.
bool IsSettled(const FreeModel& model, const FitResult& fit, const Candidate& candidate);

/// Empty if the effect may be accepted. `first`: nothing was accepted before it.
std::string Verdict(const Evidence& evidence, bool on_bound, bool first,
                    const SearchOptions& options);

/// The same of a formula. `load_gain`: share of its channel's residual rms that it takes.
std::string FormulaVerdict(const Evidence& evidence, double gain, bool first,
                           const SearchOptions& options);

/// Notes `effect`, fitted as `other`, beside an accepted one whose fit is `best` if the record does
/// not tell them apart: its residual is within the margin, or its evidence is not far behind.
void NoteConfusable(const FitProblem& problem, const FitResult& best, const FitResult& other,
                    const std::string& effect, const SearchOptions& options,
                    AcceptedEffect* accepted);

}  // namespace phs::identify::search
