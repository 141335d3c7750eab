#include "effects/piston_leakage.h"

#include <memory>

#include "effects/targets.h"
#include "hydraulics/pipe.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::PipeFlow;
using hydraulics::Port;

Status Install(const EffectParams& effect, Extension* extension) {
  if (effect.values.at("conductance_m3_per_Pas") <= 0) return {};
  const double R =
      AtModelTemperature(1 / effect.values.at("conductance_m3_per_Pas"), extension->params());
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddFlow(
        Port::kBore, Port::kRod, i, -1, "piston_leakage",
        std::make_unique<PipeFlow>(PipeFlow::Resistance{R, 0}, PipeFlow::Resistance{R, 0}, 0));
  }
  return {};
}

}  // namespace

const EffectInfo& PistonLeakageInfo() {
  static const EffectInfo info = {"piston_leakage",
                                  "hydraulic",
                                  "cylinders",
                                  "q = G (p_bore - p_rod) past the piston seal",
                                  {
                                      {"conductance_m3_per_Pas", "m3/(Pa s)", 1e-13, 0, 1e-6, 1e-15,
                                       1e-11, "laminar conductance of the gap at 20 °C"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
