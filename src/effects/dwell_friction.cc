#include "effects/dwell_friction.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    hydraulics::FrictionTerms& f = extension->friction(i);
    f.dwell_extra_N = effect.values.at("extra_N");
    f.dwell_time_s = effect.values.at("time_s");
    f.dwell_length_m = effect.values.at("length_m");
  }
  return {};
}

}  // namespace

const EffectInfo& DwellFrictionInfo() {
  static const EffectInfo info = {"dwell_friction",
                                  "friction",
                                  "cylinders",
                                  "level + F_d phi, phi grows at rest and is wiped out by sliding",
                                  {
                                      {"extra_N", "N", 300, 0, 1e6, 0, 10000, "F_d"},
                                      {"time_s", "s", 5, 1e-3, 1e9, 0.1, 1000, "tau"},
                                      {"length_m", "m", 1e-4, 1e-9, 1, 1e-5, 1e-3, "d"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
