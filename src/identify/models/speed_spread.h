// What the uncertainty of a measured speed makes of a model's outputs.
//
// The speed is v + s xi, s its standard deviation, xi standard normal. The outputs y then differ
// from those at v by
//   u^2 = E[(y(v + s xi) - y(v))^2]
// by the Gauss-Hermite rule of five nodes, exact where y is a polynomial of the fourth degree or
// less. Half the difference of y at v + s and v - s, u for a straight y, says nothing where friction
// turns two or three deviations away: one sample in a hundred lies beyond the turn, with all of the
// friction, and that is an error of a tenth of it.
#pragma once

#include <functional>

#include "identify/fit/forward_model.h"

namespace phs::identify::search {

/// `run(xi, out)`: the outputs at that many deviations from the measured speed, in every sample.
/// Gives u of every sample. Errors are those of `run`.
Status SpreadOverSpeed(const std::function<Status(double deviations, Channels* out)>& run,
                       Channels* u);

}  // namespace phs::identify::search
