#include "effects/gas_volume.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;

Status InstallGasVolume(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    extension->line(line).gas_volume_m3 *= effect.values.at("factor");
  }
  return {};
}

double GasAsTheOthers(const hydraulics::PhsParams& params) {
  for (const auto& line : params.lines) {
    if (line.gas_volume_m3 > 0) return 1;
  }
  return 0;
}

}  // namespace

const EffectInfo& GasVolumeInfo() {
  static const EffectInfo info = {
      "gas_volume",
      "hydraulic",
      "lines",
      "V_gas * f: reservoirs of these lines hold more or less gas",
      {{"factor", "-", 0.5, 1e-3, 1e3, 0.2, 5, "f", true}},
      InstallGasVolume,
      {
          // On a rig the gas of each line is a free number of the declared model.
          .bogie = {{.free = {{"factor", 0.6, 1.6, 2}},
                     .places = Places::kAlone,
                     .beside = {"gas_volume_m3"}}},
          .declared = GasAsTheOthers,
      }};
  return info;
}

}  // namespace phs::effects
