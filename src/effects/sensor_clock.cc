#include "effects/sensor_clock.h"

#include <algorithm>
#include <vector>

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;
using hydraulics::Walk;

class Clock final : public hydraulics::ReadingLaw {
 public:
  explicit Clock(double fast) : fast_(fast) {}
  // Between samples linear; beyond the last one its value holds.
  void Lag(double /*step*/, std::vector<double>* values) const override {
    const std::vector<double> y = *values;
    if (y.size() < 2) return;
    const double last = static_cast<double>(y.size() - 1);
    for (size_t i = 0; i < y.size(); ++i) {
      const double at = std::clamp(static_cast<double>(i) * (1 - fast_), 0.0, last);
      const size_t k = std::min(static_cast<size_t>(at), y.size() - 2);
      (*values)[i] = y[k] + (at - static_cast<double>(k)) * (y[k + 1] - y[k]);
    }
  }

 private:
  double fast_;
};

Status InstallSensorClock(const EffectParams& effect, Extension* extension) {
  const double all = effect.values.at("all");
  for (int i : TargetCylinders(effect, extension->params())) {
    for (const SensorKey& key : {SensorKey{Sensor::kLoad, "load"},
                                 {Sensor::kBorePressure, "p_bore"},
                                 {Sensor::kRodPressure, "p_rod"},
                                 {Sensor::kPiston, "piston"}}) {
      const double fast = all + effect.values.at(key.key);
      if (fast != 0) extension->AddReading(i, key.sensor, std::make_unique<Clock>(fast));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& SensorClockInfo() {
  static const EffectInfo info = {
      "sensor_clock",
      "instrument",
      "cylinders",
      "shown(t) = true(t - r (t - first sample)): a card whose clock runs too fast by r",
      {
          {"all", "-", 0, -0.1, 0.1, -1e-3, 1e-3, "r of every channel against the actuator's"},
          {"load", "-", 0, -0.1, 0.1, -1e-3, 1e-3, "r of the load cell beyond it"},
          {"p_bore", "-", 0, -0.1, 0.1, -1e-3, 1e-3, "r of the bore pressure beyond it"},
          {"p_rod", "-", 0, -0.1, 0.1, -1e-3, 1e-3, "r of the rod pressure beyond it"},
          {"piston", "-", 0, -0.1, 0.1, -1e-3, 1e-3, "r of the piston beyond it"},
      },
      InstallSensorClock,
      {
          .rig =
              {
                  {.free = {{"all", 0}}},
                  {.free = {{"load", 0}}},
                  {.free = {{"p_bore", 0}}},
                  {.free = {{"p_rod", 0}}},
                  {.free = {{"piston", 0}}},
                  {.free = {{"p_bore", 0}, {"p_rod", 0, 0, 1, Walk::kInStep}}, .amounts = 2},
              },
      }};
  return info;
}

}  // namespace phs::effects
