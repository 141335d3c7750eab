#include "rigs/rig_channels.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace phs::rigs {
namespace {

using hydraulics::PhsSystem;
using hydraulics::ReadingLaws;
using hydraulics::Sensor;

/// What a channel is of: a cylinder and the indices of its channels, -1 = not among them.
struct Source {
  int cylinder = 0, piston = 0, bore = 2, rod = 3, load = 1;
};

using Values = std::vector<std::vector<double>>;

/// The true state of a cylinder at every sample, as the reading laws take it.
class TrueState {
 public:
  TrueState(const PhsSystem& system, const Source& source, const Values& truth, double step_s)
      : piston_(truth[static_cast<size_t>(source.piston)]),
        load_(truth[static_cast<size_t>(source.load)]),
        step_s_(step_s),
        further_(system.extra()) {
    const auto& params = system.params();
    const auto& cylinder = params.cylinders[static_cast<size_t>(source.cylinder)];
    const auto pressure = [&](const std::string& name, int channel) -> Pressure {
      const int line = params.FindLine(name);
      if (line < 0 || channel < 0) return {};
      return {&truth[static_cast<size_t>(channel)],
              params.lines[static_cast<size_t>(line)].static_pressure_Pa};
    };
    bore_ = pressure(cylinder.bore_line, source.bore);
    rod_ = pressure(cylinder.rod_line, source.rod);
  }
  /// Holds until the next call.
  hydraulics::ForcePlace At(size_t i, double time) {
    hydraulics::ForcePlace place;
    place.time = time;
    place.piston = piston_[i];
    place.speed = Speed(i);
    place.bore_rise = bore_.Rise(i);
    place.rod_rise = rod_.Rise(i);
    place.force = load_[i];
    if (further_ != nullptr) {
      further_->At(time, extra_);
      place.extra = extra_;
    }
    return place;
  }

 private:
  struct Pressure {
    const std::vector<double>* values = nullptr;
    double at_rest = 0;
    double Rise(size_t i) const { return values != nullptr ? (*values)[i] - at_rest : 0; }
  };
  /// Central difference; to one side at the ends.
  double Speed(size_t i) const {
    const size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, piston_.size() - 1);
    if (before == after) return 0;
    return (piston_[after] - piston_[before]) / (static_cast<double>(after - before) * step_s_);
  }

  const std::vector<double>& piston_;
  const std::vector<double>& load_;
  double step_s_;
  Pressure bore_, rod_;
  const hydraulics::ExtraSeries* further_;
  double extra_[hydraulics::kMaxExtra] = {};
};

class Instruments {
 public:
  Instruments(const PhsSystem& system, double t0_s, double step_s, Values* channels)
      : system_(system), t0_s_(t0_s), step_s_(step_s), channels_(*channels), truth_(*channels) {}

  void Apply(Sensor sensor, const Source& source, int channel) {
    const ReadingLaws& laws = system_.readings(source.cylinder, sensor);
    if (laws.empty()) return;
    std::vector<double>& y = channels_[static_cast<size_t>(channel)];
    for (const auto& law : laws) law->Lag(step_s_, &y);
    TrueState state(system_, source, truth_, step_s_);
    std::vector<double> memory(laws.size(), 0.0);
    hydraulics::ForcePlace before;
    for (size_t i = 0; i < y.size(); ++i) {
      const auto place = state.At(i, t0_s_ + static_cast<double>(i) * step_s_);
      if (i == 0) before = place;
      for (const auto& law : laws) y[i] = law->Scaled(y[i]);
      for (size_t k = 0; k < laws.size(); ++k) {
        y[i] += laws[k]->ErrorAfter(before, place, step_s_, &memory[k]);
      }
      before = place;
    }
  }

 private:
  const PhsSystem& system_;
  double t0_s_, step_s_;
  Values& channels_;
  const Values truth_;
};

void ApplyToFullRig(const PhsSystem& system, Instruments* instruments) {
  const auto& params = system.params();
  const auto line_of = [&](const std::string& name) {
    const int line = params.FindLine(name);
    return line < 0 ? -1 : 8 + line;
  };
  std::vector<char> shown(static_cast<size_t>(system.num_lines()), 0);
  for (int c = 0; c < 4; ++c) {
    const auto& cylinder = params.cylinders[static_cast<size_t>(c)];
    const Source source{c, c, line_of(cylinder.bore_line), line_of(cylinder.rod_line), 4 + c};
    instruments->Apply(Sensor::kPiston, source, c);
    instruments->Apply(Sensor::kLoad, source, 4 + c);
    for (const bool bore : {true, false}) {
      const int channel = bore ? source.bore : source.rod;
      if (channel < 0 || shown[static_cast<size_t>(channel - 8)]) continue;
      shown[static_cast<size_t>(channel - 8)] = 1;
      instruments->Apply(bore ? Sensor::kBorePressure : Sensor::kRodPressure, source, channel);
    }
  }
}

bool HasReadings(const PhsSystem& system) {
  for (int c = 0; c < system.num_cylinders(); ++c) {
    for (int sensor = 0; sensor < hydraulics::kSensors; ++sensor) {
      if (!system.readings(c, static_cast<Sensor>(sensor)).empty()) return true;
    }
  }
  return false;
}

}  // namespace

void ApplyInstruments(RigKind kind, const hydraulics::PhsSystem& system, double t0_s, double step_s,
                      RigPrediction* prediction) {
  if (!HasReadings(system)) return;
  Instruments instruments(system, t0_s, step_s, &prediction->channels);
  if (kind == RigKind::kFull) return ApplyToFullRig(system, &instruments);
  const Source source;
  instruments.Apply(Sensor::kPiston, source, 0);
  instruments.Apply(Sensor::kLoad, source, 1);
  instruments.Apply(Sensor::kBorePressure, source, 2);
  instruments.Apply(Sensor::kRodPressure, source, 3);
}

void ApplyBenchInstruments(const PhsSystem& system, const RigMotion& motion, Drive driven_by,
                           RigPrediction* prediction) {
  if (!HasReadings(system)) return;
  const bool by_force = driven_by == Drive::kForce;
  Values both = {motion.position_m[0], prediction->channels[0]};  // piston and load cell
  if (by_force) std::swap(both[0], both[1]);
  Instruments instruments(system, motion.t0_s, motion.step_s, &both);
  const Source source{.bore = -1, .rod = -1};
  by_force ? instruments.Apply(Sensor::kPiston, source, 0)
           : instruments.Apply(Sensor::kLoad, source, 1);
  prediction->channels[0] = std::move(both[by_force ? 0 : 1]);
}

}  // namespace phs::rigs
