#include "effects/sensor_delay.h"

#include <cmath>
#include <memory>
#include <utility>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;
using hydraulics::Walk;

class Delay final : public hydraulics::ReadingLaw {
 public:
  explicit Delay(double delay_s) : delay_s_(delay_s) {}
  // Between samples linear; before the first sample the first value holds.
  void Lag(double step, std::vector<double>* values) const override {
    std::vector<double>& y = *values;
    const double shift = delay_s_ / step;
    for (size_t i = y.size(); i-- > 0;) {
      const double at = static_cast<double>(i) - shift;
      if (at <= 0) {
        y[i] = y[0];
        continue;
      }
      const size_t k = static_cast<size_t>(at);
      const double part = at - static_cast<double>(k);
      y[i] = part > 0 ? y[k] + part * (y[k + 1] - y[k]) : y[k];
    }
  }

 private:
  double delay_s_;
};

/// Lags of first order one behind the other, exact where the signal is straight between samples. Of a
/// broken number of them the mean of both filters about it.
class Filter final : public hydraulics::ReadingLaw {
 public:
  Filter(double delay_s, double poles) : delay_s_(delay_s), poles_(std::max(poles, 1.0)) {}
  void Lag(double step, std::vector<double>* values) const override {
    const double fewer = std::floor(poles_), part = poles_ - fewer;
    std::vector<double> more = *values;
    Lag(step, fewer, values);
    if (part == 0) return;
    Lag(step, fewer + 1, &more);
    for (size_t i = 0; i < more.size(); ++i) (*values)[i] += part * (more[i] - (*values)[i]);
  }

 private:
  void Lag(double step, double poles, std::vector<double>* values) const {
    // y' = (u - y)/T over a step: y = u - T u' + (y_0 - u_0 + T u') exp(-step/T).
    const double time = delay_s_ / poles, fade = std::exp(-step / time);
    for (int pole = 0; pole < poles; ++pole) {
      double before = values->empty() ? 0 : values->front(), shown = before;
      for (double& u : *values) {
        const double behind = time * (u - before) / step;
        shown = u - behind + (shown - before + behind) * fade;
        before = u, u = shown;
      }
    }
  }
  double delay_s_, poles_;
};

Status InstallSensorDelay(const EffectParams& effect, Extension* extension) {
  const double poles = effect.values.at("poles");
  for (const int i : TargetCylinders(effect, extension->params())) {
    for (const auto& [sensor, key] : {std::pair(Sensor::kLoad, "load_s"),
                                      {Sensor::kBorePressure, "p_bore_s"},
                                      {Sensor::kRodPressure, "p_rod_s"},
                                      {Sensor::kPiston, "piston_s"}}) {
      const double delay = effect.values.at(key);
      if (delay == 0) continue;
      if (poles == 0) {
        extension->AddReading(i, sensor, std::make_unique<Delay>(delay));
      } else {
        extension->AddReading(i, sensor, std::make_unique<Filter>(delay, poles));
      }
    }
  }
  return {};
}

}  // namespace

const EffectInfo& SensorDelayInfo() {
  static const EffectInfo info = {
      "sensor_delay",
      "instrument",
      "cylinders",
      "shown(t) = true(t - delay), or as a filter with that delay of slow signals",
      {
          {"load_s", "s", 0, 0, 100, 0, 0.2, "load cell"},
          {"p_bore_s", "s", 0, 0, 100, 0, 0.2, "bore pressure"},
          {"p_rod_s", "s", 0, 0, 100, 0, 0.2, "rod pressure"},
          {"piston_s", "s", 0, 0, 100, 0, 0.2, "piston"},
          {"poles", "-", 0, 0, 20, 0.8, 10,
           "of the filter, all alike, 1 at least; 0: a pure delay"},
      },
      InstallSensorDelay,
      {
          .rig =
              {
                  {.free = {{"load_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_bore_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_rod_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_bore_s", 2e-3, 0.02, 2},
                            {"p_rod_s", 2e-3, 0.02, 2, Walk::kInStep}}},
                  {.free = {{"piston_s", 2e-3, 0.02, 2}}},
              },
          .bench =
              {
                  {.free = {{"load_s", 1e-3, 0.01, 2, Walk::kEach, 0, 0.2, true}}},
              },
          .options =
              {
                  {.free = {{"poles", 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
