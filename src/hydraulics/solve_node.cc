#include "hydraulics/solve_node.h"

#include <algorithm>
#include <cmath>

#include "hydraulics/sequential_balance.h"

namespace phs::hydraulics {
namespace {

double OilVolume(const Node& node, double p, double ambient, double* slope) {
  const double rise = p - node.p0;
  if (node.oil.IsConstant()) {
    *slope = node.Compliance(ambient);
    return *slope * rise;
  }
  const double oil = node.oil_volume * node.Softer(ambient);
  const double volume = oil * node.oil.Volume(rise, slope);
  *slope *= oil;
  return volume;
}

// p V = p0 V0 T/T0 of a gas at its temperature.
struct BoyleGas {
  double pV = 0;     // [J]
  double at_p0 = 0;  // its volume at the node's static pressure [m3]
};

BoyleGas CalcBoyle(const NodeGas& g, double ambient, const double* state) {
  const double T = GasTemperature(g, ambient, state);
  if (T == g.gas.reference_temperature) return {g.boyle, g.boyle_at_p0};
  const double warm = T / g.gas.reference_temperature;
  return {warm * g.boyle, warm * g.boyle_at_p0};
}

struct BoyleState {
  double p = 0;       // [Pa]
  double pV = 0;      // of the air and of all gases that give way at p [J]
  bool holds = true;  // exact at p: no diaphragm on a stop that the form does not know
};

// The isothermal balance in q = p - p0:  C q² + (C p0 + V - D) q - D p0 = 0, so that D = 0 gives
// exactly q = 0. V: sum p V/p0, what air and gases hold at p0; D less their static volumes beyond
// that. Temperature enters as a factor on p V.
double ClosedFormRise(double p0, double compliance, double at_p0, double pushed) {
  const double B = compliance * p0 + at_p0 - pushed;
  const double root = std::sqrt(std::max(B * B + 4 * compliance * pushed * p0, 0.0));
  return B > 0 ? 2 * pushed * p0 / (B + root) : (root - B) / (2 * compliance);
}

// The isothermal balance solved: an accumulator is open if the pressure without it would open it.
// `gas`: p V of a gas as it is (BoyleGas).
template <typename Gas>
BoyleState Balance(const Node& node, double D, double compliance, const Gas& gas) {
  double pV = node.air, at_p0 = node.air_at_p0, pushed = D;
  const auto take = [&](bool blow_off) {
    for (const NodeGas& g : node.gases) {
      if (g.blow_off != blow_off) continue;
      const BoyleGas now = gas(g);
      pV += now.pV, at_p0 += now.at_p0, pushed += now.at_p0 - g.static_volume;
    }
  };
  take(false);
  double p = node.p0 + ClosedFormRise(node.p0, compliance, at_p0, pushed);
  bool opens = false;
  for (const NodeGas& g : node.gases) {
    opens |= g.blow_off && p * g.gas.reference_volume > gas(g).pV;
  }
  if (opens) {
    take(true);
    p = node.p0 + ClosedFormRise(node.p0, compliance, at_p0, pushed);
  }
  bool holds = true;
  for (const NodeGas& g : node.gases) {
    const double now = gas(g).pV;
    if (now < g.gas.min_volume * p) holds = false;
    if (!g.blow_off && now > g.gas.max_volume * p) holds = false;
  }
  return {p, pV, holds};
}

BoyleState SolveBoyle(const Node& node, double D, double ambient, const double* state) {
  if (node.plain && ambient == node.temperature) {
    return Balance(node, D, node.oil_compliance, [](const NodeGas& g) {
      return BoyleGas{g.boyle, g.boyle_at_p0};
    });
  }
  return Balance(node, D, node.Compliance(ambient) + node.law_compliance,
                 [&](const NodeGas& g) { return CalcBoyle(g, ambient, state); });
}

// Newton's method on a rising function inside a bracket that is grown first; a step that leaves the
// bracket is replaced by the geometric mean. Convergence is quadratic: a step below 1e-7 leaves an
// error at rounding. (There the end of a step may well be the end of the bracket.)
NodeState NewtonNode(const Node& node, double D, double ambient, const double* state,
                     double guess) {
  double low = 0, high = 0;
  double p = std::max(guess, 1e-3);
  NodeState out;
  for (int i = 0; i < 200; ++i) {
    const double error = CalcAbsorbed(node, p, ambient, state, &out.slope) - D;
    double next = p - error / out.slope;
    if (std::abs(next - p) <= 1e-7 * p) {
      p = next;
      break;
    }
    (error > 0 ? high : low) = p;
    const bool inside = next > low && (high == 0 || next < high) && std::isfinite(next);
    if (!inside) next = low == 0 ? p / 16 : (high == 0 ? p * 16 : std::sqrt(low * high));
    const double move = std::abs(next - p);
    p = next;
    if (move <= 4e-15 * p || p < 1e-12 || p > 1e15) break;
  }
  out.p = p, out.pushed = D;
  return out;
}

}  // namespace

void Node::Prepare() {
  closed_form = oil.IsConstant() && laws.empty() && !sequential;
  size_t blow_offs = 0;
  for (const NodeGas& g : gases) {
    if (!g.gas.law->follows_boyle) closed_form = false;
    blow_offs += g.blow_off;
  }
  if (blow_offs > 1) closed_form = false;
  plain = closed_form && std::all_of(gases.begin(), gases.end(), [&](const NodeGas& g) {
            return g.state < 0 && g.gas.reference_temperature == temperature;
          });
  oil_compliance = oil_volume / oil.modulus;
  double volume = 0;
  law_compliance = 0;
  for (const NodeLaw& l : laws) l.law->Add(p0, 0, &volume, &law_compliance);
  for (NodeGas& g : gases) {
    g.boyle = g.gas.reference_pressure * g.gas.reference_volume;
    g.boyle_at_p0 = g.boyle / p0;
  }
  air_at_p0 = air / p0;
  real_gas = !gases.empty() && !gases[0].blow_off && gases[0].gas.law->of_density != nullptr &&
             gases.size() - blow_offs == 1 && oil.IsConstant() && !sequential;
}

double CalcAbsorbed(const Node& node, double p, double ambient, const double* state,
                    double* slope) noexcept {
  double volume = OilVolume(node, p, ambient, slope);
  volume += node.air_at_p0 - node.air / p;
  *slope += node.air / (p * p);
  for (const NodeGas& g : node.gases) {
    const GasState at = CalcGas(g.gas, p, GasTemperature(g, ambient, state));
    volume += g.static_volume - at.volume;
    *slope -= at.dV_dp;
  }
  for (const NodeLaw& l : node.laws) l.law->Add(p, l.Memory(state), &volume, slope);
  return volume;
}

void SolveNodeAt(const Node& node, double D, double ambient, const double* state,
                 NodeState* at) noexcept {
  if (node.sequential) {
    *at = SolveSequential(node, D, ambient, state);
    return;
  }
  if (at->slope > 0 && !node.closed_form && !node.real_gas) {
    const double guess = at->p + (D - at->pushed) / at->slope;
    if (guess > 0.1 * at->p) {
      *at = NewtonNode(node, D, ambient, state, guess);
      return;
    }
  }
  const BoyleState boyle = SolveBoyle(node, D, ambient, state);
  at->pushed = D, at->gas_volume = 0;
  if (node.real_gas && SolveRealGasNode(node, D, ambient, state, boyle.p, at)) return;
  if (!node.closed_form || !boyle.holds) {
    *at = NewtonNode(node, D, ambient, state, boyle.p);
    return;
  }
  at->p = boyle.p;
  at->slope = node.Compliance(ambient) + boyle.pV / (boyle.p * boyle.p);
}

NodeState SolveNode(const Node& node, double D, double ambient, const double* state,
                    const NodeState* near) noexcept {
  NodeState at = near != nullptr ? *near : NodeState{};
  SolveNodeAt(node, D, ambient, state, &at);
  return at;
}

double StepNode(const Node& node, double D, double ambient, const double* state,
                NodeState* at) noexcept {
  constexpr double kFar = 0.1;
  if (!node.closed_form && !node.real_gas && !node.sequential && at->slope > 0) {
    const double guess = at->p + (D - at->pushed) / at->slope;
    if (std::abs(guess - at->p) < 0.5 * at->p) {
      double slope;
      const double error = CalcAbsorbed(node, guess, ambient, state, &slope) - D;
      const double step = -error / slope;
      if (std::abs(step) < kFar * guess) {
        at->p = guess + step, at->slope = slope, at->pushed = D, at->gas_volume = 0;
        return std::abs(step) / guess;
      }
    }
  }
  SolveNodeAt(node, D, ambient, state, at);
  return 0;
}

double CalcNodeEnergy(const Node& node, double p, double ambient, const double* state) noexcept {
  double energy = node.Softer(ambient) * node.oil_volume * node.oil.Energy(node.p0, p - node.p0);
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
