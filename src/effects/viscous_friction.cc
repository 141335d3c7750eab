#include "effects/viscous_friction.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::FrictionTerms& f = extension->friction(i);
    f.viscous_exponent = effect.values.at("exponent");
    f.viscous_extension_Ns_per_m += effect.values.at("extension_Ns_per_m");
    f.viscous_retraction_Ns_per_m += effect.values.at("retraction_Ns_per_m");
  }
  return {};
}

}  // namespace

const EffectInfo& ViscousFrictionInfo() {
  static const EffectInfo info = {
      "viscous_friction",
      "friction",
      "cylinders",
      "+ c v (|v|/1 cm/s)^(n-1)",
      {
          {"extension_Ns_per_m", "N s/m", 5000, 0, 1e8, 0, 1e6, "c for v > 0"},
          {"retraction_Ns_per_m", "N s/m", 5000, 0, 1e8, 0, 1e6, "c for v < 0"},
          {"exponent", "-", 1, 0.2, 4, 0.4, 2.5, "n"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
