// Rates of gas temperatures and flows over a step.
//
// F: flow q = law(p_from - p_to), or with an inertance I dq/dt = p_from - p_to - drop(q);
// heat and memories by node_rates.h.
//
// Heat alone (time constants of seconds): the two-stage Rosenbrock method ROS2, second order for
// any matrix A (Verwer, Spee, Blom and Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456), A
// diagonal but for each gas and its wall, which exchange the same heat:
//   (1 - g h A) k1 = F(t, u),   (1 - g h A) k2 = F(t + h, u + h k1) - 2 k1,   u' = u + h (3 k1 +
//   k2)/2
// Flows (down to microseconds, with kinks by direction): the two-stage diagonally implicit method
// of Alexander (SIAM J. Numer. Anal. 14 (1977) 1006), second order, stiffly accurate, L-stable:
//   u1 = u + g h F(t + g h, u1),   u' = u + (1 - g) h F1 + g h F(t + h, u'),   each by Newton.
// g = 1 - 1/sqrt(2) in both.
#include <algorithm>
#include <cmath>

#include "hydraulics/node_rates.h"
#include "hydraulics/phs_impl.h"

namespace phs::hydraulics {
namespace {

constexpr double kGamma = 1 - M_SQRT1_2;

// How the paths answer to what they let pass: the slope of each law, over the pressure drop or, of
// a path with inertance, of the drop over the flow; d(p_from - p_to of k)/d(volume passed by l).
struct PathSlopes {
  double law[kMaxPaths];
  double drop[kMaxPaths][kMaxPaths];
};

// A square matrix of as many rows as there are paths.
struct PathMatrix {
  explicit PathMatrix(size_t rows) : n(rows) {}
  double& operator()(size_t i, size_t k) { return value[i][k]; }

  // Solves M x = b in place of b, by elimination with partial pivoting; M is lost.
  void Solve(double* b) {
    for (size_t k = 0; k < n; ++k) {
      size_t pivot = k;
      for (size_t i = k + 1; i < n; ++i) {
        if (std::abs(value[i][k]) > std::abs(value[pivot][k])) pivot = i;
      }
      if (pivot != k) {
        std::swap_ranges(value[k], value[k] + n, value[pivot]);
        std::swap(b[k], b[pivot]);
      }
      for (size_t i = k + 1; i < n; ++i) {
        const double share = value[i][k] / value[k][k];
        if (share == 0) continue;
        for (size_t j = k + 1; j < n; ++j) value[i][j] -= share * value[k][j];
        b[i] -= share * b[k];
      }
    }
    for (size_t i = n; i-- > 0;) {
      for (size_t j = i + 1; j < n; ++j) b[i] -= value[i][j] * b[j];
      b[i] /= value[i][i];
    }
  }

