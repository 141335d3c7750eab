#include "effects/accumulator_precharge.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    extension->line(line).accumulator_precharge_Pa = effect.values.at("precharge_Pa");
    extension->line(line).accumulator_spread_Pa = effect.values.at("spread_Pa");
  }
  return {};
}

}  // namespace

const EffectInfo& AccumulatorPrechargeInfo() {
  static const EffectInfo info = {
      "accumulator_precharge",
      "hydraulic",
      "lines",
      "blow-off opens at this pressure",
      {
          {"precharge_Pa", "Pa", 14.5e6, 1e4, 1e9, 8e6, 2.2e7, "gas precharge"},
          {"spread_Pa", "Pa", 0, 0, 1e8, 3e4, 3e6, "standard deviation of its gradual opening"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
