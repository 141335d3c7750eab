#include "effects/sensor_hysteresis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

class Loop final : public hydraulics::ReadingLaw {
 public:
  Loop(double share, double width, double seeps_s)
      : share_(share), width_(width), seeps_s_(seeps_s) {}
  void Lag(double step, std::vector<double>* values) const override {
    constexpr int kElements = 6;
    std::array<double, kElements> held{};
    const double keeps = seeps_s_ > 0 ? std::exp(-step / seeps_s_) : 1;
    double before = values->empty() ? 0 : values->front();
    for (double& shown : *values) {
      const double way = shown - before;
      before = shown;
      double mean = 0;
      for (int k = 0; k < kElements; ++k) {
        const double slips = width_ * (k + 1) / kElements;
        double& z = held[static_cast<size_t>(k)];
        z = std::clamp(keeps * z + way, -slips, slips);
        mean += z / kElements;
      }
      shown -= share_ * mean;
    }
  }

 private:
  double share_, width_, seeps_s_;
};

Status InstallSensorHysteresis(const EffectParams& effect, Extension* extension) {
  const auto value = [&effect](const char* key) { return effect.values.at(key); };
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto add = [&](Sensor sensor, double share, double width) {
      if (share == 0) return;
      extension->AddReading(i, sensor, std::make_unique<Loop>(share, width, value("seeps_s")));
    };
    add(Sensor::kLoad, value("load"), value("width_N"));
    add(Sensor::kBorePressure, value("p_bore"), value("width_Pa"));
    add(Sensor::kRodPressure, value("p_rod"), value("width_Pa"));
  }
  return {};
}

}  // namespace

const EffectInfo& SensorHysteresisInfo() {
  static const EffectInfo info = {
      "sensor_hysteresis",
      "instrument",
      "cylinders",
      "shown = true - a z, z follows the true one until its elements slip, the last at W",
      {
          {"load", "-", 0, -1, 1, 0, 0.3, "a of the load cell"},
          {"p_bore", "-", 0, -1, 1, 0, 1, "a of the bore pressure"},
          {"p_rod", "-", 0, -1, 1, 0, 1, "a of the rod pressure"},
          {"width_N", "N", 1e4, 1, 1e8, 500, 1e5, "W of the load cell"},
          {"width_Pa", "Pa", 1e5, 1, 1e9, 5e3, 5e6, "W of the pressures"},
          {"seeps_s", "s", 0, 0, 1e6, 0, 100, "T: of what is held; 0: it is held for ever"},
      },
      InstallSensorHysteresis,
      {
          .rig =
              {
                  {.free = {{"load", 0.01}, {"width_N", 3e3, 3e4, 2}}},
                  {.free = {{"p_bore", 0.03}, {"width_Pa", 3e5, 3e6, 2}}},
                  {.free = {{"p_rod", 0.03}, {"width_Pa", 3e5, 3e6, 2}}},
                  {.free = {{"width_Pa", 3e4, 3e5, 2}}, .held = {{"p_bore", 1}}},
                  {.free = {{"width_Pa", 3e4, 3e5, 2}}, .held = {{"p_rod", 1}}},
              },
          .options =
              {
                  {.free = {{"seeps_s", 1, 10, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
