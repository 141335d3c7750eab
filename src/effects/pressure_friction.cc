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
    f.pressure_retraction_ratio = effect.values.at("retraction_ratio");
  }
  return {};
}

}  // namespace

const EffectInfo& PressureFrictionInfo() {
  static const EffectInfo info = {
      "pressure_friction",
      "friction",
      "cylinders",
      "level + k (p - p0) of each chamber + k_d (|p_bore - p_rod| - at rest), by direction",
      {
          {"bore_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_bore"},
          {"rod_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_rod"},
          {"difference_N_per_Pa", "N/Pa", 0, -1, 1, 0, 1e-2, "k_d"},
          {"retraction_ratio", "-", 1, 0, 1e3, 0.05, 20, "of these terms, in retraction"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
