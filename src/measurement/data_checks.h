// Faults of measured channels that can be found without a fit, and mended or left out: spikes, a
// stuck or saturated sensor, a motion in another unit; and, against the declared model, a swapped
// sign, another unit, two channels under each other's name. Each leaves a word in the findings.
#pragma once

#include <vector>

#include "hydraulics/phs_params.h"
#include "measurement/fit_data.h"
#include "measurement/rig_data.h"

namespace phs::measurement {

/// Marks lone samples that jump off both neighbours by more than 12 noise levels, and far more than
/// the neighbours differ among themselves.
void MarkSpikes(Channel* channel, std::vector<DataFinding>* findings);

/// The same for a motion, which has no steps: lone samples beyond all four neighbours, and off the
/// cubic through them, by more than 12 noise levels and 4 times what these neighbours and the next
/// depart from one cubic, however fast it moves.
void MarkMotionSpikes(Channel* channel, std::vector<DataFinding>* findings);

/// Marks stretches in which a channel, noisy elsewhere, repeats one value to the last digit: at an
/// end of its range it is saturated, elsewhere stuck. Noise of deviation s, rounded to Q, repeats a
/// value with a probability of at most p = erf(Q/(2 sqrt(2) s)); so many repeats are marked, r, that
/// noise alone makes one such stretch in a channel of N samples once in a thousand channels,
/// N p^r = 1/1000. Where most values stand twice or more, the sensor's clock is slower: a repeat is
/// then one of its values. Where the driving motion repeats itself as well, the record has no noise.
void MarkStuck(Channel* channel, const RigRun& run, std::vector<DataFinding>* findings);

/// A driving motion ten times beyond the stroke is in mm (or um): brought to metres. Returns the
/// metres of one unit, 1 where nothing was to be done.
double MendInputScale(const hydraulics::PhsParams& params, Channel* input,
                      std::vector<DataFinding>* findings);

/// How far the swings of the outputs are from the prediction: median of |ln ratio|, what does not
/// follow it as if it were a thousand times off. A driving motion in cm puts all of them out.
double SwingsOff(const FitData& data, const std::vector<std::vector<double>>& predicted);

/// The driving motions times `factor`.
void ScaleInputs(double factor, FitData* data);

/// True if all channels that follow the model's prediction do so with the other sign: the driving
/// motion itself has its sign swapped.
bool InputIsSwapped(const FitData& data, const std::vector<std::vector<double>>& predicted);

/// Compares the outputs with those predicted by the declared model and mends what is beyond doubt:
/// two channels under each other's name (of one quantity or of two), a swapped sign, another unit
/// that is known (units.h). What swings 3 … 32 times too much or too little is asked about, not
/// mended.
void MendOutputs(const std::vector<std::vector<double>>& predicted, FitData* data);

/// What contradicts a fitted model all the same, a sentence each: a channel that runs against it,
/// two under each other's name, one that swings three times too much or too little, as in another
/// unit. `predicted`: what sound instruments would show.
std::vector<std::string> FindContradictions(const std::vector<std::vector<double>>& predicted,
                                            const FitData& data);

/// Leaves out every output where a pressure reads below absolute vacuum by more than an atmosphere
/// (no sensor shows that of oil, and no model gives it), from 10 ms before it crosses zero until as
/// long after it as it lasted: a model's vacuum is longer in filling. Not where that is more than a
/// twentieth of the record: then the reading has an offset.
void LeaveOutBelowVacuum(FitData* data);

}  // namespace phs::measurement
