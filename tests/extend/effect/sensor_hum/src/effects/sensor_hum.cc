#include "effects/sensor_hum.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

class Hum final : public hydraulics::ReadingLaw {
 public:
  Hum(double amplitude, double frequency_Hz) : amplitude_(amplitude), frequency_Hz_(frequency_Hz) {}
  double Error(const hydraulics::ForcePlace& place) const noexcept override {
    return amplitude_ * std::sin(2 * M_PI * frequency_Hz_ * place.time);
  }

 private:
  double amplitude_, frequency_Hz_;
};

Status Install(const EffectParams& effect, Extension* extension) {
  const double frequency = effect.values.at("frequency_Hz");
  for (int i : TargetCylinders(effect, extension->params())) {
    for (const auto& [sensor, key] : {std::pair{Sensor::kLoad, "load_N"},
                                      {Sensor::kBorePressure, "p_bore_Pa"},
                                      {Sensor::kRodPressure, "p_rod_Pa"}}) {
      const double amplitude = effect.values.at(key);
      if (amplitude == 0) continue;
      extension->AddReading(i, sensor, std::make_unique<Hum>(amplitude, frequency));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& SensorHumInfo() {
  static const EffectInfo info = {
      "sensor_hum",
      "instrument",
      "cylinders",
      "shown = true + A sin(2 pi f t)",
      {
          {"load_N", "N", 0, 0, 1e6, 0, 500, "A of the load cell"},
          {"p_bore_Pa", "Pa", 0, 0, 1e7, 0, 1e5, "A of the bore pressure"},
          {"p_rod_Pa", "Pa", 0, 0, 1e7, 0, 1e5, "A of the rod pressure"},
          {"frequency_Hz", "Hz", 50, 0.01, 1e4, 49, 61, "f"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
