#include "effects/asymmetric_friction.h"

#include <algorithm>
#include <memory>

#include "effects/added_friction.h"
#include "effects/targets.h"
#include "effects/viscous_friction.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::LevelParts;
using hydraulics::LevelPlace;
using hydraulics::Walk;

class Shift final : public hydraulics::LevelLaw {
 public:
  Shift(double out_N, double in_N, double turn_m_s)
      : out_N_(out_N), in_N_(in_N), turn_m_s_(turn_m_s) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->extra += (place.sign > 0 ? out_N_ : in_N_) * Turned(place.speed, turn_m_s_);
  }

 private:
  double out_N_, in_N_, turn_m_s_;  ///< added in extension, in retraction
};

Status InstallAsymmetricFriction(const EffectParams& effect, Extension* extension) {
  const double d = effect.values.at("level_N"), e = effect.values.at("viscous_Ns_per_m");
  for (int i : TargetCylinders(effect, extension->params())) {
    const bool one_way = effect.values.at("one_way") != 0;
    const double out = one_way ? std::max(d, 0.0) : d, in = one_way ? std::max(-d, 0.0) : -d;
    extension->AddLevel(i, std::make_unique<Shift>(out, in, effect.values.at("turn_m_s")));
    if (e != 0) {
      extension->AddForce(i,
                          std::make_unique<ViscousForce>(std::max(e, 0.0), std::max(-e, 0.0), 1));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& AsymmetricFrictionInfo() {
  static const EffectInfo info = {
      "asymmetric_friction",
      "friction",
      "cylinders",
      "level +- d by direction, viscous part e in extension",
      {
          {"level_N", "N", 100, -1e6, 1e6, -2000, 2000, "d"},
          {"viscous_Ns_per_m", "N s/m", 0, -1e8, 1e8, -2e5, 2e5, "e"},
          {"one_way", "-", 0, 0, 1, 0, 1,
           "1: d in extension alone, where it is below 0 as much more in retraction alone"},
          kTurn,
      },
      InstallAsymmetricFriction,
      {
          .rig =
              {
                  {.free = {{"level_N", 0}}, .held = {{"viscous_Ns_per_m", 0}}},
                  // A lip that turns over and scrapes one way, a wiper that does.
                  {.free = {{"level_N", 0}}, .held = {{"viscous_Ns_per_m", 0}, {"one_way", 1}}},
                  {.free = {{"viscous_Ns_per_m", 0}}, .held = {{"level_N", 0}}},
              },
          .bench =
              {
                  {.free = {{"viscous_Ns_per_m", 0.1, 0.1, 1, Walk::kEitherWay, -20, 20}},
                   .held = {{"level_N", 0}}},
                  // A level that differs by direction and an offset of the load cell are one and
                  // the same force.
                  {.free = {{"viscous_Ns_per_m", 0.1, 0.1, 1, Walk::kEitherWay, -20, 20},
                            {"level_N", 0, 0, 1, Walk::kEach, -1, 1}},
                   .beside = {"element.offset"}},
                  {.free = {{"level_N", 0, 0, 1, Walk::kEach, -1, 1}},
                   .held = {{"viscous_Ns_per_m", 0}},
                   .beside = {"element.offset"}},
              },
          .bogie =
              {
                  {.free = {{"level_N", 0}}},
              },
          .options =
              {
                  TurnOption(),
              },
          .over = {"N", "sv"},
      }};
  return info;
}

}  // namespace phs::effects
