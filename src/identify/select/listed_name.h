// A term found as a formula that is a listed effect becomes it.
//
// A missing law bends the declared numbers, and about a bent fit its effect may look like nothing.
// With a formula in its place the declared numbers come right: from there every listed effect is
// fitted once more. One that explains as much gives the formula its name: the formula is not ahead
// of it by more than chance does among so many terms (accept.h). Of two names a physical cause goes
// before an instrument.
#pragma once

#include <optional>

#include "identify/discrepancy/driven_formula.h"
#include "identify/select/screening.h"
#include "identify/select/trials.h"

namespace phs::identify::search {

struct ListedName {
  Candidate form;
  FitResult fit;
  Evidence evidence;  ///< over the model without it
};

/// True if a formula is ahead of a model fitted without it by more than chance.
bool SaysMore(const FitProblem& problem, const FitResult& listed, const FormulaTrial& formula);

/// The effect that explains as much as `formula`, both on top of `model` with its fit `without`;
/// nothing: it is on no list.
std::optional<ListedName> FindListedName(const FitProblem& problem, const FitProblem& coarse,
                                         const FreeModel& model, const FitResult& without,
                                         const FormulaTrial& formula, const Effort& effort,
                                         const std::function<bool(double)>& go_on);

}  // namespace phs::identify::search
