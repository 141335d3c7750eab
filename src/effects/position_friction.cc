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
    f.spot_share = effect.values.at("spot_share");
    f.spot_centre_m = effect.values.at("spot_centre_m");
    f.spot_width_m = effect.values.at("spot_width_m");
    f.wave_sine = effect.values.at("wave_sine");
    f.wave_cosine = effect.values.at("wave_cosine");
    f.wave_length_m = effect.values.at("wave_length_m");
    f.position_curvature_1_per_m2 += effect.values.at("curvature_1_per_m2");
  }
  return {};
}

}  // namespace

const EffectInfo& PositionFrictionInfo() {
  static const EffectInfo info = {
      "position_friction",
      "friction",
      "cylinders",
      "level times 1 + s y + c y^2 + tight spot b exp(-((y-y0)/w)^2) + wave",
      {
          {"slope_1_per_m", "1/m", 20, -1e5, 1e5, -500, 500, "s"},
          {"curvature_1_per_m2", "1/m2", 0, -1e9, 1e9, -1e5, 1e5, "c"},
          {"spot_share", "-", 0, -1, 20, -0.5, 2, "b"},
          {"spot_centre_m", "m", 0, -1, 1, -0.03, 0.03, "y0"},
          {"spot_width_m", "m", 1e-3, 1e-6, 1, 1e-4, 0.02, "w"},
          {"wave_sine", "-", 0, -1, 1, -0.9, 0.9, "of the wave"},
          {"wave_cosine", "-", 0, -1, 1, -0.9, 0.9, "of the wave"},
          {"wave_length_m", "m", 1e-3, 1e-6, 1, 2e-4, 0.02, "period"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
