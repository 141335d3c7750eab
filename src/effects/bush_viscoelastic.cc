#include "effects/bush_viscoelastic.h"

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
    AddInSeries(&m, effect.values.at("stiffness_N_per_m"));
    m.hardening_1_per_m2 = std::max(m.hardening_1_per_m2, effect.values.at("hardening_1_per_m2"));
    m.maxwell_stiffness_N_per_m[0] = effect.values.at("relaxing_N_per_m");
    m.maxwell_damping_Ns_per_m[0] =
        m.maxwell_stiffness_N_per_m[0] * effect.values.at("relaxation_s");
    m.maxwell_stiffness_N_per_m[1] = effect.values.at("second_N_per_m");
    m.maxwell_damping_Ns_per_m[1] =
        m.maxwell_stiffness_N_per_m[1] * effect.values.at("second_relaxation_s");
  }
  return {};
}

}  // namespace

const EffectInfo& BushViscoelasticInfo() {
  static const EffectInfo info = {
      "bush_viscoelastic",
      "mounting",
      "cylinders",
      "spring and one or two Maxwell elements between actuator and piston",
      {
          {"stiffness_N_per_m", "N/m", 4e7, 1e3, 1e13, 4e6, 5e10, "k"},
          {"relaxing_N_per_m", "N/m", 2e7, 1, 1e13, 1e6, 5e10, "k2"},
          {"relaxation_s", "s", 0.3, 1e-5, 1e6, 1e-2, 30, "tau"},
          {"second_N_per_m", "N/m", 0, 0, 1e13, 0, 5e10, "k3"},
          {"second_relaxation_s", "s", 3, 1e-5, 1e6, 1e-2, 60, "tau3"},
          {"hardening_1_per_m2", "1/m2", 0, 0, 1e14, 0, 1e12, "b"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
