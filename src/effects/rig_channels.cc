#include "effects/rig_channels.h"

#include <cmath>

#include "hydraulics/drift_time.h"

namespace phs::effects {
namespace {

using Channel = hydraulics::InstrumentTerms::Channel;

void Apply(const Channel& error, const hydraulics::InstrumentTerms& terms, double t0_s,
           double step_s, std::vector<double>* values) {
  std::vector<double>& y = *values;
  if (error.delay_s > 0) {
    const double shift = error.delay_s / step_s;
    for (size_t i = y.size(); i-- > 0;) {
      const double at = static_cast<double>(i) - shift;
      if (at <= 0) {
        y[i] = y[0];
        continue;
      }
      const size_t k = static_cast<size_t>(at);
      const double part = at - static_cast<double>(k);
      y[i] = part > 0 ? y[k] + part * (y[k + 1] - y[k]) : y[k];
    }
  }
  for (size_t i = 0; i < y.size(); ++i) {
    const double t = t0_s + static_cast<double>(i) * step_s;
    y[i] = error.gain * y[i] + error.offset +
           error.drift_per_s * hydraulics::DriftTime(t, terms.start_s, terms.settling_s);
    if (error.wave_sine != 0 || error.wave_cosine != 0) {
      const double phase = 2 * M_PI * t / terms.period_s;
      y[i] += error.wave_sine * std::sin(phase) + error.wave_cosine * (std::cos(phase) - 1);
    }
  }
}

void ApplyToLines(const hydraulics::PhsSystem& system, double t0_s, double step_s,
                  RigPrediction* prediction) {
  const auto& cylinders = system.params().cylinders;
  for (int l = 0; l < system.num_lines(); ++l) {
    for (size_t c = 0; c < cylinders.size(); ++c) {
      const auto& error = system.instruments(static_cast<int>(c));
      const bool bore = cylinders[c].bore_line == system.line_names()[l];
      if (!bore && cylinders[c].rod_line != system.line_names()[l]) continue;
      Apply(bore ? error.p_bore : error.p_rod, error, t0_s, step_s, &prediction->channels[8 + l]);
      break;
    }
  }
}

}  // namespace

void ApplyInstruments(RigKind kind, const hydraulics::PhsSystem& system, double t0_s, double step_s,
                      RigPrediction* prediction) {
  bool any = false;
  for (int c = 0; c < system.num_cylinders(); ++c) any |= system.instruments(c).present;
  if (!any) return;
  auto& channels = prediction->channels;
  if (kind == RigKind::kElement) {
    Apply(system.instruments(0).load, system.instruments(0), t0_s, step_s, &channels[0]);
  } else if (kind == RigKind::kFull) {
    for (int c = 0; c < 4; ++c) {
      Apply(system.instruments(c).piston, system.instruments(c), t0_s, step_s, &channels[c]);
      Apply(system.instruments(c).load, system.instruments(c), t0_s, step_s, &channels[4 + c]);
    }
    ApplyToLines(system, t0_s, step_s, prediction);
  } else {
    const auto& error = system.instruments(0);
    Apply(error.piston, error, t0_s, step_s, &channels[0]);
    Apply(error.load, error, t0_s, step_s, &channels[1]);
    Apply(error.p_bore, error, t0_s, step_s, &channels[2]);
    Apply(error.p_rod, error, t0_s, step_s, &channels[3]);
  }
}

}  // namespace phs::effects
