#include "effects/check_restriction.h"

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
  const PipeFlow::Resistance out{
      AtModelTemperature(effect.values.at("out_Pas_per_m3"), extension->params()), 0};
  const PipeFlow::Resistance in{
      AtModelTemperature(effect.values.at("in_Pas_per_m3"), extension->params()), 0};
  for (int i : TargetCylinders(effect, extension->params())) {
    for (Port chamber : {Port::kBore, Port::kRod}) {
      extension->SplitChamber(chamber, i, effect.values.at("oil_share"), "check_restriction",
                              std::make_unique<PipeFlow>(out, in, 0));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& CheckRestrictionInfo() {
  static const EffectInfo info = {
      "check_restriction",
      "hydraulic",
      "cylinders",
      "p_chamber - p_line = R_out q or R_in q by direction",
      {
          {"out_Pas_per_m3", "Pa s/m3", 1e10, 1e3, 1e16, 1e8, 1e13,
           "R at 20 °C for flow out of the chamber"},
          {"in_Pas_per_m3", "Pa s/m3", 1e9, 1e3, 1e16, 1e8, 1e13,
           "R at 20 °C for flow into the chamber"},
          {"oil_share", "-", 0.2, 0.02, 0.45, 0.1, 0.4, "share of the line's oil at the chamber"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
