#include "effects/sensor_creep.h"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "effects/readings.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;
using hydraulics::Walk;

class Creep final : public hydraulics::ReadingLaw {
 public:
  Creep(double share, const EffectParams& effect)
      : prompt_(effect.values.at("settled") != 0 ? share : 0) {
    const double slow = effect.values.at("slow_part"), d = effect.values.at("spread");
    const double time = effect.values.at("time_s"), quick = share * (1 - slow);
    if (d == 1) {
      parts_.push_back({quick, time});
    } else {
      for (const double own : {time / d, time, time * d}) parts_.push_back({quick / 3, own});
    }
    if (slow != 0) parts_.push_back({share * slow, effect.values.at("slow_time_s")});
  }
  void Lag(double step, std::vector<double>* values) const override {
    if (values->empty()) return;
    std::vector<double> shown = *values;
    const double rest = values->front();
    for (double& y : shown) y -= prompt_ * (y - rest);
    for (const Part& part : parts_) AddPart(part, step, *values, &shown);
    *values = std::move(shown);
  }

 private:
  struct Part {
    double share, time_s;
  };

  /// tau dz/dt = u - z, exact for a signal that is straight between samples.
  static void AddPart(const Part& part, double step, const std::vector<double>& true_ones,
                      std::vector<double>* shown) {
    const double keeps = std::exp(-step / part.time_s);
    const double mean = -std::expm1(-step / part.time_s) * part.time_s / step;
    const double rest = true_ones.front();
    double before = 0, z = 0;
    for (size_t i = 0; i < true_ones.size(); ++i) {
      const double now = true_ones[i] - rest;
      z = keeps * z + (mean - keeps) * before + (1 - mean) * now;
      (*shown)[i] += part.share * z;
      before = now;
    }
  }

  double prompt_;
  std::vector<Part> parts_;
};

Status InstallSensorCreep(const EffectParams& effect, Extension* extension) {
  AddReadings<Creep>(
      effect,
      {{Sensor::kLoad, "load"}, {Sensor::kBorePressure, "p_bore"}, {Sensor::kRodPressure, "p_rod"}},
      0, extension, std::cref(effect));
  return {};
}

}  // namespace

// One that is right in the end shows a gain if it takes longer than a motion lasts: sought up to
// 10 s.
const EffectInfo& SensorCreepInfo() {
  static const EffectInfo info = {
      "sensor_creep",
      "instrument",
      "cylinders",
      "shown = true + a z, tau dz/dt = u - z, u = true - at first; settled: true - a (u - z)",
      {
          {"load", "-", 0, -1, 1, -0.3, 0.3, "a of the load cell"},
          {"p_bore", "-", 0, -1, 1, -0.3, 0.3, "a of the bore pressure"},
          {"p_rod", "-", 0, -1, 1, -0.3, 0.3, "a of the rod pressure"},
          {"time_s", "s", 1, 1e-3, 1e6, 0.1, 100, "tau"},
          {"spread", "-", 1, 1, 100, 1, 30, "d: a third of the quick part each, tau/d, tau, tau d"},
          {"slow_part", "-", 0, 0, 1, 0, 1, "b: of a, with the time of its own"},
          {"slow_time_s", "s", 10, 1e-3, 1e6, 1, 300, "tau of the slow part"},
          {"settled", "-", 0, 0, 1, 0, 1, "1: right once all has come; 0: right at first"},
      },
      InstallSensorCreep,
      {
          .rig =
              {
                  {.free = {{"load", 0}, {"time_s", 0.4, 5, 2}}},
                  {.free = {{"p_bore", 0}, {"time_s", 0.4, 5, 2}}},
                  {.free = {{"p_rod", 0}, {"time_s", 0.4, 5, 2}}},
                  {.free = {{"load", 0}, {"time_s", 0.4, 5, 2, Walk::kEach, 0.1, 10}},
                   .held = {{"settled", 1}}},
                  {.free = {{"p_bore", 0}, {"time_s", 0.4, 5, 2, Walk::kEach, 0.1, 10}},
                   .held = {{"settled", 1}}},
                  {.free = {{"p_rod", 0}, {"time_s", 0.4, 5, 2, Walk::kEach, 0.1, 10}},
                   .held = {{"settled", 1}}},
              },
          .options =
              {
                  {.free = {{"spread", 5}}},
                  {.free = {{"slow_part", 0.5}, {"slow_time_s", 4, 20, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
