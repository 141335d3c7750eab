#include "effects/sensor_saturation.h"

#include <cmath>

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

class Saturation final : public hydraulics::ReadingLaw {
 public:
  Saturation(double limit, double sharpness) : limit_(limit), sharpness_(sharpness) {}
  double Scaled(double value) const noexcept override {
    const double part = std::abs(value) / limit_;
    // Of a large signal by its inverse, so that nothing overflows.
    const double shown = part <= 1
                             ? part * std::pow(1 + std::pow(part, sharpness_), -1 / sharpness_)
                             : std::pow(1 + std::pow(part, -sharpness_), -1 / sharpness_);
    return std::copysign(limit_ * shown, value);
  }

 private:
  double limit_, sharpness_;
};

Status InstallSensorSaturation(const EffectParams& effect, Extension* extension) {
  AddReadings<Saturation>(effect,
                          {{Sensor::kLoad, "load_N"},
                           {Sensor::kBorePressure, "p_bore_Pa"},
                           {Sensor::kRodPressure, "p_rod_Pa"},
                           {Sensor::kPiston, "piston_m"}},
                          0, extension, effect.values.at("sharpness"));
  return {};
}

}  // namespace

const EffectInfo& SensorSaturationInfo() {
  static const EffectInfo info = {
      "sensor_saturation",
      "instrument",
      "cylinders",
      "shown = true (1 + (|true|/L)^n)^(-1/n), L: the end of an amplifier's range",
      {
          {"load_N", "N", 0, 0, 1e12, 2e4, 1e6, "L of the load cell; 0: no end"},
          {"p_bore_Pa", "Pa", 0, 0, 1e14, 2e6, 1e8, "L of the bore pressure"},
          {"p_rod_Pa", "Pa", 0, 0, 1e14, 2e6, 1e8, "L of the rod pressure"},
          {"piston_m", "m", 0, 0, 1e3, 1e-3, 0.1, "L of the piston"},
          {"sharpness", "-", 8, 0.5, 1000, 1.5, 60, "n: how suddenly the range ends"},
      },
      InstallSensorSaturation,
      {
          .rig =
              {
                  {.free = {{"load_N", 5e4, 2e5, 3}, {"sharpness", 6}}},
                  {.free = {{"p_bore_Pa", 5e6, 2e7, 3}, {"sharpness", 6}}},
                  {.free = {{"p_rod_Pa", 5e6, 2e7, 3}, {"sharpness", 6}}},
                  {.free = {{"piston_m", 2e-3, 8e-3, 3}, {"sharpness", 6}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
