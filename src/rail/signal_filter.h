// Digital filters and statistics of measured or simulated channels, as EN 14363 and UIC 518 ask.
//
// Butterworth filters: order 4 (24 dB per octave), cut-off where the gain is -3 dB; bilinear
// transform with the cut-off pre-warped, as two sections of second order. Channels are sampled
// uniformly. Filters start in the steady state of the first sample, so a constant passes unchanged.
#pragma once

#include <vector>

#include "base/result.h"

namespace phs::rail {

/// Low-pass: gain 1/sqrt(1 + (w/wc)^8). 0 < cut_off < sample_rate/2 [Hz].
Result<std::vector<double>> LowPass(const std::vector<double>& samples, double sample_rate,
                                    double cut_off);
/// High-pass: gain (w/wc)^4/sqrt(1 + (w/wc)^8).
Result<std::vector<double>> HighPass(const std::vector<double>& samples, double sample_rate,
                                     double cut_off);
/// High-pass at `low`, then low-pass at `high` [Hz].
Result<std::vector<double>> BandPass(const std::vector<double>& samples, double sample_rate,
                                     double low, double high);

/// Mean over a window that slides along the way: centres at distance[0] + window/2 + k step. The
/// channel is taken linear between samples, so the mean is exact for it at any speed. `distance`
/// [m] never falls. Empty when the way is shorter than the window.
Result<std::vector<double>> SlidingMean(const std::vector<double>& distance,
                                        const std::vector<double>& values, double window,
                                        double step);
/// The same with the root of the mean square (exact for a channel linear between samples).
Result<std::vector<double>> SlidingRms(const std::vector<double>& distance,
                                       const std::vector<double>& values, double window,
                                       double step);

/// Value below which `percent` of the samples lie: linear between the sorted samples, sample k of n
/// (from 0) at 100 k/(n - 1) percent. NaN when there are no samples.
double Percentile(std::vector<double> samples, double percent);

/// Largest size of the two ends of a distribution: max(|h1|, |h2|) of the percentiles `percent` and
/// 100 - `percent`.
double PercentileSize(const std::vector<double>& samples, double percent);

double Rms(const std::vector<double>& samples);

}  // namespace phs::rail
