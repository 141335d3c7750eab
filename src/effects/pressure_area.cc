#include "effects/pressure_area.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  if (!IsBenchPart(extension->params())) return NotABenchPart(effect.name);
  extension->element().pressure_area_m2 += effect.values.at("area_m2");
  return {};
}

}  // namespace

const EffectInfo& PressureAreaInfo() {
  static const EffectInfo info = {"pressure_area",
                                  "element",
                                  "",
                                  "force A p of the pressure channel",
                                  {{"area_m2", "m2", 1e-4, -10, 10, -0.1, 0.1, "A"}},
                                  Install};
  return info;
}

}  // namespace phs::effects
