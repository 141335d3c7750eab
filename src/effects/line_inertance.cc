#include "effects/line_inertance.h"

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

/// A side with less than this share of the other's has as good as none.
constexpr double kNone = 0.05;

Status Install(const EffectParams& effect, Extension* extension) {
  const double ratio = effect.values.at("rod_ratio");
  for (int i : TargetCylinders(effect, extension->params())) {
    for (Port chamber : {Port::kBore, Port::kRod}) {
      if (chamber == Port::kRod ? ratio < kNone : ratio * kNone > 1) continue;
      const double factor = chamber == Port::kRod ? ratio : 1;
      const PipeFlow::Resistance r{
          factor * AtModelTemperature(effect.values.at("laminar_Pas_per_m3"), extension->params()),
          0};
      const double inertance = factor * effect.values.at("inertance_kg_per_m4");
      extension->SplitChamber(chamber, i, effect.values.at("oil_share"), "line_inertance",
                              std::make_unique<PipeFlow>(r, r, inertance));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& LineInertanceInfo() {
  static const EffectInfo info = {
      "line_inertance",
      "hydraulic",
      "cylinders",
      "I dq/dt = p_chamber - p_line - R q",
      {
          {"inertance_kg_per_m4", "kg/m4", 1.6e7, 1, 1e12, 1e5, 1e9, "I = rho l/A"},
          {"laminar_Pas_per_m3", "Pa s/m3", 4e8, 1e3, 1e16, 1e5, 1e11, "R at 20 °C"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5,
           "resistance and inertance of the rod side over those of the bore side; below 1/20 and "
           "above 20 one side has none"},
          {"oil_share", "-", 0.2, 0.02, 0.45, 0.1, 0.4, "share of the line's oil at the chamber"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
