#include "effects/gas_thermal.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  const hydraulics::GasLaw law =
      effect.values.at("real_gas") >= 0.5 ? hydraulics::GasLaw::kBwr : hydraulics::GasLaw::kIdeal;
  for (int line : TargetLines(effect, extension->params())) {
    hydraulics::LineParams& l = extension->line(line);
    l.reservoir.law = l.accumulator.law = law;
    l.reservoir.thermal_time_s = l.accumulator.thermal_time_s = effect.values.at("thermal_time_s");
  }
  return {};
}

}  // namespace

const EffectInfo& GasThermalInfo() {
  static const EffectInfo info = {
      "gas_thermal",
      "hydraulic",
      "lines",
      "energy equation of the gas with a thermal time constant",
      {
          {"thermal_time_s", "s", 3, 1e-4, 1e9, 0.1, 60, "tau"},
          {"real_gas", "-", 0, 0, 1, 0, 1, "1: Benedict-Webb-Rubin, 0: ideal gas"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
