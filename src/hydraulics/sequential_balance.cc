#include "hydraulics/sequential_balance.h"

#include <algorithm>
#include <cmath>

namespace phs::hydraulics {
namespace {

// Pressure at which the gas of `g` becomes as stiff as the oil (at least the static pressure).
double FullPressure(const Node& node, const NodeGas& g, double T, double oil_compliance) {
  double low = node.p0, high = 1e9;
  for (int i = 0; i < 80; ++i) {
    const double p = std::sqrt(low * high);
    const GasState at = CalcGas(g.gas, p, T);
    const bool softer = !at.stopped && -at.dV_dp > oil_compliance;
    (softer ? low : high) = p;
  }
  return low;
}

}  // namespace

NodeState SolveSequential(const Node& node, double D, double ambient,
                          const double* state) noexcept {
  const double C = node.Compliance(ambient);
  const NodeGas* reservoir = nullptr;
  const NodeGas* blow_off = nullptr;
  for (const NodeGas& g : node.gases) (g.blow_off ? blow_off : reservoir) = &g;

  NodeState out;
  out.slope = C;
  double p = node.p0, left = D;
  if (reservoir != nullptr) {
    const double T = GasTemperature(*reservoir, ambient, state);
    const double p_full = FullPressure(node, *reservoir, T, C);
    const double room = reservoir->static_volume - CalcGas(reservoir->gas, p_full, T).volume;
    const double taken = std::min(D, room);
    const double volume = reservoir->static_volume - taken;
    const double largest = reservoir->gas.max_volume;
    left = D - taken;
    p = CalcGasPressure(reservoir->gas, std::min(volume, largest), T);
    if (volume > largest) left = largest - volume;  // empty of oil: the oil itself is stretched
    out.slope = std::max(-CalcGas(reservoir->gas, p, T).dV_dp, left != 0 ? C : 0.0);
    if (left != 0) out.slope = C;
  }
  const double start = p;
  p += left / C;
  if (blow_off != nullptr && left > 0) {
    const double T = GasTemperature(*blow_off, ambient, state);
    const double p_open = CalcGasPressure(blow_off->gas, blow_off->static_volume, T);
    const double over = left - C * (p_open - start);
    if (over > 0) {
      p = CalcGasPressure(blow_off->gas, std::max(blow_off->static_volume - over, 1e-9), T);
      out.slope = -CalcGas(blow_off->gas, p, T).dV_dp;
    }
  }
  // The stretched oil is held by its trace of air.
  if (p < 1e3) {
    p = 1e3 * std::exp(std::max((p - 1e3) / 1e3, -60.0));
    out.slope = C * 1e3 / p;
  }
  out.p = p, out.pushed = D;
  if (!(out.slope > 0)) out.slope = C;
  return out;
}

}  // namespace phs::hydraulics
