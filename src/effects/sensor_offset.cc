#include "effects/sensor_offset.h"

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

class Offset final : public hydraulics::ReadingLaw {
 public:
  explicit Offset(double offset) : offset_(offset) {}
  double Error(const hydraulics::ForcePlace&) const noexcept override { return offset_; }

 private:
  double offset_;
};

Status InstallSensorOffset(const EffectParams& effect, Extension* extension) {
  AddReadings<Offset>(effect,
                      {{Sensor::kLoad, "load_N"},
                       {Sensor::kBorePressure, "p_bore_Pa"},
                       {Sensor::kRodPressure, "p_rod_Pa"},
                       {Sensor::kPiston, "piston_m"}},
                      0, extension);
  return {};
}

}  // namespace

const EffectInfo& SensorOffsetInfo() {
  static const EffectInfo info = {"sensor_offset",
                                  "instrument",
                                  "cylinders",
                                  "shown = true + offset",
                                  {
                                      {"load_N", "N", 0, -1e7, 1e7, -3000, 3000, "load cell"},
                                      {"p_bore_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "bore pressure"},
                                      {"p_rod_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "rod pressure"},
                                      {"piston_m", "m", 0, -1, 1, -1e-3, 1e-3, "piston"},
                                  },
                                  InstallSensorOffset,
                                  {
                                      .rig =
                                          {
                                              {.free = {{"load_N", 0}}},
                                              {.free = {{"p_bore_Pa", 0}}},
                                              {.free = {{"p_rod_Pa", 0}}},
                                              {.free = {{"piston_m", 0}}},
                                              {.free = {{"p_bore_Pa", 0}, {"p_rod_Pa", 0}}},
                                          },
                                      .options =
                                          {
                                              {.free = {{"p_bore_Pa", 0}}},
                                              {.free = {{"p_rod_Pa", 0}}},
                                              {.free = {{"load_N", 0}}},
                                          },
                                  }};
  return info;
}

}  // namespace phs::effects
