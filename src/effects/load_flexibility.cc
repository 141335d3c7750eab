#include "effects/load_flexibility.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  if (!IsBenchPart(extension->params())) return NotABenchPart(effect.name);
  hydraulics::ElementTerms& e = extension->element();
  if (e.flexible_mass_kg > 0) {
    return Error{"effects." + effect.name, "a second flexible part", "one"};
  }
  e.flexible_mass_kg = effect.values.at("mass_kg");
  e.flexible_Hz = effect.values.at("frequency_Hz");
  e.flexible_damping = effect.values.at("damping_ratio");
  return {};
}

}  // namespace

const EffectInfo& LoadFlexibilityInfo() {
  static const EffectInfo info = {"load_flexibility",
                                  "element",
                                  "",
                                  "part of the mass behind a spring",
                                  {{"mass_kg", "kg", 1, 1e-9, 1e6, 1e-3, 1e4, "m_f"},
                                   {"frequency_Hz", "Hz", 20, 1e-3, 1e6, 0.5, 1e3, "f"},
                                   {"damping_ratio", "-", 0.05, 0, 10, 2e-3, 1, "zeta"}},
                                  Install};
  return info;
}

}  // namespace phs::effects