  size_t n;
  double value[kMaxPaths][kMaxPaths];
};

// Flow of a path at dp and its slope. With a flow `q` of the last iterate: linear about it where
// the law is solved by its drop, q + (dp - Drop(q))/Drop'(q).
double CalcFlow(const FlowLaw& law, double time, double dp, const double* q, double* slope) {
  if (q == nullptr || !law.SolvedByDrop()) return law.Flow(time, dp, slope);
  constexpr double kLeast = 1e3;  // [Pa s/m3] at rest without laminar resistance
  double rise;
  const double drop = law.Drop(time, *q, &rise);
  *slope = 1 / std::max(rise, kLeast);
  return *q + (dp - drop) * *slope;
}

// `heat`: what the heat of compression adds to dD/dp of the nodes.
void CalcDropSlopes(const CompiledPhs& sys, const Instant& at, const double* heat,
                    PathSlopes* slopes) {
  for (size_t k = 0; k < sys.paths.size(); ++k) {
    const Path& path = sys.paths[k];
    for (size_t l = 0; l < sys.paths.size(); ++l) {
      const Path& other = sys.paths[l];
      auto rise = [&](int node) {  // of its pressure with the volume that the other lets pass
        if (node == kOpen || (node != other.to && node != other.from)) return 0.0;
        return (node == other.to ? 1 : -1) / (at.node[node].slope + heat[node]);
      };
      slopes->drop[k][l] = rise(path.from) - rise(path.to);
    }
  }
}

// Rates of volumes passed and of flows with inertance; slopes of the laws. `flows`: those of the
// last iterate by state, or null.
void CalcPathRates(const CompiledPhs& sys, double time, const Instant& at, const double* state,
                   const double* flows, double* rate, PathSlopes* slopes) {
  for (size_t k = 0; k < sys.paths.size(); ++k) {
    const Path& path = sys.paths[k];
    const double dp = sys.Pressure(at, path.from) - sys.Pressure(at, path.to);
    double* slope = &slopes->law[k];
    if (path.flow >= 0) {
      const double flow = state[path.flow];
      rate[path.flow] = (dp - path.law->Drop(time, flow, slope)) / path.law->Inertance();
      rate[path.volume] = flow;
    } else {
      rate[path.volume] =
          CalcFlow(*path.law, time, dp, flows != nullptr ? &flows[path.volume] : nullptr, slope);
    }
  }
}

// Rates of the nodes' states, given those of the volumes passed; `heat` as above.
void CalcAllNodeRates(const CompiledPhs& sys, const Instant& at, const double* speed,
                      const double* state, double* rate, SlowMatrix* slow, double* heat) {
  double inflow[kMaxNodes] = {};
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    const CompiledCylinder& c = sys.cylinders[i];
    if (c.bore != kOpen) inflow[c.bore] -= c.bore_area * speed[i];
    if (c.rod != kOpen) inflow[c.rod] += c.rod_area * speed[i];
  }
  for (const Path& path : sys.paths) {
    if (path.from != kOpen) inflow[path.from] -= rate[path.volume];
    if (path.to != kOpen) inflow[path.to] += rate[path.volume];
  }
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    heat[n] = CalcNodeRates(sys.nodes[n], at.node[n], at.ambient, inflow[n], state, rate, slow) -
              at.node[n].slope;
  }
}

// F(t, u) at an instant, and A of the slow states.
void CalcDerivative(const CompiledPhs& sys, double time, const Instant& at, const double* speed,
                    const double* state, double* rate, SlowMatrix* slow) {
  PathSlopes slopes;
  double heat[kMaxNodes];
  CalcPathRates(sys, time, at, state, nullptr, rate, &slopes);
  CalcAllNodeRates(sys, at, speed, state, rate, slow, heat);
}

// Pistons that have moved for `since`, and what is pushed into the nodes at time t by states `u`.
void PlaceAt(const CompiledPhs& sys, double time, double since, const Instant& start,
             const double* speed, const double* u, Instant* at) {
  at->ambient = sys.Ambient(time);
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    at->piston[i] = start.piston[i] + since * speed[i];
  }
  sys.CalcPushed(u, at);
}

// One step of the pressures about `at` as it is; the largest move beyond the tangents, relative.
double StepNodes(const CompiledPhs& sys, const double* u, Instant* at) {
  double largest = 0;
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    double moved;
    at->node[n] = StepNode(sys.nodes[n], at->pushed[n], at->ambient, u, at->node[n], &moved);
    largest = std::max(largest, moved);
  }
  return largest;
}

void HeatStep(const CompiledPhs& sys, double time, double h, const Instant& start,
              const double* speed, const double* state, double* rate) {
  const int count = sys.num_states(), first = sys.first_slow;
  double k1[kMaxStates], k2[kMaxStates], next[kMaxStates];
  SlowMatrix slow(count), ignored(count);
  CalcDerivative(sys, time, start, speed, state, k1, &slow);
  slow.SolveShifted(kGamma * h, first, count, k1);
  for (int i = first; i < count; ++i) next[i] = state[i] + h * k1[i];
  std::copy(state, state + first, next);
  Instant end = start;
  PlaceAt(sys, time + h, h, start, speed, next, &end);
  sys.SolveNodes(next, &end, &end);
  CalcDerivative(sys, time + h, end, speed, next, k2, &ignored);
  for (int i = first; i < count; ++i) k2[i] -= 2 * k1[i];
  slow.SolveShifted(kGamma * h, first, count, k2);
  for (int i = first; i < count; ++i) rate[i] = 1.5 * k1[i] + 0.5 * k2[i];
}

