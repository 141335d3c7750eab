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
      "gas volume of the reservoir stays above a minimum",
      {
          {"min_gas_volume_m3", "m3", 4e-6, 0, 1e-2, 1e-7, 1e-4, "V_min"},
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
