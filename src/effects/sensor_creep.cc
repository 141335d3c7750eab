#include "effects/sensor_creep.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

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
      : quick_(share * (1 - effect.values.at("slow_part"))),
        slow_(share * effect.values.at("slow_part")),
        time_s_(effect.values.at("time_s")),
        slow_time_s_(effect.values.at("slow_time_s")),
        prompt_(effect.values.at("settled") != 0 ? share : 0) {}
  // Exact for a signal that is straight between samples.
  void Lag(double step, std::vector<double>* values) const override {
    std::vector<double>& y = *values;
    if (y.empty()) return;
    const Follower quick(step, time_s_), slow(step, slow_time_s_);
    const double rest = y.front();
    double before = 0, behind_quick = 0, behind_slow = 0;
    for (double& shown : y) {
      const double now = shown - rest;
      behind_quick = quick.After(behind_quick, before, now);
      behind_slow = slow.After(behind_slow, before, now);
      shown += quick_ * behind_quick + slow_ * behind_slow - prompt_ * now;
      before = now;
    }
  }

 private:
  /// tau dz/dt = u - z over one step.
  struct Follower {
    Follower(double step, double time)
        : keeps(std::exp(-step / time)), mean(-std::expm1(-step / time) * time / step) {}
    double After(double z, double before, double now) const {
      return keeps * z + (mean - keeps) * before + (1 - mean) * now;
    }
    double keeps, mean;
  };

  double quick_, slow_, time_s_, slow_time_s_, prompt_;
};

Status InstallSensorCreep(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto add = [&](Sensor sensor, const char* key) {
      const double share = effect.values.at(key);
      if (share != 0) extension->AddReading(i, sensor, std::make_unique<Creep>(share, effect));
    };
    add(Sensor::kLoad, "load");
    add(Sensor::kBorePressure, "p_bore");
    add(Sensor::kRodPressure, "p_rod");
  }
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
                  {.free = {{"slow_part", 0.5}, {"slow_time_s", 4, 20, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
