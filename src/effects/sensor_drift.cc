#include "effects/sensor_drift.h"

#include <cmath>
#include <memory>
#include <string>

#include "effects/drift_time.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::ForcePlace;
using hydraulics::Sensor;
using hydraulics::Walk;

class Drift final : public hydraulics::ReadingLaw {
 public:
  Drift(double rate, double start_s, double settling_s)
      : rate_(rate), start_s_(start_s), settling_s_(settling_s) {}
  double Error(const ForcePlace& place) const noexcept override {
    return rate_ * DriftTime(place.time, start_s_, settling_s_);
  }

 private:
  double rate_, start_s_, settling_s_;
};

/// sine sin(2 pi t/P) + cosine (cos(2 pi t/P) - 1): nothing at t = 0.
class Wave final : public hydraulics::ReadingLaw {
 public:
  Wave(double sine, double cosine, double period_s)
      : sine_(sine), cosine_(cosine), period_s_(period_s) {}
  double Error(const ForcePlace& place) const noexcept override {
    const double phase = 2 * M_PI * place.time / period_s_;
    return sine_ * std::sin(phase) + cosine_ * (std::cos(phase) - 1);
  }

 private:
  double sine_, cosine_, period_s_;
};

struct SensorKeys {
  Sensor sensor;
  std::string drift, sine, cosine;
};
const SensorKeys kKeys[] = {
    {Sensor::kLoad, "load_N_per_s", "load_sine_N", "load_cosine_N"},
    {Sensor::kBorePressure, "p_bore_Pa_per_s", "p_bore_sine_Pa", "p_bore_cosine_Pa"},
    {Sensor::kRodPressure, "p_rod_Pa_per_s", "p_rod_sine_Pa", "p_rod_cosine_Pa"},
    {Sensor::kPiston, "piston_m_per_s", "", ""},
};

Status InstallSensorDrift(const EffectParams& effect, Extension* extension) {
  const auto value = [&](const std::string& key) { return effect.values.at(key); };
  const double start = value("start_s"), settling = value("settling_s");
  for (int i : TargetCylinders(effect, extension->params())) {
    for (const SensorKeys& keys : kKeys) {
      if (const double drift = value(keys.drift); drift != 0) {
        extension->AddReading(i, keys.sensor, std::make_unique<Drift>(drift, start, settling));
      }
      if (keys.sine.empty()) continue;
      const double sine = value(keys.sine), cosine = value(keys.cosine);
      if (sine == 0 && cosine == 0) continue;
      extension->AddReading(i, keys.sensor,
                            std::make_unique<Wave>(sine, cosine, value("period_s")));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& SensorDriftInfo() {
  static const EffectInfo info = {
      "sensor_drift",
      "instrument",
      "cylinders",
      "shown = true + drift t from start_s on; settling: drift T (1 - exp(-t/T)); and a slow wave",
      {
          {"load_N_per_s", "N/s", 0, -1e6, 1e6, -300, 300, "load cell"},
          {"p_bore_Pa_per_s", "Pa/s", 0, -1e7, 1e7, -5e4, 5e4, "bore pressure"},
          {"p_rod_Pa_per_s", "Pa/s", 0, -1e7, 1e7, -5e4, 5e4, "rod pressure"},
          {"piston_m_per_s", "m/s", 0, -1, 1, -1e-5, 1e-5, "piston"},
          {"load_sine_N", "N", 0, -1e7, 1e7, -3000, 3000, "wave of the load cell"},
          {"load_cosine_N", "N", 0, -1e7, 1e7, -3000, 3000, "wave of the load cell"},
          {"p_bore_sine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the bore pressure"},
          {"p_bore_cosine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the bore pressure"},
          {"p_rod_sine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the rod pressure"},
          {"p_rod_cosine_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "wave of the rod pressure"},
          {"period_s", "s", 100, 1, 1e9, 15, 1e4, "period of the wave"},
          {"settling_s", "s", 0, 0, 1e9, 0.3, 1e4, "T; 0 = never settles"},
          {"start_s", "s", 0, -1e12, 1e12, 0, 1e6, "the drift begins at this time"},
      },
      InstallSensorDrift,
      {
          .rig =
              {
                  {.free = {{"load_N_per_s", 0}}},
                  {.free = {{"p_bore_Pa_per_s", 0}}},
                  {.free = {{"p_rod_Pa_per_s", 0}}},
                  {.free = {{"piston_m_per_s", 0}}},
                  {.free = {{"load_N_per_s", 0.1}, {"settling_s", 30}}},
                  {.free = {{"p_bore_Pa_per_s", 100}, {"settling_s", 30}}},
                  {.free = {{"p_rod_Pa_per_s", 100}, {"settling_s", 30}}},
                  {.free = {{"piston_m_per_s", 1e-8}, {"settling_s", 30}}},
                  {.free = {{"load_N_per_s", 0.1}, {"settling_s", 5}, {"start_s", 12, 60, 4}}},
                  {.free = {{"p_bore_Pa_per_s", 100}, {"settling_s", 5}, {"start_s", 12, 60, 4}}},
                  {.free = {{"p_rod_Pa_per_s", 100}, {"settling_s", 5}, {"start_s", 12, 60, 4}}},
                  {.free = {{"load_sine_N", 0}, {"load_cosine_N", 0}, {"period_s", 40, 160, 3}},
                   .amounts = 2},
                  {.free = {{"p_bore_sine_Pa", 0},
                            {"p_bore_cosine_Pa", 0},
                            {"period_s", 40, 160, 3}},
                   .amounts = 2},
                  {.free = {{"p_rod_sine_Pa", 0}, {"p_rod_cosine_Pa", 0}, {"period_s", 40, 160, 3}},
                   .amounts = 2},
              },
          .bench =
              {
                  {.free = {{"load_N_per_s", 0, 0, 1, Walk::kEach, -1000, 1000}}},
              },
          .contains = {"sensor_offset"},
      }};
  return info;
}

}  // namespace phs::effects
