#include "effects/position_friction.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::FrictionTerms& f = extension->friction(i);
    f.position_slope_1_per_m += effect.values.at("slope_1_per_m");
    f.position_curvature_1_per_m2 += effect.values.at("curvature_1_per_m2");
  }
  return {};
}

}  // namespace

const EffectInfo& PositionFrictionInfo() {
  static const EffectInfo info = {"position_friction",
                                  "friction",
                                  "cylinders",
                                  "level times 1 + s y + c y^2",
                                  {
                                      {"slope_1_per_m", "1/m", 20, -1e5, 1e5, -200, 200, "s"},
                                      {"curvature_1_per_m2", "1/m2", 0, -1e9, 1e9, -1e5, 1e5, "c"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
