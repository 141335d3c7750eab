#include "effects/sensor_supply.h"

#include <algorithm>
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

/// What the rig draws lowers the supply by a share.
struct Sag {
  double of_speed = 0;  ///< [s/m]
  double of_power = 0;  ///< [1/W]
  double time_s = 0;
  double At(const ForcePlace& place) const {
    return of_speed * std::abs(place.speed) + of_power * std::max(place.force * place.speed, 0.0);
  }
};

class SaggingReading final : public hydraulics::ReadingLaw {
 public:
  SaggingReading(const Sag& sag, Sensor sensor, double rest)
      : sag_(sag), sensor_(sensor), rest_(rest) {}
  double Error(const ForcePlace& place) const noexcept override {
    return -sag_.At(place) * True(place);
  }
  /// `behind`: y - y'. Between samples y is straight.
  double ErrorAfter(const ForcePlace& before, const ForcePlace& place, double step_s,
                    double* behind) const noexcept override {
    if (sag_.time_s == 0) return Error(place);
    const double now = sag_.At(place), rise = (now - sag_.At(before)) * sag_.time_s / step_s;
    *behind = rise + (*behind - rise) * std::exp(-step_s / sag_.time_s);
    return -(now - *behind) * True(place);
  }

 private:
  double True(const ForcePlace& place) const {
    if (sensor_ == Sensor::kLoad) return place.force;
    return rest_ + (sensor_ == Sensor::kBorePressure ? place.bore_rise : place.rod_rise);
  }
  Sag sag_;
  Sensor sensor_;
  double rest_;  ///< pressure in the static state, absolute [Pa]
};

Status InstallSensorSupply(const EffectParams& effect, Extension* extension) {
  constexpr double kSpeed = 0.01, kPower = 1e3;  // m/s, W: what the shares are stated at
  const auto value = [&effect](const char* key) { return effect.values.at(key); };
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto& c = extension->params().cylinders[static_cast<size_t>(i)];
    const auto add = [&](Sensor sensor, double part, double rest) {
      const Sag sag{part * value("of_speed") / kSpeed, part * value("of_power") / kPower,
                    value("time_s")};
      if (sag.of_speed == 0 && sag.of_power == 0) return;
      extension->AddReading(i, sensor, std::make_unique<SaggingReading>(sag, sensor, rest));
    };
    add(Sensor::kLoad, value("load"), 0);
    add(Sensor::kBorePressure, value("p_bore"), StaticPressure(c.bore_line, *extension));
    add(Sensor::kRodPressure, value("p_rod"), StaticPressure(c.rod_line, *extension));
  }
  return {};
}

}  // namespace

const EffectInfo& SensorSupplyInfo() {
  static const EffectInfo info = {
      "sensor_supply",
      "instrument",
      "cylinders",
      "shown = true (1 - y), y = of_speed |v|/(10 mm/s) + of_power max(F v, 0)/1 kW",
      {
          {"of_speed", "-", 0, -10, 10, -0.3, 0.3, "share at 10 mm/s"},
          {"of_power", "-", 0, -10, 10, -0.5, 0.5, "share at 1 kW"},
          {"time_s", "s", 0, 0, 1e6, 2e-3, 5, "T: the supply follows with it; 0: at once"},
          {"load", "-", 1, -100, 100, -5, 5, "of the load cell over the common share"},
          {"p_bore", "-", 1, -100, 100, -5, 5, "of the bore gauge over the common share"},
          {"p_rod", "-", 1, -100, 100, -5, 5, "of the rod gauge over the common share"},
      },
      InstallSensorSupply,
      {
          .rig =
              {
                  {.free = {{"of_speed", 0.01}}},
                  {.free = {{"of_power", 0.02}}},
                  {.free = {{"of_power", 0.02}}, .held = {{"load", 0}, {"p_bore", 0}}},
                  {.free = {{"of_power", 0.02}}, .held = {{"load", 0}, {"p_rod", 0}}},
                  {.free = {{"of_power", 0.02}}, .held = {{"p_bore", 0}, {"p_rod", 0}}},
              },
          .options =
              {
                  {.free = {{"time_s", 0.03, 0.3, 2}}},
                  {.free = {{"of_speed", 0}}},
                  {.free = {{"of_power", 0}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
