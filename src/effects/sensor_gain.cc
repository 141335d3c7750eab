#include "effects/sensor_gain.h"

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

class Scale final : public hydraulics::ReadingLaw {
 public:
  explicit Scale(double gain) : gain_(gain) {}
  double Gain() const noexcept override { return gain_; }

 private:
  double gain_;
};

Status Install(const EffectParams& effect, Extension* extension) {
  AddReadings<Scale>(effect,
                     {{Sensor::kLoad, "load"},
                      {Sensor::kBorePressure, "p_bore"},
                      {Sensor::kRodPressure, "p_rod"},
                      {Sensor::kPiston, "piston"}},
                     1, extension);
  return {};
}

}  // namespace

const EffectInfo& SensorGainInfo() {
  static const EffectInfo info = {"sensor_gain",
                                  "instrument",
                                  "cylinders",
                                  "shown = gain true",
                                  {
                                      {"load", "-", 1, -100, 100, 0.4, 2.5, "load cell"},
                                      {"p_bore", "-", 1, -100, 100, 0.4, 2.5, "bore pressure"},
                                      {"p_rod", "-", 1, -100, 100, 0.4, 2.5, "rod pressure"},
                                      {"piston", "-", 1, -100, 100, 0.4, 2.5, "piston"},
                                  },
                                  Install,
                                  {
                                      .rig =
                                          {
                                              {.free = {{"load", 1}}},
                                              {.free = {{"p_bore", 1}}},
                                              {.free = {{"p_rod", 1}}},
                                              {.free = {{"piston", 1}}},
                                              {.free = {{"p_bore", 1}, {"p_rod", 1}}},
                                          },
                                      .options =
                                          {
                                              {.free = {{"p_bore", 1}}},
                                              {.free = {{"p_rod", 1}}},
                                          },
                                  }};
  return info;
}

}  // namespace phs::effects
