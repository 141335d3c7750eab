#include "effects/presliding.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::FrictionTerms& f = extension->friction(i);
    f.presliding = true;
    f.presliding_stiffness_N_per_m = effect.values.at("stiffness_N_per_m");
    f.presliding_breakaway_ratio = effect.values.at("breakaway_ratio");
  }
  return {};
}

}  // namespace

const EffectInfo& PreslidingInfo() {
  static const EffectInfo info = {
      "presliding",
      "friction",
      "cylinders",
      "elasto-plastic bristle of stiffness sigma0",
      {
          {"stiffness_N_per_m", "N/m", 3.6e7, 1e3, 1e12, 2e6, 5e8, "sigma0"},
          {"breakaway_ratio", "-", 0.7, 0, 0.99, 0.1, 0.95, "elastic share of the level"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
