// What the catalogue does not hold, on a rig with one cylinder: a force over direction, speed,
// place, pressures and time (formula_search.h), sought in the residual of the load cell, or a law
// of a line (line_formula.h), added as the effect `unlisted`.
#pragma once

#include "identify/discrepancy/formula_search.h"
#include "identify/fit/effect_variants.h"
#include "identify/fit/evidence.h"
#include "identify/fit/search_fit.h"

namespace phs::identify::search {

/// The formula that the load cell's residual of this fit asks for; empty if none, or if the rig has
/// no such channel or more than one cylinder.
FoundFormula SearchForceFormula(const FitProblem& problem, const FreeModel& model,
                                const FitResult& fit, const FormulaLimits& limits);

/// The formula that the sensor of piston or pressures asks for whose residual it lessens most,
/// among those whose mean square is above `noise` times that of their noise.
FoundFormula SearchReadingFormula(const FitProblem& problem, const FreeModel& model,
                                  const FitResult& fit, double noise, const FormulaLimits& limits);

/// Structures that a search for a formula looks at: its library of terms is about as large.
inline constexpr double kTermsTried = 300;

/// A formula found and fitted together with all numbers of a model.
struct FormulaTrial {
  FoundFormula found;
  Candidate candidate;
  FreeModel model;  ///< with the formula
  FitResult fit;    ///< not ok: nothing found
  Evidence evidence;
  double channel_gain = 0;  ///< share of the residual rms of its channel that went
};
/// A force over direction, speed, place, pressures and time for what the load cell still shows, a
/// law of a line (line_formula.h) for the pressures, or what a sensor of piston or pressures shows
/// beyond the truth over place, pressures and time: the one that explains more.
FormulaTrial TryFormula(const FitProblem& problem, const FitProblem& coarse, const FreeModel& model,
                        const FitResult& fit, const FormulaLimits& limits);

/// The formula as an effect whose coefficients are free; bounds: `most` (in its unit) to either
/// side.
Candidate FormulaCandidate(const FoundFormula& found, double most);

}  // namespace phs::identify::search
