#include "effects/oil_stiffening.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;

Status InstallOilStiffening(const EffectParams& effect, Extension* extension) {
  const double slope = effect.values.at("slope");
  for (int index : TargetLines(effect, extension->params())) {
    extension->line(index).bulk_modulus_slope = slope;
  }
  return {};
}

}  // namespace

const EffectInfo& OilStiffeningInfo() {
  static const EffectInfo info = {
      "oil_stiffening",
      "hydraulic",
      "lines",
      "bulk modulus of the oil rises with pressure: beta + K' (p - p0)",
      {
          {"slope", "-", 10, 0, 20, 0.3, 20, "K': of oil by itself 9 to 12", true},
      },
      InstallOilStiffening,
      {
          .rig =
              {
                  {.free = {{"slope", 3, 12, 2}}, .places = Places::kEach},
              },
          .over = {"m3", "p"},
      }};
  return info;
}

}  // namespace phs::effects
