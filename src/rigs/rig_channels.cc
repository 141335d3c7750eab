#include "rigs/rig_channels.h"

#include <cmath>
#include <string>
#include <vector>

#include "hydraulics/drift_time.h"

namespace phs::rigs {
namespace {

using Channel = hydraulics::InstrumentTerms::Channel;

/// What a channel is of: a cylinder and the indices of its channels, -1 = not among them.
struct Source {
  int cylinder = 0, piston = 0, bore = 2, rod = 3;
};

using Values = std::vector<std::vector<double>>;

/// The true state at a sample, as a formula takes it.
hydraulics::ForcePlace PlaceOf(const hydraulics::PhsSystem& system, const Source& source,
                               const Values& channels, size_t i) {
  const auto& params = system.params();
  const auto& cylinder = params.cylinders[static_cast<size_t>(source.cylinder)];
  const auto rise = [&](const std::string& name, int channel) {
    const int line = params.FindLine(name);
    if (line < 0 || channel < 0) return 0.0;
    return channels[static_cast<size_t>(channel)][i] -
           params.lines[static_cast<size_t>(line)].static_pressure_Pa;
  };
  hydraulics::ForcePlace place;
  place.piston = channels[static_cast<size_t>(source.piston)][i];
  place.bore_rise = rise(cylinder.bore_line, source.bore);
  place.rod_rise = rise(cylinder.rod_line, source.rod);
  return place;
}

void Delay(double delay_s, double step_s, std::vector<double>* values) {
  std::vector<double>& y = *values;
  const double shift = delay_s / step_s;
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

class Instruments {
 public:
  Instruments(const hydraulics::PhsSystem& system, double t0_s, double step_s, Values* channels)
      : system_(system), t0_s_(t0_s), step_s_(step_s), channels_(*channels) {
    bool further = false;
    for (int c = 0; c < system.num_cylinders(); ++c) {
      const auto& terms = system.instruments(c);
      for (const Channel* error : {&terms.piston, &terms.p_bore, &terms.p_rod}) {
        further |= error->further != nullptr;
      }
    }
    if (further) truth_ = channels_;
  }

  void Apply(const Channel& error, const Source& source, int channel) {
    const auto& terms = system_.instruments(source.cylinder);
    std::vector<double>& y = channels_[static_cast<size_t>(channel)];
    if (error.delay_s > 0) Delay(error.delay_s, step_s_, &y);
    for (size_t i = 0; i < y.size(); ++i) {
      const double t = t0_s_ + static_cast<double>(i) * step_s_;
      y[i] = error.gain * y[i] + error.offset +
             error.drift_per_s * hydraulics::DriftTime(t, terms.start_s, terms.settling_s);
      if (error.wave_sine != 0 || error.wave_cosine != 0) {
        const double phase = 2 * M_PI * t / terms.period_s;
        y[i] += error.wave_sine * std::sin(phase) + error.wave_cosine * (std::cos(phase) - 1);
      }
      if (error.further == nullptr) continue;
      hydraulics::ForcePlace place = PlaceOf(system_, source, truth_, i);
      place.time = t;
      y[i] += error.further->Error(place);
    }
  }

 private:
  const hydraulics::PhsSystem& system_;
  double t0_s_, step_s_;
  Values& channels_;
  Values truth_;  ///< empty if no formula asks for it
};

void ApplyToFullRig(const hydraulics::PhsSystem& system, Instruments* instruments) {
  const auto& params = system.params();
  const auto line_of = [&](const std::string& name) {
    const int line = params.FindLine(name);
    return line < 0 ? -1 : 8 + line;
  };
  std::vector<char> shown(static_cast<size_t>(system.num_lines()), 0);
  for (int c = 0; c < 4; ++c) {
    const auto& cylinder = params.cylinders[static_cast<size_t>(c)];
    const auto& error = system.instruments(c);
    const Source source{c, c, line_of(cylinder.bore_line), line_of(cylinder.rod_line)};
    instruments->Apply(error.piston, source, c);
    instruments->Apply(error.load, source, 4 + c);
    for (const bool bore : {true, false}) {
      const int channel = bore ? source.bore : source.rod;
      if (channel < 0 || shown[static_cast<size_t>(channel - 8)]) continue;
      shown[static_cast<size_t>(channel - 8)] = 1;
      instruments->Apply(bore ? error.p_bore : error.p_rod, source, channel);
    }
  }
}

}  // namespace

void ApplyInstruments(RigKind kind, const hydraulics::PhsSystem& system, double t0_s, double step_s,
                      RigPrediction* prediction) {
  bool any = false;
  for (int c = 0; c < system.num_cylinders(); ++c) any |= system.instruments(c).present;
  if (!any) return;
  Instruments instruments(system, t0_s, step_s, &prediction->channels);
  if (kind == RigKind::kFull) return ApplyToFullRig(system, &instruments);
  const auto& error = system.instruments(0);
  if (kind == RigKind::kElement) return instruments.Apply(error.load, {}, 0);
  const Source source;
  instruments.Apply(error.piston, source, 0);
  instruments.Apply(error.load, source, 1);
  instruments.Apply(error.p_bore, source, 2);
  instruments.Apply(error.p_rod, source, 3);
}

}  // namespace phs::rigs
