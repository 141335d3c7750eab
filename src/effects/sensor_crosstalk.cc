#include "effects/sensor_crosstalk.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::ForcePlace;
using hydraulics::Sensor;

class Crosstalk final : public hydraulics::ReadingLaw {
 public:
  using From = double ForcePlace::*;
  Crosstalk(From from, double share, double time_s) : from_(from), share_(share), time_(time_s) {}
  double Error(const ForcePlace& place) const noexcept override { return share_ * place.*from_; }
  /// `behind`: u - z. Between samples u is straight.
  double ErrorAfter(const ForcePlace& before, const ForcePlace& place, double step_s,
                    double* behind) const noexcept override {
    if (time_ == 0) return Error(place);
    const double rise = (place.*from_ - before.*from_) * time_ / step_s;
    *behind = rise + (*behind - rise) * std::exp(-step_s / time_);
    return share_ * *behind;
  }

 private:
  From from_;
  double share_, time_;
};

Status InstallSensorCrosstalk(const EffectParams& effect, Extension* extension) {
  struct Way {
    const char* key;
    Sensor into;
    Crosstalk::From from;
  };
  constexpr Way kWays[] = {{"p_bore_of_p_rod", Sensor::kBorePressure, &ForcePlace::rod_rise},
                           {"p_rod_of_p_bore", Sensor::kRodPressure, &ForcePlace::bore_rise},
                           {"p_bore_Pa_per_N", Sensor::kBorePressure, &ForcePlace::force},
                           {"p_rod_Pa_per_N", Sensor::kRodPressure, &ForcePlace::force}};
  for (int i : TargetCylinders(effect, extension->params())) {
    for (const Way& way : kWays) {
      const double share = effect.values.at(way.key);
      if (share == 0) continue;
      extension->AddReading(
          i, way.into, std::make_unique<Crosstalk>(way.from, share, effect.values.at("time_s")));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& SensorCrosstalkInfo() {
  static const EffectInfo info = {
      "sensor_crosstalk",
      "instrument",
      "cylinders",
      "shown = true + a u, u of another channel; with a time T only what is quicker than T",
      {
          {"p_bore_of_p_rod", "-", 0, -10, 10, -0.5, 0.5, "bore gauge, of the rod pressure's rise"},
          {"p_rod_of_p_bore", "-", 0, -10, 10, -0.5, 0.5, "rod gauge, of the bore pressure's rise"},
          {"p_bore_Pa_per_N", "Pa/N", 0, -1e4, 1e4, -30, 30,
           "bore gauge, of the load cell's force"},
          {"p_rod_Pa_per_N", "Pa/N", 0, -1e4, 1e4, -30, 30, "rod gauge, of the load cell's force"},
          {"time_s", "s", 0, 0, 1e6, 0.01, 100, "T; 0: a copy, however slow"},
      },
      InstallSensorCrosstalk,
      {
          .rig =
              {
                  {.free = {{"p_bore_of_p_rod", 0.01}}},
                  {.free = {{"p_rod_of_p_bore", 0.01}}},
                  {.free = {{"p_bore_Pa_per_N", 1}}},
                  {.free = {{"p_rod_Pa_per_N", 1}}},
                  {.free = {{"p_bore_of_p_rod", 0.01}, {"time_s", 0.1, 3, 2}}},
                  {.free = {{"p_rod_of_p_bore", 0.01}, {"time_s", 0.1, 3, 2}}},
                  {.free = {{"p_bore_Pa_per_N", 1}, {"time_s", 0.1, 3, 2}}},
                  {.free = {{"p_rod_Pa_per_N", 1}, {"time_s", 0.1, 3, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
