#include "effects/bush_viscoelastic.h"

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
    m.maxwell_stiffness_N_per_m = effect.values.at("relaxing_N_per_m");
    m.maxwell_damping_Ns_per_m = m.maxwell_stiffness_N_per_m * effect.values.at("relaxation_s");
  }
  return {};
}

}  // namespace

const EffectInfo& BushViscoelasticInfo() {
  static const EffectInfo info = {"bush_viscoelastic",
                                  "mounting",
                                  "cylinders",
                                  "spring and Maxwell element between actuator and piston",
                                  {
                                      {"stiffness_N_per_m", "N/m", 4e7, 1e3, 1e13, 4e6, 1e9, "k"},
                                      {"relaxing_N_per_m", "N/m", 2e7, 1, 1e13, 1e6, 1e9, "k2"},
                                      {"relaxation_s", "s", 0.3, 1e-5, 1e6, 1e-2, 30, "tau"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
