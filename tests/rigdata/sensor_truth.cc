#include "sensor_truth.h"

#include <algorithm>
#include <cmath>

#include "motion.h"

namespace rigdata {
namespace {

constexpr double kOutputRate = 200.0;  // Hz
constexpr double kHumFrequency = 50.0;

double Drift(const SensorParams& s, double t) {
  switch (s.drift) {
    case DriftForm::kNone:
      return 0;
    case DriftForm::kLinear:
      return s.drift_amount * t / 120.0;
    case DriftForm::kSettling:
      return s.drift_amount * (1.0 - std::exp(-t / s.drift_tau));
    case DriftForm::kWave:
      return s.drift_amount * std::sin(kTwoPi * t / (4.0 * s.drift_tau));
    case DriftForm::kWander: {
      // A few slow incommensurate waves, zero at the start.
      constexpr double kPeriod[4] = {310, 173, 97, 61};
      double sum = 0;
      for (int i = 0; i < 4; ++i) {
        const double weight = kPeriod[i] / kPeriod[0];
        sum += weight * (std::sin(kTwoPi * t / kPeriod[i] + s.wander[i]) - std::sin(s.wander[i]));
      }
      return s.drift_amount * sum;
    }
  }
  return 0;
}

// A play operator (half width r) passed through: reading lags by up to the loop width.
std::vector<double> WithHysteresis(const std::vector<double>& y, const SensorParams& s) {
  std::vector<double> out(y.size());
  double play = y.empty() ? 0 : y.front();
  const double r = 0.5 * s.hysteresis_span;
  for (size_t i = 0; i < y.size(); ++i) {
    play = std::clamp(play, y[i] - r, y[i] + r);
    out[i] = y[i] + s.hysteresis * (play - y[i]) / r;
  }
  return out;
}

std::vector<double> WithDelay(const std::vector<double>& y, const SensorParams& s, double rate) {
  std::vector<double> out(y.size());
  const double shift = s.delay * rate;
  const double share = 1.0 / (1.0 + s.lag * rate);
  double lagged = y.empty() ? 0 : y.front();
  for (size_t i = 0; i < y.size(); ++i) {
    const double at = std::max(0.0, static_cast<double>(i) - shift);
    const size_t k = std::min(static_cast<size_t>(at), y.size() - 1);
    const double u = at - static_cast<double>(k);
    const double value = k + 1 < y.size() ? y[k] + u * (y[k + 1] - y[k]) : y[k];
    lagged += share * (value - lagged);
    out[i] = lagged;
  }
  return out;
}

std::vector<double> Transform(std::vector<double> y, const std::vector<double>* other,
                              const SensorParams& s, double rate, double full) {
  if (s.curvature != 0) {
    for (double& value : y) value *= 1.0 + s.curvature * value / full;
  }
  if (s.crosstalk != 0 && other != nullptr) {
    for (size_t i = 0; i < y.size(); ++i) y[i] += s.crosstalk * ((*other)[i] - other->front());
  }
  if (s.hysteresis != 0) y = WithHysteresis(y, s);
  if (s.delay > 0 || s.lag > 0) y = WithDelay(y, s, rate);
  return y;
}

}  // namespace

Record Read(const RigSignals& signals, const SensorSet& sensors, double rate) {
  const std::array<const std::vector<double>*, kChannels> source = {
      &signals.actuator, &signals.piston, &signals.load, &signals.p_bore, &signals.p_rod};
  const size_t stride = static_cast<size_t>(std::lround(rate / kOutputRate));
  Record record;
  for (size_t i = 0; i < signals.size(); i += stride) record.t.push_back(signals.t[i]);
  for (int c = 0; c < kChannels; ++c) {
    const SensorParams& s = sensors[c];
    const std::vector<double>* other =
        c == kPBore ? source[kPRod] : (c == kPRod ? source[kPBore] : nullptr);
    const double full = c == kLoad ? 1.0e5 : 1.0e7;
    const std::vector<double> y = Transform(*source[c], other, s, rate, full);
    std::vector<double>& out = record.channel[c];
    out.reserve(record.size());
    for (size_t i = 0; i < y.size(); i += stride) {
      out.push_back((1.0 + s.gain) * y[i] + s.offset + Drift(s, signals.t[i]));
    }
  }
  return record;
}

Record AddNoise(const Record& readings, const NoiseSet& noise, RandomSource random) {
  Record record = readings;
  for (int c = 0; c < kChannels; ++c) {
    const NoiseParams& n = noise[c];
    RandomSource own(random.NextBits());
    const double keep = std::exp(-1.0 / (kOutputRate * n.tau));
    const double drive = std::sqrt(1.0 - keep * keep);
    double slow = own.Normal();
    for (size_t i = 0; i < record.size(); ++i) {
      slow = keep * slow + drive * own.Normal();
      // Sampled at 200 Hz, mains hum drifts slowly in phase: the mains is never exactly 50 Hz.
      const double hum =
          n.hum * std::sin(kTwoPi * (kHumFrequency + 0.013) * record.t[i] + n.hum_phase);
      double value = record.channel[c][i] + n.white * own.Normal() + n.coloured * slow + hum;
      if (n.quantum > 0) value = n.quantum * std::round(value / n.quantum);
      record.channel[c][i] = value;
    }
  }
  return record;
}

NoiseSet DrawNoise(RandomSource random) {
  const double quality = random.LogUniform(0.8, 2.2);  // of the whole instrumentation
  const auto draw = [&](double white, double coloured, double tau_low, double tau_high, double hum,
                        double quantum) {
    NoiseParams n;
    n.white = quality * white * random.LogUniform(0.65, 1.6);
    n.coloured = quality * coloured * random.LogUniform(0.5, 1.8);
    n.tau = random.LogUniform(tau_low, tau_high);
    n.hum = hum * random.Uniform();
    n.hum_phase = random.Uniform(0, kTwoPi);
    n.quantum = quantum;
    return n;
  };
  NoiseSet set;
  // LVDT ±15 mm (0.25 µm steps), laser sensor 0.5 µm, 250 kN load cell and 25 MPa pressure sensors
  // at 15 or 16 bit. Levels: a few 1e-4 of full scale or less, as good industrial sensors have.
  const double bits = random.Coin() ? 32768.0 : 65536.0;
  set[kActuator] = draw(0.5e-6, 0.15e-6, 0.01, 0.1, 0.1e-6, 0.25e-6);
  set[kPiston] = draw(1.2e-6, 0.4e-6, 0.01, 0.2, 0.1e-6, 0.5e-6);
  set[kLoad] = draw(28, 12, 0.01, 0.3, 12, 5.0e5 / bits);
  set[kPBore] = draw(5.0e3, 2.5e3, 0.01, 0.3, 1.5e3, 25e6 / bits);
  set[kPRod] = draw(5.0e3, 2.5e3, 0.01, 0.3, 1.5e3, 25e6 / bits);
  return set;
}

double NoiseLevel(const NoiseParams& n) {
  return std::sqrt(n.white * n.white + n.coloured * n.coloured + 0.5 * n.hum * n.hum +
                   n.quantum * n.quantum / 12.0);
}

}  // namespace rigdata
