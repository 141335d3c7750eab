#include "hydraulics/node_rates.h"

#include <algorithm>

namespace phs::hydraulics {

double CalcNodeRates(const Node& node, const NodeState& at, double ambient, double inflow,
                     const double* state, double* rate, SlowMatrix* slow) {
  double* diagonal = slow->diagonal;
  for (const NodeLaw& l : node.laws) {
    if (l.state < 0) continue;
    const MemoryRate memory = l.law->Memory(at.p, state[l.state]);
    rate[l.state] = memory.rate;
    // The node's pressure answers to the memory: dp/dm = -V_m / S at constant oil.
    diagonal[l.state] = memory.rate_slope - memory.rate_rise * memory.volume_rise / at.slope;
    inflow -= memory.volume_rise * memory.rate;
  }
  bool any = false;
  for (const NodeGas& g : node.gases) any |= g.state >= 0;
  if (!any) return at.slope;
  GasState gas[kMostGases];
  GasHeat heat[kMostGases];
  double stiff = at.slope, driven = inflow;
  const int count = std::min<int>(static_cast<int>(node.gases.size()), kMostGases);
  for (int k = 0; k < count; ++k) {
    const NodeGas& g = node.gases[k];
    if (g.state < 0) continue;
    const double T = GasTemperature(g, ambient, state);
    gas[k] = CalcGas(g.gas, at.p, T, g.blow_off ? 0 : at.gas_volume);
    heat[k] = CalcGasHeat(g.gas, gas[k].volume, T, WallTemperature(g, ambient, state), ambient);
    if (g.wall_state >= 0) {
      rate[g.wall_state] = heat[k].wall_rate, diagonal[g.wall_state] = heat[k].wall_slope;
      slow->of_next[g.state] = heat[k].wall_taken;
    }
    const double a = 1 + heat[k].kappa * gas[k].dV_dT;
    stiff += gas[k].dV_dT * heat[k].kappa * gas[k].dV_dp / a;
    driven += gas[k].dV_dT * heat[k].relax / a;
  }
  const double p_rate = driven / stiff;
  for (int k = 0; k < count; ++k) {
    const NodeGas& g = node.gases[k];
    if (g.state < 0) continue;
    const double a = 1 + heat[k].kappa * gas[k].dV_dT;
    rate[g.state] = (heat[k].relax - heat[k].kappa * gas[k].dV_dp * p_rate) / a;
    const double coupled = -heat[k].kappa * gas[k].dV_dp * gas[k].dV_dT / (a * stiff);
    diagonal[g.state] = -(1 + coupled) / (heat[k].time * a);
    if (g.wall_state >= 0) slow->over_next[g.state] = -diagonal[g.state];
  }
  return stiff;
}

}  // namespace phs::hydraulics
