#include "effects/accumulator_precharge.h"

#include <algorithm>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;
using hydraulics::Walk;

Status InstallAccumulatorPrecharge(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    extension->line(line).accumulator_precharge_Pa = effect.values.at("precharge_Pa");
    extension->line(line).accumulator_spread_Pa = effect.values.at("spread_Pa");
  }
  return {};
}

double LargestPrecharge(const hydraulics::PhsParams& params) {
  double most = 0;
  for (const auto& line : params.lines) {
    if (line.accumulator.volume_m3 > 0) most = std::max(most, line.accumulator_precharge_Pa);
  }
  return most;
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
      InstallAccumulatorPrecharge,
      {
          .rig =
              {
                  {.free = {{"precharge_Pa", 0.01, 0.25, 4, Walk::kEitherWay}}},
                  {.free = {{"precharge_Pa", 0.01, 0.13, 3, Walk::kEitherWay}},
                   .places = Places::kAlone},
              },
          .options =
              {
                  {.free = {{"spread_Pa", 2e5, 8e5, 2}}},
              },
          .steps = {{"accumulator_precharge_Pa", true}},
          .declared = LargestPrecharge,
          .over = {"m3", "p", true},
      }};
  return info;
}

}  // namespace phs::effects
