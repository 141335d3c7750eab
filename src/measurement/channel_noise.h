// Noise of measured channels, from the data alone: level, colour, quantisation.
#pragma once

#include <vector>

#include "measurement/rig_data.h"

namespace phs::measurement {

/// White part: standard deviation from fourth differences (a cubic trend drops out), the quietest
/// half of the record deciding, so that fast motion does not count as noise.
double WhiteNoise(const std::vector<double>& y, const std::vector<char>& bad);
/// Smallest step between different values if all values are multiples of it, else 0.
double Quantum(const std::vector<double>& y);
/// Below it there is no sensor's noise: a millionth of what the channel covers. Data without noise,
/// as from a program, are taken to have as much: what a model leaves there is its rounding.
double LeastNoise(const std::vector<double>& y);
/// Level and correlation at `rest`: deviation from a straight line over each stretch, where most of
/// that is no vibration and no bursts. The white part where there is no rest.
ChannelNoise EstimateNoise(const Channel& channel, const std::vector<char>& rest, double step_s);

}  // namespace phs::measurement
