// Signal processing of running tests: filters, sliding means over distance, percentiles.
//
// Signals are sampled at equal intervals of time; `distance` is the place along the track of each
// sample, which never falls. After EN 14363 and UIC 518.
#pragma once

#include <vector>

#include "base/result.h"

namespace phs::analysis {

/// Butterworth filters of 4th order (24 dB per octave), run once forwards, started as if the first
/// value had lasted for ever. Bilinear transform with the cut-off frequency kept exact. Errors:
/// interval <= 0, cut-off not between 0 and half the sampling rate.
Result<std::vector<double>> LowPass(const std::vector<double>& signal, double interval_s,
                                    double cutoff_Hz);
Result<std::vector<double>> HighPass(const std::vector<double>& signal, double interval_s,
                                     double cutoff_Hz);
/// High-pass at `low_Hz`, then low-pass at `high_Hz`.
Result<std::vector<double>> BandPass(const std::vector<double>& signal, double interval_s,
                                     double low_Hz, double high_Hz);

/// Means over windows [d, d + window], d = first place, first place + step, … as long as a whole
/// window fits; the signal is taken as linear between samples. @pre equal sizes. Standing
/// still carries no weight; running back is an error.
Result<std::vector<double>> SlidingMean(const std::vector<double>& distance,
                                        const std::vector<double>& signal, double window_m,
                                        double step_m);
/// Root of the sliding mean of squares.
Result<std::vector<double>> SlidingRms(const std::vector<double>& distance,
                                       const std::vector<double>& signal, double window_m,
                                       double step_m);

/// Value that `percent` (0 … 100) of the samples do not exceed, linear between ranks; not a number
/// without samples.
double Percentile(std::vector<double> samples, double percent);

}  // namespace phs::analysis
