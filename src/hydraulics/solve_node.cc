#include "hydraulics/solve_node.h"

#include <algorithm>
#include <cmath>

#include "hydraulics/sequential_balance.h"

namespace phs::hydraulics {
namespace {

double OilVolume(const Node& node, double p, double ambient, double* slope) {
  const double rise = p - node.p0;
  if (node.bulk_slope == 0) {
    *slope = node.Compliance(ambient);
    return *slope * rise;
  }
  const double beta = node.bulk_modulus + node.bulk_slope * rise;
  const double oil = node.oil_volume * node.Softer(ambient);
  *slope = oil / beta;
  return oil / node.bulk_slope * std::log(beta / node.bulk_modulus);
}

// The isothermal balance in q = p - p0:  C q² + (C p0 + S/p0 - D) q - D p0 = 0, so that D = 0 gives
// exactly q = 0. `with_blow_off`: accumulators open. Temperature enters as a factor on S.
double ClosedFormRise(const Node& node, double D, double ambient, const double* state,
                      bool with_blow_off) {
  const double C = node.Compliance(ambient) + node.law_compliance;
  double S = node.air, pushed = D;
  for (const NodeGas& g : node.gases) {
    if (g.blow_off && !with_blow_off) continue;
    const double warm = GasTemperature(g, ambient, state) / g.gas.reference_temperature;
    const double pV = g.gas.reference_pressure * g.gas.reference_volume * warm;
    S += pV;
    pushed -= g.static_volume - pV / node.p0;
  }
  const double B = C * node.p0 + S / node.p0 - pushed;
  const double root = std::sqrt(std::max(B * B + 4 * C * pushed * node.p0, 0.0));
  return B > 0 ? 2 * pushed * node.p0 / (B + root) : (root - B) / (2 * C);
}

// True where the closed form is exact at p: no diaphragm on a stop that the form does not know.
bool ClosedFormHolds(const Node& node, double p, double ambient, const double* state) {
  for (const NodeGas& g : node.gases) {
    const double warm = GasTemperature(g, ambient, state) / g.gas.reference_temperature;
    const double volume = g.gas.reference_pressure * g.gas.reference_volume * warm / p;
    if (volume < g.gas.min_volume) return false;
    if (!g.blow_off && volume > g.gas.max_volume) return false;
  }
  return true;
}

bool OpensBlowOff(const Node& node, double p, double ambient, const double* state) {
  for (const NodeGas& g : node.gases) {
    if (!g.blow_off) continue;
    const double warm = GasTemperature(g, ambient, state) / g.gas.reference_temperature;
    if (p > g.gas.reference_pressure * warm) return true;
  }
  return false;
}

// Newton's method on a rising function inside a bracket that is grown first; a step that leaves the
// bracket is replaced by the geometric mean. Convergence is quadratic: a step below 1e-9 leaves an
// error at rounding.
NodeState NewtonNode(const Node& node, double D, double ambient, const double* state,
                     double guess) {
  double low = 0, high = 0;
  double p = std::max(guess, 1e-3);
  NodeState out;
  for (int i = 0; i < 200; ++i) {
    const double error = CalcAbsorbed(node, p, ambient, state, &out.slope) - D;
    if (error == 0) break;
    (error > 0 ? high : low) = p;
    double next = p - error / out.slope;
    const bool inside = next > low && (high == 0 || next < high) && std::isfinite(next);
    if (!inside) next = low == 0 ? p / 16 : (high == 0 ? p * 16 : std::sqrt(low * high));
    const double move = std::abs(next - p);
    p = next;
    if (move <= (inside ? 1e-9 : 4e-15) * p || p < 1e-12 || p > 1e15) break;
  }
  out.p = p;
  return out;
}

}  // namespace

void Node::Prepare() {
  closed_form = bulk_slope == 0 && laws.empty() && !sequential;
  size_t blow_offs = 0;
  for (const NodeGas& g : gases) {
    if (!g.gas.law->follows_boyle) closed_form = false;
    blow_offs += g.blow_off;
  }
  if (blow_offs > 1) closed_form = false;
  double volume = 0;
  law_compliance = 0;
  for (const NodeLaw& l : laws) l.law->Add(p0, 0, &volume, &law_compliance);
  real_gas = !gases.empty() && !gases[0].blow_off && gases[0].gas.law->of_density != nullptr &&
             gases.size() - blow_offs == 1 && bulk_slope == 0 && !sequential;
}

double CalcAbsorbed(const Node& node, double p, double ambient, const double* state,
                    double* slope) noexcept {
  double volume = OilVolume(node, p, ambient, slope);
  volume += node.air * (1 / node.p0 - 1 / p);
  *slope += node.air / (p * p);
  for (const NodeGas& g : node.gases) {
    const GasState at = CalcGas(g.gas, p, GasTemperature(g, ambient, state));
    volume += g.static_volume - at.volume;
    *slope -= at.dV_dp;
  }
  for (const NodeLaw& l : node.laws) l.law->Add(p, l.Memory(state), &volume, slope);
  return volume;
}

namespace {

NodeState Solve(const Node& node, double D, double ambient, const double* state,
                const NodeState* near) {
  if (node.sequential) return SolveSequential(node, D, ambient, state);
  if (near != nullptr && near->slope > 0 && !node.closed_form && !node.real_gas) {
    const double guess = near->p + (D - near->pushed) / near->slope;
    if (guess > 0.1 * near->p) return NewtonNode(node, D, ambient, state, guess);
  }
  double p = node.p0 + ClosedFormRise(node, D, ambient, state, false);
  bool open = OpensBlowOff(node, p, ambient, state);
  if (open) p = node.p0 + ClosedFormRise(node, D, ambient, state, true);
  NodeState real;
  if (node.real_gas && SolveRealGasNode(node, D, ambient, state, p, &real)) return real;
  if (!node.closed_form || !ClosedFormHolds(node, p, ambient, state)) {
    return NewtonNode(node, D, ambient, state, p);
  }
  NodeState out;
  out.p = p;
  double S = node.air;
  for (const NodeGas& g : node.gases) {
    if (g.blow_off && !open) continue;
    S += g.gas.reference_pressure * g.gas.reference_volume * GasTemperature(g, ambient, state) /
         g.gas.reference_temperature;
  }
  out.slope = node.Compliance(ambient) + S / (p * p);
  return out;
}

}  // namespace

NodeState SolveNode(const Node& node, double D, double ambient, const double* state,
                    const NodeState* near) noexcept {
  NodeState out = Solve(node, D, ambient, state, near);
  out.pushed = D;
  return out;
}

NodeState StepNode(const Node& node, double D, double ambient, const double* state,
                   const NodeState& near, double* moved) noexcept {
  constexpr double kFar = 0.1;
  *moved = 0;
  const bool solve = node.closed_form || node.real_gas || node.sequential || !(near.slope > 0);
  if (solve) return SolveNode(node, D, ambient, state, &near);
  const double guess = near.p + (D - near.pushed) / near.slope;
  if (std::abs(guess - near.p) < 0.5 * near.p) {
    NodeState out;
    const double error = CalcAbsorbed(node, guess, ambient, state, &out.slope) - D;
    const double step = -error / out.slope;
    if (std::abs(step) < kFar * guess) {
      out.p = guess + step, out.pushed = D;
      *moved = std::abs(step) / guess;
      return out;
    }
  }
  return SolveNode(node, D, ambient, state, &near);
}

double CalcNodeEnergy(const Node& node, double p, double ambient, const double* state) noexcept {
  const double rise = p - node.p0;
  double energy = 0;
  if (node.bulk_slope == 0) {
    energy = 0.5 * node.oil_volume / node.bulk_modulus * rise * (p + node.p0);
  } else {
    const double m = node.bulk_slope, beta = node.bulk_modulus;
    const double log_ratio = std::log((beta + m * rise) / beta);
    energy = node.oil_volume * (rise / m + (m * node.p0 - beta) / (m * m) * log_ratio);
  }
  energy *= node.Softer(ambient);
  energy += node.air * std::log(p / node.p0);
  for (const NodeGas& g : node.gases) {
    const double T = GasTemperature(g, ambient, state);
    const GasState at = CalcGas(g.gas, p, T);
    energy += CalcGasEnergy(g.gas, at.volume, T, ambient);
    energy += CalcWallEnergy(g.gas, WallTemperature(g, ambient, state), ambient);
  }
  for (const NodeLaw& l : node.laws) energy += l.law->Energy(p, l.Memory(state));
  return energy;
}

}  // namespace phs::hydraulics
