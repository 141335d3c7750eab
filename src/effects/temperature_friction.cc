#include "effects/temperature_friction.h"

#include <algorithm>
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

class WarmLevel final : public hydraulics::LevelLaw {
 public:
  explicit WarmLevel(const EffectParams& effect) : slope_(effect.values.at("slope_1_per_K")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->of_all *= std::max(1 - slope_ * place.at.warmer, 0.0);
  }

 private:
  double slope_;
};

Status InstallTemperatureFriction(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddLevel(i, std::make_unique<WarmLevel>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& TemperatureFrictionInfo() {
  static const EffectInfo info = {
      "temperature_friction",
      "friction",
      "cylinders",
      "level (1 - slope (T - T_static))",
      {{"slope_1_per_K", "1/K", 0.01, -1, 1, -0.1, 0.1, "slope"}},
      InstallTemperatureFriction,
      {
          .bench =
              {
                  {.free = {{"slope_1_per_K", 0, 0, 1, Walk::kEach, -2, 2}},
                   .needs = {"temperature_K"}},
              },
      }};
  return info;
}

}  // namespace phs::effects
