// Rates of gas temperatures and flows. One step of the two-stage Rosenbrock method ROS2 (Verwer,
// Spee, Blom and Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456), second order for any matrix A:
//   (I - g h A) k1 = F(t, u),   (I - g h A) k2 = F(t + h, u + h k1) - 2 k1,   u' = u + h (3 k1 +
//   k2)/2
// g = 1 - 1/sqrt(2) where the step resolves the flows (small error), 1 + 1/sqrt(2) where it does
// not (its first stage stays inside the solution): L-stable both.
//
// F: flow q = law(p_from - p_to), or with an inertance I dq/dt = p_from - p_to - drop(q);
// gas heat balance dT/dt = relax - kappa dV/dt with dV/dt = V_p dp/dt + V_T dT/dt, and the volume
// balance of the node S dp/dt - sum V_T dT/dt = dD/dt solved for dp/dt.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hydraulics/phs_impl.h"

namespace phs::hydraulics {
namespace {

constexpr int kMaxFlow = 2 * kMaxPaths;
using Matrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxFlow, kMaxFlow>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxFlow, 1>;

// Heat balances of one node; `inflow` = dD/dt. Writes rates and the diagonal of A.
void CalcGasRates(const Node& node, const NodeState& at, double ambient, double inflow,
                  const double* state, double* rate, double* diagonal) {
  bool any = false;
  for (const NodeGas& g : node.gases) any |= g.state >= 0;
  if (!any) return;
  constexpr int kMost = 4;
  GasState gas[kMost];
  GasHeat heat[kMost];
  double stiff = at.slope, driven = inflow;
  const int count = std::min<int>(static_cast<int>(node.gases.size()), kMost);
  for (int k = 0; k < count; ++k) {
    const NodeGas& g = node.gases[k];
    if (g.state < 0) continue;
    const double T = GasTemperature(g, ambient, state);
    gas[k] = CalcGas(g.gas, at.p, T);
    heat[k] = CalcGasHeat(g.gas, gas[k].volume, T, ambient);
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
    diagonal[g.state] = -1 / (g.gas.thermal_time * a);
  }
}

// F(t, u) at an instant, and A: diagonal for the gases, the matrix for the flows.
void CalcDerivative(const CompiledPhs& sys, double time, const Instant& at, const double* speed,
                    const double* state, double* rate, double* diagonal, Matrix* A) {
  double inflow[kMaxNodes] = {};
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    const CompiledCylinder& c = sys.cylinders[i];
    if (c.bore != kOpen) inflow[c.bore] -= c.bore_area * speed[i];
    if (c.rod != kOpen) inflow[c.rod] += c.rod_area * speed[i];
  }
  const int first_flow = sys.paths.empty() ? 0 : sys.paths[0].volume;
  if (A != nullptr) A->setZero();
  for (const Path& path : sys.paths) {
    const double dp = sys.Pressure(at, path.from) - sys.Pressure(at, path.to);
    double flow, slope = 0;
    if (path.flow >= 0) {
      flow = state[path.flow];
      const double drop = path.law->Drop(time, flow, &slope);
      rate[path.flow] = (dp - drop) / path.law->Inertance();
    } else {
      flow = path.law->Flow(time, dp, &slope);
    }
    rate[path.volume] = flow;
    if (path.from != kOpen) inflow[path.from] -= flow;
    if (path.to != kOpen) inflow[path.to] += flow;
    if (A == nullptr) continue;
    const int row = (path.flow >= 0 ? path.flow : path.volume) - first_flow;
    const double gain = path.flow >= 0 ? 1 / path.law->Inertance() : slope;
    for (const Path& other : sys.paths) {
      double dp_dW = 0;
      auto add = [&](int node, double side) {
        if (node == kOpen) return;
        const double moved = (node == other.to ? 1.0 : 0.0) - (node == other.from ? 1.0 : 0.0);
        dp_dW += side * moved / at.node[node].slope;
      };
      add(path.from, 1);
      add(path.to, -1);
      (*A)(row, other.volume - first_flow) = gain * dp_dW;
    }
    if (path.flow >= 0) {
      (*A)(row, row) -= slope * gain;
      (*A)(path.volume - first_flow, row) = 1;
    }
  }
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    CalcGasRates(sys.nodes[n], at.node[n], at.ambient, inflow[n], state, rate, diagonal);
  }
}

}  // namespace

