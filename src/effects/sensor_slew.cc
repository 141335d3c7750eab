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

/// Little by little into its limit: e = true - shown goes by e' = u' - R tanh(e/(R tau)). Exponential
/// steps (Rosenbrock and Euler's: Hochbruck and Ostermann, Acta Numerica 19 (2010) 209), exact for
/// small signals and for far too fast ones, u straight between samples; none goes past the e at which
/// u is followed.
class SoftSlew final : public hydraulics::ReadingLaw {
 public:
  SoftSlew(double rate, double time) : rate_(rate), time_(time) {}
  void Lag(double step, std::vector<double>* values) const override {
    constexpr int kParts = 4;
    double before = values->empty() ? 0 : values->front(), behind = 0;
    for (double& u : *values) {
      const double rise = (u - before) / step;
      for (int k = 0; k < kParts; ++k) behind = After(step / kParts, rise, behind);
      before = u, u -= behind;
    }
  }

 private:
  double After(double h, double rise, double behind) const {
    const double follows = std::tanh(behind / (rate_ * time_));
    const double along = h * (1 - follows * follows) / time_, gains = rise - rate_ * follows;
    const double next = behind + gains * h * (along > 1e-8 ? -std::expm1(-along) / along : 1);
    if (std::abs(rise) >= rate_) return next;
    const double followed = rate_ * time_ * std::atanh(rise / rate_);
    return gains > 0 ? std::min(next, followed) : std::max(next, followed);
  }
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
