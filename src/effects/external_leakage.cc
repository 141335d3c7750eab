#include "effects/external_leakage.h"

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
  for (int line : TargetLines(effect, extension->params())) {
    extension->AddFlow(
        Port::kLine, Port::kAtmosphere, -1, line, "external_leakage",
        std::make_unique<PipeFlow>(PipeFlow::Resistance{R, 0}, PipeFlow::Resistance{R, 0}, 0,
                                   effect.values.at("start_s")));
  }
  return {};
}

}  // namespace

const EffectInfo& ExternalLeakageInfo() {
  static const EffectInfo info = {
      "external_leakage",
      "hydraulic",
      "lines",
      "q = G (p - p_atmosphere) out of the line from start_s on",
      {
          {"conductance_m3_per_Pas", "m3/(Pa s)", 1e-14, 0, 1e-3, 1e-16, 1e-11,
           "laminar conductance at 20 °C"},
          {"start_s", "s", 0, -1e12, 1e12, 0, 1e6, "the leak opens at this time"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