// One Newton step of the paths of a stage: W = base + a q with the flow q of the law, or with
// inertance q = base_q + a dq/dt, both as equations for the volume W passed; the largest change
// [m3]. Flows with inertance in `u` follow from W.
double StepPaths(const CompiledPhs& sys, double a, const PathSlopes& slopes, const double* base,
                 const double* F, double* u) {
  const size_t n = sys.paths.size();
  PathMatrix M(n);
  double change[kMaxPaths];
  for (size_t k = 0; k < n; ++k) {
    const Path& path = sys.paths[k];
    double passed = a * F[path.volume], gain = a * slopes.law[k], own = 1;
    if (path.flow >= 0) {
      const double light = a / path.law->Inertance();
      passed = a * (base[path.flow] + a * F[path.flow]);
      gain = a * light, own += light * slopes.law[k];
    }
    change[k] = base[path.volume] + passed - u[path.volume];
    for (size_t l = 0; l < n; ++l) M(k, l) = (k == l ? own : 0) - gain * slopes.drop[k][l];
  }
  M.Solve(change);
  double largest = 0;
  for (size_t k = 0; k < n; ++k) {
    const Path& path = sys.paths[k];
    u[path.volume] += change[k];
    if (path.flow >= 0) u[path.flow] = (u[path.volume] - base[path.volume]) / a;
    largest = std::max(largest, std::abs(change[k]));
  }
  return largest;
}

// Solves u = base + a F(t, u) for the hydraulic states; `u` holds a guess and gets the solution,
// `F` the derivative there, `at` pressures close by and those of the solution. False if it was not
// found.
bool SolveStage(const CompiledPhs& sys, double time, double since, double a, const Instant& start,
                const double* speed, const double* base, double* u, double* F, Instant* at) {
  const int count = sys.num_states(), first = sys.first_slow;
  const int first_flow = sys.paths[0].volume;
  double flow[kMaxStates], step[kMaxStates], heat[kMaxNodes] = {};
  SlowMatrix slow(count);
  PathSlopes slopes;
  for (const Path& path : sys.paths) {
    if (path.flow >= 0) u[path.volume] = base[path.volume] + a * u[path.flow];
  }
  constexpr int kMostIterations = 30, kStepped = 8;
  constexpr double kPoor = 1e4;  // 100 Pa on a chamber, 1 mK
  double largest = 0, before = 0;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    PlaceAt(sys, time, since, start, speed, u, at);
    // Pressures and flows by one Newton's method: 1e-8 of a pressure leaves nothing.
    // Should they not meet within a few steps, each pressure is solved inside its bracket.
    largest = 0;
    if (iteration < kStepped) {
      largest = 1e8 * StepNodes(sys, u, at);
    } else {
      sys.SolveNodes(u, at, at);
    }
    for (int i = first_flow; i < count; ++i) flow[i] = (u[i] - base[i]) / a;
    CalcPathRates(sys, time, *at, u, flow, F, &slopes);
    CalcDropSlopes(sys, *at, heat, &slopes);
    // 1e-14 m3 is 0.01 Pa on a chamber.
    largest = std::max(largest, 1e14 * StepPaths(sys, a, slopes, base, F, u));
    // Heat answers to the flow as it will be: through a pipe that hardly resists, what the law
    // gives at pressures not yet settled is far off.
    for (const Path& path : sys.paths) F[path.volume] = (u[path.volume] - base[path.volume]) / a;
    CalcAllNodeRates(sys, *at, speed, u, F, &slow, heat);
    for (int i = first; i < first_flow; ++i) step[i] = base[i] + a * F[i] - u[i];
    slow.SolveShifted(a, first, first_flow, step);
    for (int i = first; i < first_flow; ++i) {
      u[i] += step[i];
      largest = std::max(largest, std::abs(step[i]) * 1e7);
    }
    // What is left is at most the share of this change that this is of the one before.
    if (largest <= 1 || (largest < before && largest * largest <= before)) break;
    before = largest;
  }
  // The derivative that the solved stage stands for.
  for (int i = first; i < count; ++i) F[i] = (u[i] - base[i]) / a;
  return largest < kPoor;
}

