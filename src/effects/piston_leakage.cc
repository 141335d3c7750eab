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
  const double G = effect.values.at("conductance_m3_per_Pas");
  if (G <= 0) return {};
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddFlow(Port::kBore, Port::kRod, i, -1, "piston_leakage",
                       std::make_unique<PipeFlow>(PipeFlow::Resistance{1 / G, 0},
                                                  PipeFlow::Resistance{1 / G, 0}, 0));
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
                                       1e-11, "laminar conductance of the gap"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
