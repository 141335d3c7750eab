#include "effects/oil_stiffening.h"

#include <cmath>

#include "effects/formula_laws.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;

Status InstallOilStiffening(const EffectParams& effect, Extension* extension) {
  const double slope = effect.values.at("slope"), softness = effect.values.at("softness");
  const double over = effect.values.at("over_Pa");
  if (slope > 0 && softness > 0) {
    return RefuseEffect(effect, "the modulus rises by two laws", "slope: 0 beside softness");
  }
  for (int index : TargetLines(effect, extension->params())) {
    hydraulics::LineParams& line = extension->line(index);
    line.bulk_modulus_slope = slope;
    if (softness == 0) continue;
    const double missing = softness * std::exp(-line.static_pressure_Pa / over);
    line.bulk_modulus_rise_Pa = line.bulk_modulus_Pa * missing / (1 - missing);
    line.bulk_modulus_over_Pa = over;
  }
  return {};
}

}  // namespace

const EffectInfo& OilStiffeningInfo() {
  static const EffectInfo info = {
      "oil_stiffening",
      "hydraulic",
      "lines",
      "bulk modulus of the oil rises with pressure: beta + K' (p - p0), or B (1 - c exp(-p/P))",
      {
          {"slope", "-", 10, 0, 20, 0.3, 20, "K': of oil by itself 9 to 12", true},
          {"softness", "-", 0, 0, 0.95, 0.03, 0.9, "c: share that is missing at no pressure"},
          {"over_Pa", "Pa", 5e6, 1e5, 1e9, 5e5, 3e7, "P: over this pressure it comes", true},
      },
      InstallOilStiffening,
      {
          .rig =
              {
                  {.free = {{"slope", 3, 12, 2}}, .places = Places::kEach},
                  {.free = {{"softness", 0.05, 0.6, 2}, {"over_Pa", 5e6}},
                   .held = {{"slope", 0}},
                   .places = Places::kEach},
              },
          .over = {"m3", "p"},
      }};
  return info;
}

}  // namespace phs::effects
