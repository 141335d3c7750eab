#include "effects/sensor_gain.h"

#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

/// Beyond a pressure the gauge shows another share of what comes on top.
class ScaleBeyond final : public hydraulics::ReadingLaw {
 public:
  ScaleBeyond(double gain, double from) : gain_(gain), from_(from) {}
  double Scaled(double value) const noexcept override {
    return value > from_ ? from_ + gain_ * (value - from_) : value;
  }

 private:
  double gain_, from_;
};

class Scale final : public hydraulics::ReadingLaw {
 public:
  explicit Scale(double gain, double below_zero = 1, double zeroed_at = 0)
      : above_(gain), below_(gain * below_zero), zeroed_at_(zeroed_at) {}
  double Scaled(double value) const noexcept override {
    const double from = value - zeroed_at_;
    return zeroed_at_ + (from > 0 ? above_ : below_) * from;
  }

 private:
  double above_, below_, zeroed_at_;
};

Status InstallSensorGain(const EffectParams& effect, Extension* extension) {
  const auto value = [&effect](const char* key) { return effect.values.at(key); };
  const bool at_rest = value("zeroed_at_rest") != 0;
  const double from = value("from_Pa");
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto& cylinder = extension->params().cylinders[static_cast<size_t>(i)];
    const auto add = [&](Sensor sensor, double gain, double ratio = 1, double zeroed_at = 0) {
      if (gain == 1 && ratio == 1) return;
      extension->AddReading(i, sensor, std::make_unique<Scale>(gain, ratio, zeroed_at));
    };
    const auto add_pressure = [&](Sensor sensor, double gain, const std::string& line) {
      if (gain == 1 || from == 0) {
        return add(sensor, gain, 1, at_rest ? StaticPressure(line, *extension) : 0);
      }
      extension->AddReading(i, sensor, std::make_unique<ScaleBeyond>(gain, from));
    };
    add_pressure(Sensor::kBorePressure, value("p_bore"), cylinder.bore_line);
    add_pressure(Sensor::kRodPressure, value("p_rod"), cylinder.rod_line);
    add(Sensor::kPiston, value("piston"), value("piston_retraction"));
    add(Sensor::kLoad, value("load"), value("load_compression"));
  }
  return {};
}

}  // namespace

const EffectInfo& SensorGainInfo() {
  static const EffectInfo info = {
      "sensor_gain",
      "instrument",
      "cylinders",
      "shown = gain true, of pressures as told about the static one; of "
      "a load cell in compression gain times load_compression, of a piston likewise",
      {
          {"load", "-", 1, -100, 100, 0.4, 2.5, "load cell"},
          {"load_compression", "-", 1, 1e-3, 1e3, 0.4, 2.5,
           "gain of the load cell in compression over that in tension"},
          {"p_bore", "-", 1, -100, 100, 0.4, 2.5, "bore pressure"},
          {"p_rod", "-", 1, -100, 100, 0.4, 2.5, "rod pressure"},
          {"piston", "-", 1, -100, 100, 0.4, 2.5, "piston"},
          {"piston_retraction", "-", 1, 1e-3, 1e3, 0.4, 2.5,
           "gain of the piston's sensor in retraction over that in extension"},
          {"zeroed_at_rest", "-", 0, 0, 1, 0, 1, "1: pressures were set right at the static ones"},
          {"from_Pa", "Pa", 0, 0, 1e9, 0, 2e7, "pressures are right up to it; 0: nowhere"},
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
                  {.free = {{"piston_retraction", 1}}},
                  {.free = {{"p_bore", 1}, {"p_rod", 1}}},
                  {.free = {{"p_bore", 1}}, .held = {{"zeroed_at_rest", 1}}},
                  {.free = {{"p_rod", 1}}, .held = {{"zeroed_at_rest", 1}}},
                  {.free = {{"p_bore", 1}, {"from_Pa", 2e6, 8e6, 3}}},
                  {.free = {{"p_rod", 1}, {"from_Pa", 2e6, 8e6, 3}}},
              },
          .options =
              {
                  // Beside free gas and oil two gauges that err from a pressure on stand for a bumper.
                  {.free = {{"p_bore", 1}}, .without = "from_Pa"},
                  {.free = {{"p_rod", 1}}, .without = "from_Pa"},
                  {.free = {{"load_compression", 1}}, .with = "load"},
                  {.free = {{"piston_retraction", 1}}, .with = "piston"},
              },
          .over = {"Pa", "pq", true},
      }};
  return info;
}

}  // namespace phs::effects
