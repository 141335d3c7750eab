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
    f.presliding_creeps = effect.values.at("creeping") >= 0.5;
    f.presliding_exponent = effect.values.at("exponent");
    f.presliding_share = effect.values.at("share");
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
          {"creeping", "-", 0, 0, 1, 0, 1, "1: bristle of Dahl and LuGre, 0: elasto-plastic"},
          {"exponent", "-", 1, 0.05, 10, 0.3, 4, "i of the creeping bristle (Dahl)"},
          {"share", "-", 1, 0.01, 1, 0.02, 1, "of the level that sticks; the rest slides at once"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
