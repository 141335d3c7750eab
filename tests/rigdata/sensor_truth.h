// The measuring chain of the true rig: what a channel does to its true signal y(t) before noise,
// and the noise itself.
//
//   reading = (1 + gain) · delay/lag[ y + hysteresis + crosstalk + curvature ] + offset + drift(t)
//   record  = round to quantum( reading + white + coloured + hum )
// Coloured noise: first-order autoregressive with correlation time `tau`.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "random_source.h"
#include "rig_truth.h"

namespace rigdata {

enum Channel { kActuator, kPiston, kLoad, kPBore, kPRod, kChannels };
inline constexpr std::array<const char*, kChannels> kChannelNames = {
    "actuator_m", "piston_m", "load_cell_N", "p_bore_Pa", "p_rod_Pa"};

enum class DriftForm { kNone, kLinear, kSettling, kWave, kWander };

struct SensorParams {
  double offset = 0;  // unit of the channel
  double gain = 0;    // relative
  double delay = 0;   // s, pure
  double lag = 0;     // s, first order
  DriftForm drift = DriftForm::kNone;
  double drift_amount = 0;         // unit of the channel: at 120 s, limit, amplitude, typical size
  double drift_tau = 50;           // s
  std::array<double, 4> wander{};  // phases of the wandering drift
  // Not on the list of known effects.
  double hysteresis = 0;         // unit of the channel, half width of the loop
  double hysteresis_span = 2e4;  // unit of the channel, travel to cross the loop
  double crosstalk = 0;          // share of the other pressure's change
  double curvature = 0;          // relative error at 10 MPa (100 kN), quadratic
};

struct NoiseParams {
  double white = 0, coloured = 0, tau = 0.05, hum = 0, hum_phase = 0;  // hum at 50 Hz
  double quantum = 0;
};

using SensorSet = std::array<SensorParams, kChannels>;
using NoiseSet = std::array<NoiseParams, kChannels>;

// One record: time and the five columns.
struct Record {
  std::vector<double> t;
  std::array<std::vector<double>, kChannels> channel;
  size_t size() const { return t.size(); }
};

// Readings without noise at 200 Hz from signals sampled at `rate` (a multiple of 200 Hz).
Record Read(const RigSignals& signals, const SensorSet& sensors, double rate);
// Adds noise and rounds to the quantum.
Record AddNoise(const Record& readings, const NoiseSet& noise, RandomSource random);
// Draws a plausible noise for every channel.
NoiseSet DrawNoise(RandomSource random);
// Standard deviation of the noise, with hum and rounding.
double NoiseLevel(const NoiseParams& noise);

}  // namespace rigdata
