#include "effects/backlash.h"

#include <algorithm>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::MountTerms& m = extension->mount(i);
    m.present = true;
    m.gap_m += effect.values.at("gap_m");
    m.gap_tension_share = effect.values.at("tension_share");
    m.hardening_1_per_m2 = std::max(m.hardening_1_per_m2, effect.values.at("hardening_1_per_m2"));
    AddInSeries(&m, effect.values.at("contact_N_per_m"));
  }
  return {};
}

}  // namespace

const EffectInfo& BacklashInfo() {
  static const EffectInfo info = {
      "backlash",
      "mounting",
      "cylinders",
      "free play g, then a stiff contact",
      {
          {"gap_m", "m", 1e-4, 0, 0.05, 1e-6, 2e-3, "total free play"},
          {"contact_N_per_m", "N/m", 1e9, 1e5, 1e12, 2e8, 1e11, "contact stiffness"},
          {"tension_share", "-", 0.5, 0, 1, 0.01, 0.99, "of the play, crossed before tension"},
          {"hardening_1_per_m2", "1/m2", 0, 0, 1e15, 0, 1e13, "b: contact k e (1 + b e²)"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
