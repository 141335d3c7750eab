#include "effects/diaphragm_stop.h"

#include <algorithm>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;

Status InstallDiaphragmStop(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    hydraulics::LineParams& l = extension->line(line);
    l.reservoir.min_gas_volume_m3 =
        std::min(effect.values.at("min_gas_volume_m3"), l.gas_volume_m3);
    const double precharge = std::min(effect.values.at("precharge_Pa"), l.static_pressure_Pa);
    if (precharge > 0) {
      l.reservoir.port_gas_volume_m3 = l.gas_volume_m3 * l.static_pressure_Pa / precharge;
    }
    l.reservoir.stop_spread = effect.values.at("spread");
    l.reservoir.stop_share = effect.values.at("share");
  }
  return {};
}

}  // namespace

const EffectInfo& DiaphragmStopInfo() {
  static const EffectInfo info = {
      "diaphragm_stop",
      "hydraulic",
      "lines",
      "gas volume of the reservoir stays above a minimum, or below a maximum",
      {
          {"min_gas_volume_m3", "m3", 4e-6, 0, 1e-2, 1e-7, 1e-4, "V_min"},
          {"precharge_Pa", "Pa", 0, 0, 1e8, 2e4, 1.5e7,
           "the diaphragm rests on the oil port below it; 0 = never"},
          {"spread", "-", 0, 0, 0.8, 0.02, 0.8, "relative standard deviation of its parts' stops"},
          {"share", "-", 1, 0, 1, 0.05, 1, "of the gas that it holds; < 1: the stop gives way"},
      },
      InstallDiaphragmStop,
      {
          .rig =
              {
                  {.free = {{"min_gas_volume_m3", 1e-6, 1e-5, 5}}, .places = Places::kEach},
                  {.free = {{"min_gas_volume_m3", 3e-6, 1e-5, 2}, {"share", 0.6}},
                   .places = Places::kAlone},
                  {.free = {{"precharge_Pa", 2.5e5, 1.6e6, 6}},
                   .held = {{"min_gas_volume_m3", 0}},
                   .places = Places::kEach},
              },
          .options =
              {
                  {.free = {{"spread", 0.1, 0.4, 2}}},
                  {.free = {{"share", 0.6}}},
              },
          .steps = {{"reservoir.min_gas_volume_m3", false, 0.03}},
          .over = {"m3", "p", true},
      }};
  return info;
}

}  // namespace phs::effects
