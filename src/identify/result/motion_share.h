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
//
// What follows nothing is noise of the sensor only if it is there all the time. A machine beside the
// rig comes and goes. Of eight parts of the window let two leave at most e of what the window leaves
// on average, both beyond the noise. A colour that lasts shorter than a part and is there all the
// time has a power per part that varies at most as the square of a complex Gaussian amplitude does,
// by e^-x; chance then makes two of eight so quiet with a probability below 28 e^2. Below the share
// of false alarms that is wanted (acceptance.h) it is taken to come and go. A part counts as no
// quieter than twice the square of its noise.
//
// Blows (a press next door) may come in every part. Noise of a colour has normal values; where
// three quarters of the mean square are beyond what their median magnitude tells, it is no noise. Of
// 40 independent values the root of that share scatters by some 0.15, so that chance stays away.
//
// Nor does a sensor know whether the rig moves. A seal that squeals follows no function of the motion,
// but it is silent at rest. With quiet stretches at rest in the place of parts, the loudest of k of
// which leaves e of what the rest of the window leaves, chance makes all k so quiet with e^k.
//
// A loose plug, or an amplifier that changes its range, goes to and fro between two readings. About
// the two levels that leave least a sine leaves 0.19 of its mean square, what is spread evenly 0.25,
// a normal noise 0.36; what leaves less than half as much as the sine stands on them.
#pragma once

#include <optional>
#include <vector>

namespace phs::identify {

/// Of what stands on two levels.
struct TwoLevels {
  double apart = 0;  ///< over the noise
  int jumps = 0;     ///< from one to the other, at least two
};

/// What is left of a channel over a window.
struct LeftOver {
  double over_noise = 0;        ///< rms over noise and the model's own uncertainty
  double following = 0;         ///< mean square of it that follows what the rig did
  bool comes_and_goes = false;  ///< for a part of the window, or at rest, it is as good as quiet
  bool quiet_at_rest = false;   ///< IsQuietAtRest
  double swings = 0;            ///< SwingsAt, cycles per row
  std::optional<TwoLevels> levels = {};
};

/// Mean square of the part of `residual` (over its noise) that follows `signals`.
/// The residual is even in time, NaN where nothing was measured; signals on the same rows, finite.
/// Where it cannot be told (fewer than 64 rows, a signal that is missing or not finite) all of the
/// residual counts: nothing is taken for noise unseen.
double MeanSquareThatFollows(const std::vector<double>& residual,
                             const std::vector<std::vector<double>>& signals);

/// True if `residual` (over its noise, even in time, NaN where nothing was measured) is louder in
/// some parts than noise that is always there. False with fewer than 64 rows.
bool ComesAndGoes(const std::vector<double>& residual);

/// True if `residual`, as above, is far quieter in each of at least two stretches where the rig stands
/// `still` (a flag for each row) than elsewhere.
bool IsQuietAtRest(const std::vector<double>& residual, const std::vector<char>& still);

/// Frequency [cycles per row] about which, within a tenth or two lines, half or more of the mean square
/// of `residual`, as above, beyond the noise lies, and less than a tenth of that of what drives the
/// rig (`drives`, on the same rows): of a pump, a frame, a squeal. 0: none, or fewer than 512 rows.
/// Spectrum: segments of a 32nd of the rows, 256 at least, Hann's window, half overlapping (Welch 1967).
double SwingsAt(const std::vector<double>& residual,
                const std::vector<std::vector<double>>& drives);

/// The two levels on which `residual`, as above, stands: six times its noise apart or more, so that
/// each sample tells where it is, with five samples or more from jump to jump on average. None with
/// fewer than 64 rows.
std::optional<TwoLevels> FindTwoLevels(const std::vector<double>& residual);

}  // namespace phs::identify
