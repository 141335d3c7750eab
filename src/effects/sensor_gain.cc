#include "effects/sensor_gain.h"

#include <memory>

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

class Scale final : public hydraulics::ReadingLaw {
 public:
  explicit Scale(double gain, double below_zero = 1) : above_(gain), below_(gain * below_zero) {}
  double Scaled(double value) const noexcept override {
    return (value > 0 ? above_ : below_) * value;
  }

 private:
  double above_, below_;
};

Status InstallSensorGain(const EffectParams& effect, Extension* extension) {
  AddReadings<Scale>(effect,
                     {{Sensor::kBorePressure, "p_bore"},
                      {Sensor::kRodPressure, "p_rod"},
                      {Sensor::kPiston, "piston"}},
                     1, extension);
  const double load = effect.values.at("load"), ratio = effect.values.at("load_compression");
  if (load == 1 && ratio == 1) return {};
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddReading(i, Sensor::kLoad, std::make_unique<Scale>(load, ratio));
  }
  return {};
}

}  // namespace

const EffectInfo& SensorGainInfo() {
  static const EffectInfo info = {"sensor_gain",
                                  "instrument",
                                  "cylinders",
                                  "shown = gain true; of a load cell in compression gain times "
                                  "load_compression",
                                  {
                                      {"load", "-", 1, -100, 100, 0.4, 2.5, "load cell"},
                                      {"load_compression", "-", 1, 1e-3, 1e3, 0.4, 2.5,
                                       "gain of the load cell in compression over that in tension"},
                                      {"p_bore", "-", 1, -100, 100, 0.4, 2.5, "bore pressure"},
                                      {"p_rod", "-", 1, -100, 100, 0.4, 2.5, "rod pressure"},
                                      {"piston", "-", 1, -100, 100, 0.4, 2.5, "piston"},
                                  },
                                  InstallSensorGain,
                                  {
                                      .rig =
                                          {
                                              {.free = {{"load", 1}}},
                                              {.free = {{"load_compression", 1}}},
                                              {.free = {{"p_bore", 1}}},
                                              {.free = {{"p_rod", 1}}},
                                              {.free = {{"piston", 1}}},
                                              {.free = {{"p_bore", 1}, {"p_rod", 1}}},
                                          },
                                      .options =
                                          {
                                              {.free = {{"p_bore", 1}}},
                                              {.free = {{"p_rod", 1}}},
                                              {.free = {{"load_compression", 1}}, .with = "load"},
                                          },
                                  }};
  return info;
}

}  // namespace phs::effects
