#include "effects/stribeck.h"

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

class Stribeck : public hydraulics::LevelLaw {
 public:
  explicit Stribeck(const EffectParams& effect)
      : extra_N_(effect.values.at("extra_N")),
        speed_m_s_(effect.values.at("speed_m_s")),
        exponent_(effect.values.at("exponent")),
        retraction_ratio_(effect.values.at("retraction_ratio")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    AddAt(place.speed, place.sign, level);
  }

 protected:
  void AddAt(double speed, double sign, LevelParts* level) const noexcept {
    const double ratio = speed / speed_m_s_;
    const double extra = sign > 0 ? extra_N_ : retraction_ratio_ * extra_N_;
    level->extra += extra * std::exp(-(exponent_ == 1 ? ratio : std::pow(ratio, exponent_)));
  }

 private:
  double extra_N_, speed_m_s_, exponent_, retraction_ratio_;
};

/// Memory: the speed of the film, a lag behind |v|.
class LaggingStribeck final : public Stribeck {
 public:
  explicit LaggingStribeck(const EffectParams& effect)
      : Stribeck(effect), film_time_s_(effect.values.at("film_time_s")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    AddAt(place.memory, place.sign, level);
  }
  std::string MemoryName() const override { return "film"; }
  double MemoryRate(double v, double memory) const noexcept override {
    return (std::abs(v) - memory) / film_time_s_;
  }
  double AdvanceMemory(double h, double v, double memory) const noexcept override {
    return std::abs(v) + (memory - std::abs(v)) * std::exp(-h / film_time_s_);
  }

 private:
  double film_time_s_;
};

Status InstallStribeck(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    if (effect.values.at("film_time_s") > 0) {
      extension->AddLevel(i, std::make_unique<LaggingStribeck>(effect));
    } else {
      extension->AddLevel(i, std::make_unique<Stribeck>(effect));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& StribeckInfo() {
  static const EffectInfo info = {
      "stribeck",
      "friction",
      "cylinders",
      "level + F_s exp(-(u/v_s)^n), u: |v|, or a lag tau behind it",
      {
          {"extra_N", "N", 400, -1e5, 1e6, 0, 3000, "F_s"},
          {"speed_m_s", "m/s", 2e-3, 1e-7, 10, 1e-4, 0.05, "v_s"},
          {"exponent", "-", 1, 0.1, 10, 0.5, 3, "n"},
          {"retraction_ratio", "-", 1, 0, 1e3, 0.05, 20, "of F_s, in retraction"},
          {"film_time_s", "s", 0, 0, 100, 0, 1, "tau; 0: no lag"},
      },
      InstallStribeck,
      {
          .rig =
              {
                  {.free = {{"extra_N", 200}, {"speed_m_s", 5e-4, 0.01, 3}}},
                  {.free = {{"extra_N", 200}, {"speed_m_s", 1e-3, 4e-3, 2}},
                   .held = {{"exponent", 2}}},
              },
          .bench =
              {
                  {.free = {{"extra_N", 0.2, 0, 1, Walk::kEach, 0, 5},
                            {"speed_m_s", 0.01, 0.3, 3, Walk::kEach, 1e-3, 1}},
                   .beside = {"friction.breakaway"}},
              },
          .bogie =
              {
                  {.free = {{"extra_N", 200}, {"speed_m_s", 3e-3}}},
              },
          .options =
              {
                  {.free = {{"exponent", 1.5}}},
                  {.free = {{"retraction_ratio", 1}}},
                  {.free = {{"film_time_s", 0.01, 0.1, 2}}},
              },
          .over = {"N", "sv"},
      }};
  return info;
}

}  // namespace phs::effects
