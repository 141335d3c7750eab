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
    hydraulics::LineParams& line = extension->line(index);
    if (!(slope * line.static_pressure_Pa < 0.9 * line.bulk_modulus_Pa)) {
      return Error{"effects.oil_stiffening.slope",
                   "the oil of " + line.name + " would have no stiffness at zero pressure",
                   "less than 0.9 of its bulk modulus over its static pressure", ""};
    }
    line.bulk_modulus_slope = slope;
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
          {"slope", "-", 10, 0, 100, 0.3, 60,
           "K': oil by itself 9 to 12, more with joints that seat", true},
      },
      InstallOilStiffening,
      {
          .rig =
              {
                  {.free = {{"slope", 3, 20, 2}}, .places = Places::kEach},
              },
          .over = {"m3", "p"},
      }};
  return info;
}

}  // namespace phs::effects
