// A second effect that is the form of a stronger one.
//
// No law has quite the form that is in the record, and with many samples the likelihood sees what
// it leaves. Another effect may take that though it is not there. So a law may bend: what it does
// to each channel, d, may grow or fall to first order with its own size, the direction, x, |v|, p,
// q and t, and come early or late:
//   d (1 + a1 |d|/max|d| + a2 s + a3 x + …) + b dd/dt,   at most three of these, chosen by evidence,
// fitted as columns beside the slopes of the model's own numbers. A cause of its own keeps its
// evidence beside a bent law; what mends its form loses most of it.
#pragma once

#include <optional>

#include "identify/select/identification.h"

namespace phs::identify::search {

/// The stronger effect of `found` beside which, bent, effect `i` keeps less than half of its
/// evidence. `rest`: the fit of `model`, that is `found` without effect i, with slopes. Nothing:
/// there is none, or the forward model says nothing of where the record is.
std::optional<size_t> IsFormOf(const FitProblem& problem, const Identification& found, size_t i,
                               const FreeModel& model, const FitResult& rest);

}  // namespace phs::identify::search
