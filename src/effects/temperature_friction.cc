#include "effects/temperature_friction.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->friction(i).temperature_slope_1_per_K += effect.values.at("slope_1_per_K");
  }
  return {};
}

}  // namespace

const EffectInfo& TemperatureFrictionInfo() {
  static const EffectInfo info = {"temperature_friction",
                                  "friction",
                                  "cylinders",
                                  "level (1 - slope (T - T_static))",
                                  {{"slope_1_per_K", "1/K", 0.01, -1, 1, -0.1, 0.1, "slope"}},
                                  Install};
  return info;
}

}  // namespace phs::effects
