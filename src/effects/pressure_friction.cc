#include "effects/pressure_friction.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::FrictionTerms& f = extension->friction(i);
    f.pressure_bore_N_per_Pa += effect.values.at("bore_N_per_Pa");
    f.pressure_rod_N_per_Pa += effect.values.at("rod_N_per_Pa");
    f.pressure_difference_N_per_Pa += effect.values.at("difference_N_per_Pa");
  }
  return {};
}

}  // namespace

const EffectInfo& PressureFrictionInfo() {
  static const EffectInfo info = {
      "pressure_friction",
      "friction",
      "cylinders",
      "level + k (p - p0) of each chamber + k_d (|p_bore - p_rod| - at rest)",
      {
          {"bore_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_bore"},
          {"rod_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_rod"},
          {"difference_N_per_Pa", "N/Pa", 0, -1, 1, 0, 1e-2, "k_d"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
