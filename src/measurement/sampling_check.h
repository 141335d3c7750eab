// Is a motion sampled often enough? What moves faster than a quarter of the sampling rate has two
// or three samples a turn: its speed and acceleration between them are not known, and a model
// driven by it answers to another motion.
//
// The position is looked at in stretches of 64 samples (Hann's window, straight line taken out). Of
// the mean square of the speed, (2 pi f)² P(f), the share above a quarter of the rate counts.
// Noise, and what an uneven clock makes of a motion, is taken as white within a stretch: its level
// is the lowest power between a quarter and half of the rate, of the stretch itself or of the
// median one, whichever is higher. A stretch is judged where its speed is 20 times that [mean
// square], so that noise does not pass for a tenth. Motion as white as noise up to half of the rate
// cannot be told from noise.
#pragma once

#include <vector>

#include "base/result.h"
#include "measurement/rig_data.h"

namespace phs::measurement {

struct FastMotion {
  double share = 0;  ///< of the stretches judged: those with more than a tenth above the quarter
  double reaches_Hz = 0;  ///< 95 % of the speed's mean square lies below
};
/// `step_s` > 0. Stretches with a `bad` sample are not judged.
FastMotion FindFastMotion(const std::vector<double>& position, const std::vector<char>& bad,
                          double step_s);

/// Error where more than half of the time in motion is too fast for the clock; a finding from a
/// tenth on.
Status CheckSampling(const Channel& input, const RigRun& run, std::vector<DataFinding>* findings);

}  // namespace phs::measurement
