#include "effects/sensor_slew.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
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

/// Little by little into its limit. Runge and Kutta's fourth order where u is straight between
/// samples, in steps of at most half of tau; with a tau that no sample sees, at once.
class SoftSlew final : public hydraulics::ReadingLaw {
 public:
  SoftSlew(double rate, double time) : rate_(rate), time_(time) {}
  void Lag(double step, std::vector<double>* values) const override {
    constexpr double kMostSteps = 100;
    const double parts = std::max(std::ceil(2 * step / time_), 1.0);
    if (parts > kMostSteps) return Slew(rate_).Lag(step, values);
    const double h = step / parts;
    double before = values->empty() ? 0 : values->front(), behind = 0;  // true less shown
    for (double& u : *values) {
      const double rise = (u - before) / step;
      for (int k = 0; k < parts; ++k) {
        const double k1 = rise - Rate(behind), k2 = rise - Rate(behind + 0.5 * h * k1);
        const double k3 = rise - Rate(behind + 0.5 * h * k2), k4 = rise - Rate(behind + h * k3);
        behind += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      }
      before = u, u -= behind;
    }
  }

 private:
  double Rate(double behind) const { return rate_ * std::tanh(behind / (rate_ * time_)); }
  double rate_, time_;
};

Status InstallSensorSlew(const EffectParams& effect, Extension* extension) {
  const std::initializer_list<SensorKey> keys = {{Sensor::kLoad, "load_N_per_s"},
                                                 {Sensor::kBorePressure, "p_bore_Pa_per_s"},
                                                 {Sensor::kRodPressure, "p_rod_Pa_per_s"}};
  if (const double time = effect.values.at("time_s"); time > 0) {
    AddReadings<SoftSlew>(effect, keys, 0, extension, time);
  } else {
    AddReadings<Slew>(effect, keys, 0, extension);
  }
  return {};
}

}  // namespace

const EffectInfo& SensorSlewInfo() {
  static const EffectInfo info = {
      "sensor_slew",
      "instrument",
      "cylinders",
      "shown follows the true one no faster than a rate R, at once or with a lag of small signals",
      {
          {"load_N_per_s", "N/s", 0, 0, 1e12, 1e4, 1e7, "R of the load cell; 0: no limit"},
          {"p_bore_Pa_per_s", "Pa/s", 0, 0, 1e14, 1e5, 1e9, "R of the bore pressure"},
          {"p_rod_Pa_per_s", "Pa/s", 0, 0, 1e14, 1e5, 1e9, "R of the rod pressure"},
          {"time_s", "s", 0, 0, 100, 1e-4, 0.1, "tau: lag of small signals; 0: none"},
      },
      InstallSensorSlew,
      {
          .rig =
              {
                  {.free = {{"load_N_per_s", 3e4, 1e6, 4}}},
                  {.free = {{"p_bore_Pa_per_s", 3e6, 1e8, 4}}},
                  {.free = {{"p_rod_Pa_per_s", 3e6, 1e8, 4}}},
                  {.free = {{"load_N_per_s", 1e5, 1e6, 2}, {"time_s", 2e-3, 1e-2, 2}}},
                  {.free = {{"p_bore_Pa_per_s", 1e7, 1e8, 2}, {"time_s", 2e-3, 1e-2, 2}}},
                  {.free = {{"p_rod_Pa_per_s", 1e7, 1e8, 2}, {"time_s", 2e-3, 1e-2, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