void CalcHydraulicRates(const CompiledPhs& sys, double time, double h, const Instant& start,
                        const double* speed, const double* state, double* rate) {
  const int count = sys.num_states(), first = sys.first_slow;
  const int first_flow = sys.paths.empty() ? count : sys.paths[0].volume;
  const int flows = count - first_flow;
  double k1[kMaxStates], k2[kMaxStates], diagonal[kMaxStates] = {};
  Matrix A(flows, flows);
  CalcDerivative(sys, time, start, speed, state, k1, diagonal, flows > 0 ? &A : nullptr);
  if (!(h > 0)) {
    std::copy(k1 + first, k1 + count, rate + first);
    return;
  }
  double fastest = 0;
  for (int i = 0; i < flows; ++i) fastest = std::max(fastest, A.row(i).cwiseAbs().sum());
  const double g = 1 + (h * fastest > 4 ? M_SQRT1_2 : -M_SQRT1_2);
  Eigen::PartialPivLU<Matrix> solver;
  if (flows > 0) solver.compute(Matrix::Identity(flows, flows) - g * h * A);
  auto solve = [&](double* k) {
    for (int i = first; i < first_flow; ++i) k[i] /= 1 - g * h * diagonal[i];
    if (flows == 0) return;
    Eigen::Map<Eigen::VectorXd> map(k + first_flow, flows);
    const Vector right = map;
    map = solver.solve(right);
  };
  solve(k1);

  double next[kMaxStates];
  std::copy(state, state + first, next);
  for (int i = first; i < count; ++i) next[i] = state[i] + h * k1[i];
  Instant end;
  end.ambient = sys.Ambient(time + h);
  for (size_t i = 0; i < sys.cylinders.size(); ++i) end.piston[i] = start.piston[i] + h * speed[i];
  sys.CalcPushed(next, &end);
  sys.SolveNodes(next, &end);
  double ignored[kMaxStates];
  CalcDerivative(sys, time + h, end, speed, next, k2, ignored, nullptr);
  for (int i = first; i < count; ++i) k2[i] -= 2 * k1[i];
  solve(k2);
  for (int i = first; i < count; ++i) rate[i] = 1.5 * k1[i] + 0.5 * k2[i];
}

double CalcPathEnergy(const CompiledPhs& sys, const double* state) {
  double energy = 0;
  for (const Path& path : sys.paths) {
    if (path.flow >= 0) {
      energy += 0.5 * path.law->Inertance() * state[path.flow] * state[path.flow];
    }
    if (path.to == kOpen) energy += kAtmosphere * state[path.volume];
    if (path.from == kOpen) energy -= kAtmosphere * state[path.volume];
  }
  return energy;
}

double CalcHydraulicLoss(const CompiledPhs& sys, double time, const Instant& at,
                         const double* state) {
  double lost = 0, slope;
  for (const Path& path : sys.paths) {
    const double dp = sys.Pressure(at, path.from) - sys.Pressure(at, path.to);
    lost += path.flow >= 0 ? path.law->Drop(time, state[path.flow], &slope) * state[path.flow]
                           : path.law->Flow(time, dp, &slope) * dp;
  }
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    for (const NodeGas& g : sys.nodes[n].gases) {
      if (g.state < 0) continue;
      const double T = GasTemperature(g, at.ambient, state);
      const double volume = CalcGas(g.gas, at.node[n].p, T).volume;
      lost += CalcGasHeat(g.gas, volume, T, at.ambient).loss;
    }
  }
  return lost;
}

}  // namespace phs::hydraulics
