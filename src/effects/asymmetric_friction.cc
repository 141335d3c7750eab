#include "effects/asymmetric_friction.h"

#include <cmath>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::FrictionTerms& f = extension->friction(i);
    f.level_shift_N += effect.values.at("level_N");
    const double e = effect.values.at("viscous_Ns_per_m");
    (e >= 0 ? f.viscous_extension_Ns_per_m : f.viscous_retraction_Ns_per_m) += std::abs(e);
  }
  return {};
}

}  // namespace

const EffectInfo& AsymmetricFrictionInfo() {
  static const EffectInfo info = {"asymmetric_friction",
                                  "friction",
                                  "cylinders",
                                  "level +- d by direction, viscous part e in extension",
                                  {
                                      {"level_N", "N", 100, -1e6, 1e6, -2000, 2000, "d"},
                                      {"viscous_Ns_per_m", "N s/m", 0, -1e8, 1e8, -1e4, 1e4, "e"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
