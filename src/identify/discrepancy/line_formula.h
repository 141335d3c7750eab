// What the catalogue does not hold, in a line: a volume that it takes up over its pressure, or a
// flow out of it (or from bore to rod) over pressure and time, sought in the residual of all
// channels and added as the effect `unlisted`.
//
// A term's column is what the model itself answers to a small amount of it, so that compliance,
// memory and every channel are in it: column = (r(0) - r(c))/c, r the weighted residual. Terms are
// p/P, its square and cube, p |p|/P², t p/(T P), and beyond a pressure p_c from a scan max(p - p_c,
// 0)/P and its square, above and below the static pressure. A flow may also be a wave over time,
// whatever the pressure: a pump beside the rig, a hose that somebody else squeezes.
#pragma once

#include <vector>

#include "identify/discrepancy/formula_selection.h"
#include "identify/fit/search_fit.h"

namespace phs::identify::search {

/// The formula that this residual asks for at one place (a line, all lines, a piston), the place
/// whose evidence is largest; empty if there is none. `problem`: the coarse one will do.
FoundFormula SearchLineFormula(const FitProblem& problem, const FreeModel& model,
                               const std::vector<double>& values, const FormulaLimits& limits);

/// The same at the place of a law found before, linearised about the model that has it, so that a
/// strong law's own doing is in the columns: what it takes off is given back, and the terms compete
/// for it anew: all of them or, as powers imitate a threshold, those beyond a pressure only.
/// `model` ends with the law's coefficients, `base` numbers come before.
FoundFormula SearchAnew(const FitProblem& problem, const FreeModel& model,
                        const std::vector<double>& values, size_t base, const FoundFormula& law,
                        bool thresholds_only, const FormulaLimits& limits);

}  // namespace phs::identify::search
