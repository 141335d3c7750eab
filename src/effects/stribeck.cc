#include "effects/stribeck.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::LevelParts;
using hydraulics::LevelPlace;
using hydraulics::Walk;

class Stribeck final : public hydraulics::LevelLaw {
 public:
  explicit Stribeck(const EffectParams& effect)
      : extra_N_(effect.values.at("extra_N")),
        speed_m_s_(effect.values.at("speed_m_s")),
        exponent_(effect.values.at("exponent")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    const double ratio = place.speed / speed_m_s_;
    level->extra += extra_N_ * std::exp(-(exponent_ == 1 ? ratio : std::pow(ratio, exponent_)));
  }

 private:
  double extra_N_, speed_m_s_, exponent_;
};

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddLevel(i, std::make_unique<Stribeck>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& StribeckInfo() {
  static const EffectInfo info = {
      "stribeck",
      "friction",
      "cylinders",
      "level + F_s exp(-(|v|/v_s)^n)",
      {
          {"extra_N", "N", 400, -1e5, 1e6, 0, 3000, "F_s"},
          {"speed_m_s", "m/s", 2e-3, 1e-7, 10, 1e-4, 0.05, "v_s"},
          {"exponent", "-", 1, 0.1, 10, 0.5, 3, "n"},
      },
      Install,
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
              },
          .over = {"N", "sv"},
      }};
  return info;
}

}  // namespace phs::effects
