#include "effects/mount_compliance.h"

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
    AddInSeries(&m, effect.values.at("stiffness_N_per_m"));
  }
  return {};
}

}  // namespace

const EffectInfo& MountComplianceInfo() {
  static const EffectInfo info = {"mount_compliance",
                                  "mounting",
                                  "cylinders",
                                  "F = k (actuator - piston)",
                                  {
                                      {"stiffness_N_per_m", "N/m", 4.1e7, 1e3, 1e13, 4e6, 5e9, "k"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
