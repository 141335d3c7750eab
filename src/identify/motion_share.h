// How much of a residual follows what the rig did.
//
// A sensor's noise may have a colour, and a bench shakes: both leave more than white noise, and no
// model would describe it. What a model lacks follows motion and pressures instead. So the residual
// is regressed, octave by octave (octave_bands.h), on many functions of the signals at once:
//   u, u², u³, u', |u'|, u'|u'|, s, s u     s = u'/(|u'| + rms(u')/10)
// of each signal u (over its standard deviation). Of n coefficients of an octave at most n/4
// functions take part, those in which the signals vary most (principal components). The share R²
// that they take is lessened by what chance takes, k of n (Ezekiel's adjusted R²). It is a part
// only of what depends on the signals with memory or sharp edges: enough to tell that something
// follows, not how much in all. In octaves with fewer than 32 coefficients, mean and slope among
// them, all counts that is beyond noise as strong as what is left in the octave above: an offset and
// a drift are no colour.
#pragma once

#include <vector>

namespace phs::identify {

/// What is left of a channel over a window.
struct LeftOver {
  double over_noise = 0;  ///< rms over noise and the model's own uncertainty
  double following = 0;   ///< mean square of it that follows what the rig did
};

/// Mean square of the part of `residual` (over its noise) that follows `signals`.
/// The residual is even in time, NaN where nothing was measured; signals on the same rows, finite.
/// Where it cannot be told (fewer than 64 rows, a signal that is missing or not finite) all of the
/// residual counts: nothing is taken for noise unseen.
double MeanSquareThatFollows(const std::vector<double>& residual,
                             const std::vector<std::vector<double>>& signals);

}  // namespace phs::identify