// One step by both stages: the mean rates over h. False if a stage was not solved.
bool TwoStages(const CompiledPhs& sys, double time, double h, const Instant& start,
               const double* speed, const double* state, double* rate) {
  const int count = sys.num_states(), first = sys.first_slow;
  const double a = kGamma * h;
  double u[kMaxStates], base[kMaxStates] = {}, F1[kMaxStates], F2[kMaxStates];
  std::copy(state, state + count, u);
  Instant at = start;
  bool solved = SolveStage(sys, time + a, a, a, start, speed, state, u, F1, &at);
  for (int i = first; i < count; ++i) {
    base[i] = state[i] + (1 - kGamma) * h * F1[i];
    u[i] = base[i] + a * F1[i];
  }
  solved = SolveStage(sys, time + h, h, a, start, speed, base, u, F2, &at) && solved;
  for (int i = first; i < count; ++i) rate[i] = (u[i] - state[i]) / h;
  return solved;
}

// Where the stages find no solution (a valve that snaps), two steps of half the length, and so on.
void FlowStep(const CompiledPhs& sys, double time, double h, const Instant& start,
              const double* speed, const double* state, double* rate, int halvings = 6) {
  if (TwoStages(sys, time, h, start, speed, state, rate) || halvings == 0) return;
  const int count = sys.num_states(), first = sys.first_slow;
  const double half = 0.5 * h;
  double middle[kMaxStates], second[kMaxStates];
  FlowStep(sys, time, half, start, speed, state, rate, halvings - 1);
  std::copy(state, state + count, middle);
  for (int i = first; i < count; ++i) middle[i] += half * rate[i];
  Instant at = start;
  PlaceAt(sys, time + half, half, start, speed, middle, &at);
  sys.SolveNodes(middle, &at);
  FlowStep(sys, time + half, half, at, speed, middle, second, halvings - 1);
  for (int i = first; i < count; ++i) rate[i] = 0.5 * (rate[i] + second[i]);
}

}  // namespace

void CalcHydraulicRates(const CompiledPhs& sys, double time, double h, const Instant& start,
                        const double* speed, const double* state, double* rate) {
  if (h > 0 && sys.paths.empty()) return HeatStep(sys, time, h, start, speed, state, rate);
  if (h > 0) return FlowStep(sys, time, h, start, speed, state, rate);
  double now[kMaxStates];
  SlowMatrix ignored(sys.num_states());
  CalcDerivative(sys, time, start, speed, state, now, &ignored);
  std::copy(now + sys.first_slow, now + sys.num_states(), rate + sys.first_slow);
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
    for (const NodeLaw& l : sys.nodes[n].laws) {
      if (l.state >= 0) lost += l.law->Loss(at.node[n].p, state[l.state]);
    }
    for (const NodeGas& g : sys.nodes[n].gases) {
      if (g.state < 0) continue;
      const double T = GasTemperature(g, at.ambient, state);
      const double volume = CalcGas(g.gas, at.node[n].p, T).volume;
      const double wall = WallTemperature(g, at.ambient, state);
      lost += CalcGasHeat(g.gas, volume, T, wall, at.ambient).loss;
    }
  }
  return lost;
}

}  // namespace phs::hydraulics
