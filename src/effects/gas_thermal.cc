#include "effects/gas_thermal.h"

#include "effects/targets.h"
#include "hydraulics/bwr_gas.h"
#include "hydraulics/perfect_gas.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;

Status InstallGasThermal(const EffectParams& effect, Extension* extension) {
  const hydraulics::GasLaw* law =
      effect.values.at("real_gas") >= 0.5 ? &hydraulics::kBwrGas : &hydraulics::kIdealGas;
  for (int line : TargetLines(effect, extension->params())) {
    hydraulics::LineParams& l = extension->line(line);
    l.reservoir.law = l.accumulator.law = law;
    const double time =
        effect.values.at("thermal_time_s") * LineFactor(effect, extension->params(), line);
    l.reservoir.thermal_time_s = time;
    l.accumulator.thermal_time_s = time * effect.values.at("accumulator_ratio");
    l.reservoir.heat_capacity_ratio = l.accumulator.heat_capacity_ratio =
        effect.values.at("heat_capacity_ratio");
    l.reservoir.wall_heat_ratio = l.accumulator.wall_heat_ratio =
        effect.values.at("wall_heat_ratio");
    l.reservoir.density_exponent = l.accumulator.density_exponent =
        effect.values.at("density_exponent");
    l.reservoir.wall_time_s = l.accumulator.wall_time_s = effect.values.at("wall_time_s");
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
          // Filled with foam: conduction into pores of d = 1 mm, d^2/(pi^2 a), takes 5 ms at 1 bar.
          {"thermal_time_s", "s", 3, 1e-4, 1e9, 1e-3, 60, "tau"},
          {"heat_capacity_ratio", "-", 1, 0.5, 1e4, 0.55, 500,
           "(gas + filler or wall that stores heat with it) / nitrogen; 0.6: a monatomic gas"},
          {"wall_heat_ratio", "-", 0, 0, 1e4, 0, 10,
           "r: heat capacity of the gas over that of a wall that warms up"},
          {"wall_time_s", "s", 60, 1e-3, 1e9, 2, 1000, "tau_w: wall with its surroundings"},
          {"density_exponent", "-", 0, -2, 2, -1, 1,
           "m: tau ~ density^-m; 1/2: free convection, -2/3: a surface that shrinks"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5,
           "time constant of rod lines over that of bore lines"},
          {"accumulator_ratio", "-", 1, 1e-4, 1e4, 1e-3, 100,
           "time constant of blow-off accumulators over that of reservoirs"},
          {"real_gas", "-", 0, 0, 1, 0, 1, "1: Benedict-Webb-Rubin, 0: ideal gas"},
      },
      InstallGasThermal,
      {
          .rig =
              {
                  {.free = {{"thermal_time_s", 0.1, 15, 4}}},
                  // Accumulators that keep the temperature of the oil.
                  {.free = {{"thermal_time_s", 0.5, 15, 3}}, .held = {{"accumulator_ratio", 1e-4}}},
                  {.free = {{"thermal_time_s", 1, 4, 2}, {"heat_capacity_ratio", 5, 50, 2}},
                   .places = Places::kEach},
                  {.free = {{"thermal_time_s", 3}}, .places = Places::kAlone},
              },
          .bogie =
              {
                  {.free = {{"thermal_time_s", 3}}},
              },
          .options =
              {
                  {.free = {{"heat_capacity_ratio", 0.7, 30, 4}}},
                  {.free = {{"wall_heat_ratio", 0.3}, {"wall_time_s", 20, 100, 2}}},
                  {.free = {{"density_exponent", -0.5, 0.5, 2}}},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
                  {.free = {{"accumulator_ratio", 0.02, 3, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
