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
  for (int i : TargetCylinders(effect, extension->params())) {
    for (Port chamber : {Port::kBore, Port::kRod}) {
      const double factor = chamber == Port::kRod ? effect.values.at("rod_ratio") : 1;
      const PipeFlow::Resistance out{
          factor * AtModelTemperature(effect.values.at("out_Pas_per_m3"), extension->params()),
          factor * effect.values.at("turbulent_out_Pas2_per_m6")};
      const PipeFlow::Resistance in{
          factor * AtModelTemperature(effect.values.at("in_Pas_per_m3"), extension->params()),
          factor * effect.values.at("turbulent_in_Pas2_per_m6")};
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
      "p_chamber - p_line = R q + K q|q|, R and K by direction",
      {
          {"out_Pas_per_m3", "Pa s/m3", 1e10, 1e3, 1e16, 1e6, 1e13,
           "R at 20 °C for flow out of the chamber"},
          {"in_Pas_per_m3", "Pa s/m3", 1e9, 1e3, 1e16, 1e6, 1e13,
           "R at 20 °C for flow into the chamber"},
          {"turbulent_out_Pas2_per_m6", "Pa s2/m6", 0, 0, 1e20, 0, 1e17, "K out of the chamber"},
          {"turbulent_in_Pas2_per_m6", "Pa s2/m6", 0, 0, 1e20, 0, 1e17, "K into the chamber"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.02, 50,
           "resistance of the rod side over that of the bore side"},
          {"oil_share", "-", 0.2, 0.02, 0.45, 0.1, 0.4, "share of the line's oil at the chamber"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
