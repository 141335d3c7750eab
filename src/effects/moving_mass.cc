#include "effects/moving_mass.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  if (!IsBenchPart(extension->params())) return NotABenchPart(effect.name);
  extension->element().mass_kg += effect.values.at("mass_kg");
  return {};
}

}  // namespace

const EffectInfo& MovingMassInfo() {
  static const EffectInfo info = {"moving_mass",
                                  "element",
                                  "",
                                  "force m a beyond the declared mass",
                                  {{"mass_kg", "kg", 1, 0, 1e6, 0, 1e4, "m"}},
                                  Install};
  return info;
}

}  // namespace phs::effects
