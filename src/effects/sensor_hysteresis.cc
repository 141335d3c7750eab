#include "effects/sensor_hysteresis.h"

#include <algorithm>
#include <array>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

class Loop final : public hydraulics::ReadingLaw {
 public:
  Loop(double share, double width_N) : share_(share), width_N_(width_N) {}
  void Lag(double /*step*/, std::vector<double>* values) const override {
    constexpr int kElements = 6;
    std::array<double, kElements> held{};
    double before = values->empty() ? 0 : values->front();
    for (double& shown : *values) {
      const double way = shown - before;
      before = shown;
      double mean = 0;
      for (int k = 0; k < kElements; ++k) {
        const double slips = width_N_ * (k + 1) / kElements;
        double& z = held[static_cast<size_t>(k)];
        z = std::clamp(z + way, -slips, slips);
        mean += z / kElements;
      }
      shown -= share_ * mean;
    }
  }

 private:
  double share_, width_N_;
};

Status InstallSensorHysteresis(const EffectParams& effect, Extension* extension) {
  const double share = effect.values.at("load");
  if (share == 0) return {};
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddReading(i, hydraulics::Sensor::kLoad,
                          std::make_unique<Loop>(share, effect.values.at("width_N")));
  }
  return {};
}

}  // namespace

const EffectInfo& SensorHysteresisInfo() {
  static const EffectInfo info = {
      "sensor_hysteresis",
      "instrument",
      "cylinders",
      "shown = true - a z, z follows the force until its elements slip, the last at W",
      {
          {"load", "-", 0, -1, 1, 0, 0.3, "a"},
          {"width_N", "N", 1e4, 1, 1e8, 500, 1e5, "W"},
      },
      InstallSensorHysteresis,
      {
          .rig =
              {
                  {.free = {{"load", 0.01}, {"width_N", 3e3, 3e4, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
