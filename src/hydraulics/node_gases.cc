#include "hydraulics/node_gases.h"

#include <algorithm>

namespace phs::hydraulics {
namespace {

NodeGas CompileGas(const GasChargeParams& charge, double volume, double pressure, double T) {
  NodeGas g;
  g.gas.law = charge.law;
  g.gas.reference_volume = volume;
  g.gas.reference_pressure = pressure;
  g.gas.reference_temperature = T;
  g.gas.exponent = charge.polytropic_exponent;
  g.gas.thermal_time = charge.thermal_time_s;
  g.gas.heat_capacity_ratio = charge.heat_capacity_ratio;
  g.gas.wall_heat_ratio = charge.wall_heat_ratio;
  g.gas.density_exponent = charge.density_exponent;
  g.gas.wall_time = charge.wall_time_s;
  g.gas.min_volume = charge.min_gas_volume_m3;
  g.gas.max_volume = std::max(charge.volume_m3, volume);
  g.static_volume = volume;
  g.gas.SetMass();
  return g;
}

// Three equal parts about a mean stand for what starts gradually: their standard deviation is 1.
constexpr double kParts[] = {-1.224744871391589, 0, 1.224744871391589};

}  // namespace

void AddReservoir(const LineParams& line, double T, Node* node) {
  const double p0 = line.static_pressure_Pa, least = line.reservoir.min_gas_volume_m3;
  const double most = line.reservoir.port_gas_volume_m3, spread = line.reservoir.stop_spread;
  const bool stops = least > 0 || most > 0;
  // `share` of the reservoir, its stops at `least` and `most` of the whole times `part`; 0: none.
  const auto add = [&](double share, double part) {
    GasChargeParams charge = line.reservoir;
    const double volume = share * line.gas_volume_m3;
    charge.volume_m3 *= share;
    if (most > 0 && part > 0) charge.volume_m3 = std::min(charge.volume_m3, share * most * part);
    charge.min_gas_volume_m3 = std::clamp(share * least * part, 0.0, volume);
    node->gases.push_back(CompileGas(charge, volume, p0, T));
  };
  const double held = stops ? line.reservoir.stop_share : 1;
  if (held < 1) add(1 - held, 0);
  if (held <= 0) return;
  if (spread == 0 || !stops) return add(held, 1);
  for (const double part : kParts) add(held / 3, 1 + part * spread);
}

void AddAccumulator(const LineParams& line, double T, Node* node) {
  auto add = [&](double volume, double precharge) {
    GasChargeParams charge = line.accumulator;
    charge.min_gas_volume_m3 *= volume / line.accumulator.volume_m3;
    charge.volume_m3 = volume;
    NodeGas g = CompileGas(charge, volume, precharge, T);
    g.blow_off = true;
    // At a static pressure above its precharge the accumulator is partly full of oil from the
    // start.
    g.static_volume = CalcGas(g.gas, node->p0, T).volume;
    node->gases.push_back(g);
  };
  const double volume = line.accumulator.volume_m3, mean = line.accumulator_precharge_Pa;
  if (line.accumulator_spread_Pa == 0) return add(volume, mean);
  constexpr double kLeast = 0.05;  // of the mean
  for (const double part : kParts) {
    add(volume / 3, std::max(mean + part * line.accumulator_spread_Pa, kLeast * mean));
  }
}

Node MakeNode(const LineParams& line, double T) {
  Node node;
  node.p0 = line.static_pressure_Pa;
  node.oil_volume = line.oil_volume_m3;
  node.oil = {line.bulk_modulus_Pa, line.bulk_modulus_slope, line.bulk_modulus_rise_Pa,
              line.bulk_modulus_over_Pa};
  node.softening = line.softening_1_per_K;
  node.expansion = line.expansion_1_per_K;
  node.air = (line.free_air_m3 + kTraceAir * line.oil_volume_m3) * kAtmosphere;
  node.temperature = T;
  if (line.gas_volume_m3 > 0) AddReservoir(line, T, &node);
  if (line.accumulator.volume_m3 > 0) AddAccumulator(line, T, &node);
  return node;
}

}  // namespace phs::hydraulics
