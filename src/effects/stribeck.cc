#include "effects/stribeck.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::FrictionTerms& f = extension->friction(i);
    f.stribeck_extra_extension_N += effect.values.at("extra_N");
    f.stribeck_extra_retraction_N += effect.values.at("extra_N");
    f.stribeck_exponent = effect.values.at("exponent");
    f.stribeck_speed_m_s = effect.values.at("speed_m_s");
  }
  return {};
}

}  // namespace

const EffectInfo& StribeckInfo() {
  static const EffectInfo info = {"stribeck",
                                  "friction",
                                  "cylinders",
                                  "level + F_s exp(-(|v|/v_s)^n)",
                                  {
                                      {"extra_N", "N", 400, -1e5, 1e6, 0, 3000, "F_s"},
                                      {"speed_m_s", "m/s", 2e-3, 1e-7, 10, 1e-4, 0.05, "v_s"},
                                      {"exponent", "-", 1, 0.1, 10, 0.5, 3, "n"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
