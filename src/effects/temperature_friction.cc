#include "effects/temperature_friction.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::LevelParts;
using hydraulics::LevelPlace;
using hydraulics::Walk;

/// By what surrounds it.
class WarmLevel final : public hydraulics::LevelLaw {
 public:
  explicit WarmLevel(double slope) : slope_(slope) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->of_all *= std::max(1 - slope_ * place.at.warmer, 0.0);
  }

 private:
  double slope_;
};

/// By its own sliding. Memory: h.
class SlidWarm final : public hydraulics::LevelLaw {
 public:
  SlidWarm(double share, double cooling_s) : share_(share), cooling_s_(cooling_s) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->of_all *= std::exp(-share_ * place.memory);
  }
  std::string MemoryName() const override { return "slid_warm"; }
  double MemoryRate(double v, double memory) const noexcept override {
    return std::abs(v) - memory / cooling_s_;
  }
  double AdvanceMemory(double h, double v, double memory) const noexcept override {
    const double settled = std::abs(v) * cooling_s_;
    return settled + (memory - settled) * std::exp(-h / cooling_s_);
  }

 private:
  double share_, cooling_s_;
};

/// A rig that was cold at first.
class ColdStart final : public hydraulics::LevelLaw {
 public:
  ColdStart(double more, double time_s) : more_(more), time_s_(time_s) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->of_all *= std::max(1 + more_ * std::exp(-std::max(place.at.time, 0.0) / time_s_), 0.0);
  }

 private:
  double more_, time_s_;
};

Status InstallTemperatureFriction(const EffectParams& effect, Extension* extension) {
  const double slope = effect.values.at("slope_1_per_K"), share = effect.values.at("slid_1_per_m");
  const double cold = effect.values.at("cold_share");
  for (int i : TargetCylinders(effect, extension->params())) {
    if (cold != 0) {
      extension->AddLevel(i, std::make_unique<ColdStart>(cold, effect.values.at("warm_up_s")));
    }
    if (slope != 0) extension->AddLevel(i, std::make_unique<WarmLevel>(slope));
    if (share == 0) continue;
    extension->AddLevel(i, std::make_unique<SlidWarm>(share, effect.values.at("cooling_s")));
  }
  return {};
}

}  // namespace

const EffectInfo& TemperatureFrictionInfo() {
  static const EffectInfo info = {
      "temperature_friction",
      "friction",
      "cylinders",
      "level (1 - slope (T - T_static)) exp(-w h) (1 + a exp(-t/t_w)), h: the way slid whose "
      "heat is still there",
      {
          {"slope_1_per_K", "1/K", 0.01, -1, 1, -0.1, 0.1, "slope"},
          {"slid_1_per_m", "1/m", 0, -1e3, 1e3, -50, 50, "w: warmed by its own sliding"},
          {"cooling_s", "s", 20, 1e-3, 1e9, 2, 1e3, "t_c"},
          {"cold_share", "-", 0, -1, 100, -0.8, 5, "a: of a rig that was cold at first"},
          {"warm_up_s", "s", 20, 1e-3, 1e9, 2, 1e3, "t_w"},
      },
      InstallTemperatureFriction,
      {
          .rig =
              {
                  {.free = {{"slid_1_per_m", 0}, {"cooling_s", 3, 30, 2}},
                   .held = {{"slope_1_per_K", 0}}},
                  {.free = {{"cold_share", 0}, {"warm_up_s", 4, 25, 2}},
                   .held = {{"slope_1_per_K", 0}}},
              },
          .bench =
              {
                  {.free = {{"slope_1_per_K", 0, 0, 1, Walk::kEach, -2, 2}},
                   .needs = {"temperature_K"}},
              },
      }};
  return info;
}

}  // namespace phs::effects
