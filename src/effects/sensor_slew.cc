#include "effects/sensor_slew.h"

#include <algorithm>
#include <vector>

#include "effects/readings.h"

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
  AddReadings<Slew>(effect,
                    {{Sensor::kLoad, "load_N_per_s"},
                     {Sensor::kBorePressure, "p_bore_Pa_per_s"},
                     {Sensor::kRodPressure, "p_rod_Pa_per_s"}},
                    0, extension);
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
