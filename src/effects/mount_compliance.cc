#include "effects/mount_compliance.h"

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
    m.hardening_1_per_m2 = std::max(m.hardening_1_per_m2, effect.values.at("hardening_1_per_m2"));
    m.tension_ratio = effect.values.at("tension_ratio");
    AddInSeries(&m, effect.values.at("stiffness_N_per_m"));
  }
  return {};
}

}  // namespace

const EffectInfo& MountComplianceInfo() {
  static const EffectInfo info = {
      "mount_compliance",
      "mounting",
      "cylinders",
      "F = k u (1 + b u^2), times r in tension, u = actuator - piston",
      {
          {"stiffness_N_per_m", "N/m", 4.1e7, 1e3, 1e13, 4e6, 5e10, "k"},
          {"hardening_1_per_m2", "1/m2", 0, 0, 1e14, 0, 1e12, "b"},
          {"tension_ratio", "-", 1, 1e-2, 1e2, 0.3, 3, "r"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
