// The one rule of acceptance, for effects, their forms and formulas alike (acceptance.h).
#pragma once

#include <string>
#include <vector>

#include "identify/fit/acceptance.h"
#include "identify/fit/effect_variants.h"
#include "identify/fit/evidence.h"
#include "identify/fit/search_fit.h"

namespace phs::identify::search {

inline constexpr const char* kAccepted = "accepted";
inline constexpr const char* kBeaten = "another explains more";
inline constexpr const char* kNotTold = "its amount is not told by the record, or not plausible";

/// True if a gain of the criterion [-2 ln L] is more than the best of `tried` structures would gain
/// by chance.
bool IsBeyondChance(const SearchRule& rule, double gain, double tried);

/// True if a fit has driven the number to an end of its range.
bool IsAtEnd(const FreeParameter& p, double value);

/// True if the record tells each of the last `count` numbers of a fit: it is on no bound, and its
/// 95 % interval is narrower than its plausible range. `free`: the last numbers of the model.
bool AreTold(const std::vector<FreeParameter>& free, const FitResult& fit, size_t count);

/// True if an amount of the candidate, whose numbers begin at `base` in `fit`, is beyond zero with
/// 95 % and none is on the far end of what is plausible.
bool IsThere(const Candidate& form, const FitResult& fit, size_t base);

/// Those of its amounts that are on the far end, with their values [SI], for people.
std::vector<std::string> AmountsAtEnd(const Candidate& form, const FitResult& fit, size_t base);

/// True of what a sensor says beyond the truth, not the rig.
bool IsOfInstrument(const Candidate& form);

/// True if the second is a special case of the first, as its row says.
bool Contains(const Candidate& form, const Candidate& other);

/// True if the first explains more than the second, as the criterion counts; a physical cause gives
/// way to an instrument's fault, and a special case to what contains it, only where that is ahead
/// beyond chance.
bool Beats(const FitProblem& problem, const Candidate& form, const FitResult& fit,
           const Candidate& other, const FitResult& other_fit);

/// Empty if the candidate may be accepted, else why not. `fit` ends with its numbers.
std::string Refusal(const SearchRule& rule, const Evidence& evidence, const Candidate& form,
                    const FitResult& fit);

}  // namespace phs::identify::search
