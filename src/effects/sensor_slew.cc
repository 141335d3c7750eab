#include "effects/sensor_slew.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;

class Slew final : public hydraulics::ReadingLaw {
 public:
  explicit Slew(double rate) : rate_(rate) {}
  // Exact where the true signal is at most as fast as R or always faster within a step.
  void Lag(double step, std::vector<double>* values) const override {
    const double most = rate_ * step;
    std::vector<double>& y = *values;
    for (size_t i = 1; i < y.size(); ++i) y[i] = std::clamp(y[i], y[i - 1] - most, y[i - 1] + most);
  }

 private:
  double rate_;
};

Status InstallSensorSlew(const EffectParams& effect, Extension* extension) {
  for (const int i : TargetCylinders(effect, extension->params())) {
    const auto add = [&](Sensor sensor, const char* key) {
      const double rate = effect.values.at(key);
      if (rate > 0) extension->AddReading(i, sensor, std::make_unique<Slew>(rate));
    };
    add(Sensor::kLoad, "load_N_per_s");
    add(Sensor::kBorePressure, "p_bore_Pa_per_s");
    add(Sensor::kRodPressure, "p_rod_Pa_per_s");
  }
  return {};
}

}  // namespace

const EffectInfo& SensorSlewInfo() {
  static const EffectInfo info = {
      "sensor_slew",
      "instrument",
      "cylinders",
      "shown follows the true one no faster than a rate R",
      {
          {"load_N_per_s", "N/s", 0, 0, 1e12, 1e4, 1e7, "R of the load cell; 0: no limit"},
          {"p_bore_Pa_per_s", "Pa/s", 0, 0, 1e14, 1e5, 1e9, "R of the bore pressure"},
          {"p_rod_Pa_per_s", "Pa/s", 0, 0, 1e14, 1e5, 1e9, "R of the rod pressure"},
      },
      InstallSensorSlew,
      {
          .rig =
              {
                  {.free = {{"load_N_per_s", 3e4, 1e6, 4}}},
                  {.free = {{"p_bore_Pa_per_s", 3e6, 1e8, 4}}},
                  {.free = {{"p_rod_Pa_per_s", 3e6, 1e8, 4}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
