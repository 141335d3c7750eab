#include "effects/sensor_offset.h"

#include <cmath>

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::ForcePlace;
using hydraulics::Sensor;

class Offset final : public hydraulics::ReadingLaw {
 public:
  explicit Offset(double offset) : offset_(offset) {}
  double Error(const ForcePlace&) const noexcept override { return offset_; }

 private:
  double offset_;
};

/// One that comes in the record.
class Jump final : public hydraulics::ReadingLaw {
 public:
  Jump(double offset, double start_s, double within_s)
      : offset_(offset), start_s_(start_s), within_s_(within_s) {}
  double Error(const ForcePlace& place) const noexcept override {
    const double since = place.time - start_s_;
    if (!(within_s_ > 0)) return since >= 0 ? offset_ : 0;
    return offset_ * 0.5 * (1 + std::tanh(2 * since / within_s_));
  }

 private:
  double offset_, start_s_, within_s_;
};

Status InstallSensorOffset(const EffectParams& effect, Extension* extension) {
  const std::initializer_list<SensorKey> keys = {{Sensor::kLoad, "load_N"},
                                                 {Sensor::kBorePressure, "p_bore_Pa"},
                                                 {Sensor::kRodPressure, "p_rod_Pa"},
                                                 {Sensor::kPiston, "piston_m"}};
  const double start = effect.values.at("start_s"), within = effect.values.at("within_s");
  start > 0 ? AddReadings<Jump>(effect, keys, 0, extension, start, within)
            : AddReadings<Offset>(effect, keys, 0, extension);
  return {};
}

}  // namespace

const EffectInfo& SensorOffsetInfo() {
  static const EffectInfo info = {
      "sensor_offset",
      "instrument",
      "cylinders",
      "shown = true + offset, from the first sample on or from t_s on",
      {
          {"load_N", "N", 0, -1e7, 1e7, -3000, 3000, "load cell"},
          {"p_bore_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "bore pressure"},
          {"p_rod_Pa", "Pa", 0, -1e8, 1e8, -5e5, 5e5, "rod pressure"},
          {"piston_m", "m", 0, -1, 1, -1e-3, 1e-3, "piston"},
          {"start_s", "s", 0, 0, 1e12, 0, 1e6, "t_s; 0: from the first sample on"},
          {"within_s", "s", 0, 0, 1e6, 0, 10, "w"},
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
                  {.free = {{"load_N", 0}, {"start_s", 10, 60, 5}}, .held = {{"within_s", 2}}},
                  {.free = {{"p_bore_Pa", 0}, {"start_s", 10, 60, 5}}, .held = {{"within_s", 2}}},
                  {.free = {{"p_rod_Pa", 0}, {"start_s", 10, 60, 5}}, .held = {{"within_s", 2}}},
              },
          .options =
              {
                  {.free = {{"p_bore_Pa", 0}}},
                  {.free = {{"p_rod_Pa", 0}}},
                  {.free = {{"load_N", 0}}},
                  {.free = {{"within_s", 0.3}}, .with = "start_s"},
              },
      }};
  return info;
}

}  // namespace phs::effects
