#include <algorithm>
#include <cmath>

#include "hydraulics/node.h"
#include "hydraulics/solve_node.h"

namespace phs::hydraulics {

bool SolveRealGasNode(const Node& node, double D, double ambient, const double* state, double guess,
                      NodeState* out) noexcept {
  const NodeGas& reservoir = node.gases[0];
  const double T = GasTemperature(reservoir, ambient, state), m = reservoir.gas.mass;
  const double least = m / reservoir.gas.max_volume;
  const double most = reservoir.gas.min_volume > 0 ? m / reservoir.gas.min_volume : 1500.0;
  if (!(T > 160 && least < most)) return false;
  double open[4] = {};
  const size_t count = std::min<size_t>(node.gases.size(), 4);
  for (size_t k = 1; k < count; ++k) {
    const NodeGas& g = node.gases[k];
    open[k] = CalcGasPressure(g.gas, g.gas.max_volume, GasTemperature(g, ambient, state));
  }
  const double C = node.Compliance(ambient);
  const double rho0 = m / reservoir.gas.reference_volume;
  double low = least, high = most;
  double rho = rho0 * guess / node.p0 * reservoir.gas.reference_temperature / T;
  rho = std::clamp(rho, low, std::min(high, 800.0));
  for (int i = 0; i < 60; ++i) {
    const GasPressure at = reservoir.gas.law->of_density(rho, T);
    const double p = at.p;
    if (!(p > 0 && at.dp_drho > 0)) return false;
    double absorbed = C * (p - node.p0) + node.air * (1 / node.p0 - 1 / p);
    double slope = C + node.air / (p * p);
    for (size_t k = 1; k < count; ++k) {
      const NodeGas& g = node.gases[k];
      if (p <= open[k]) {
        absorbed += g.static_volume - g.gas.max_volume;
        continue;
      }
      const GasState a = CalcGas(g.gas, p, GasTemperature(g, ambient, state));
      absorbed += g.static_volume - a.volume;
      slope -= a.dV_dp;
    }
    for (const NodeLaw& l : node.laws) l.law->Add(p, l.Memory(state), &absorbed, &slope);
    const double volume = m / rho, dV_drho = -volume / rho;
    absorbed += reservoir.static_volume - volume;
    const double error = absorbed - D;
    const double rise = slope * at.dp_drho - dV_drho;
    out->p = p;
    out->slope = slope - dV_drho / at.dp_drho;
    out->gas_volume = volume;
    if (error == 0) return true;
    (error > 0 ? high : low) = rho;
    const double step = error / rise;
    double next = rho - step;
    if (!(next > low && next < high)) {
      if (high - low < 1e-9 * rho) return false;  // pressed against a stop
      next = 0.5 * (low + high);
    } else if (std::abs(step) <= 1e-8 * rho) {
      // One more step of the tangent is exact to rounding.
      out->p = p - step * at.dp_drho;
      out->gas_volume = m / next;
      return true;
    }
    rho = next;
  }
  return false;
}

}  // namespace phs::hydraulics
