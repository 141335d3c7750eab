#include "effects/sensor_delay.h"

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;
using hydraulics::Walk;

class Delay final : public hydraulics::ReadingLaw {
 public:
  explicit Delay(double delay_s) : delay_s_(delay_s) {}
  // Between samples linear; before the first sample the first value holds.
  void Lag(double step, std::vector<double>* values) const override {
    std::vector<double>& y = *values;
    const double shift = delay_s_ / step;
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

 private:
  double delay_s_;
};

Status InstallSensorDelay(const EffectParams& effect, Extension* extension) {
  AddReadings<Delay>(effect,
                     {{Sensor::kLoad, "load_s"},
                      {Sensor::kBorePressure, "p_bore_s"},
                      {Sensor::kRodPressure, "p_rod_s"},
                      {Sensor::kPiston, "piston_s"}},
                     0, extension);
  return {};
}

}  // namespace

const EffectInfo& SensorDelayInfo() {
  static const EffectInfo info = {
      "sensor_delay",
      "instrument",
      "cylinders",
      "shown(t) = true(t - delay)",
      {
          {"load_s", "s", 0, 0, 100, 0, 0.2, "load cell"},
          {"p_bore_s", "s", 0, 0, 100, 0, 0.2, "bore pressure"},
          {"p_rod_s", "s", 0, 0, 100, 0, 0.2, "rod pressure"},
          {"piston_s", "s", 0, 0, 100, 0, 0.2, "piston"},
      },
      InstallSensorDelay,
      {
          .rig =
              {
                  {.free = {{"load_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_bore_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_rod_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_bore_s", 2e-3, 0.02, 2},
                            {"p_rod_s", 2e-3, 0.02, 2, Walk::kInStep}}},
                  {.free = {{"piston_s", 2e-3, 0.02, 2}}},
              },
          .bench =
              {
                  {.free = {{"load_s", 1e-3, 0.01, 2, Walk::kEach, 0, 0.2, true}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
