// Rates of gas temperatures and flows over a step.
//
// F: flow q = law(p_from - p_to), or with an inertance I dq/dt = p_from - p_to - drop(q), less what
// the lags of the flow hold back (oil_laws.h);
// heat and memories by node_rates.h.
//
// Heat alone (time constants of seconds): the two-stage Rosenbrock method ROS2, second order for
// any matrix A (Verwer, Spee, Blom and Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456), A
// diagonal but for each gas and its wall, which exchange the same heat:
//   (1 - g h A) k1 = F(t, u),   (1 - g h A) k2 = F(t + h, u + h k1) - 2 k1,
//   u' = u + h (3 k1 + k2)/2
// Flows (down to microseconds, with kinks by direction): the two-stage diagonally implicit method
// of Alexander (SIAM J. Numer. Anal. 14 (1977) 1006), second order, stiffly accurate, L-stable:
//   u1 = u + g h F(t + g h, u1),   u' = u + (1 - g) h F1 + g h F(t + h, u'),   each by Newton.
// g = 1 - 1/sqrt(2) in both.
// Where a gas that has a temperature comes to its stop or leaves it (a blow-off accumulator opens),
// the heat of its compression begins or ends within the step, and what the step makes wrong there
// stays in the gas for its time constant: such a step is halved until the instant is known to a 32nd
// of it.
// A column of oil of inertance I between chambers that stiffen it by K = dp/dV would ring slower by
// c w², w = h sqrt(K/I) [rad] per step, through these stages: their R(z) = (1 + (1 - 2 g) z)/(1 - g
// z)² is e^z + c z³ + …, c = 3 g² - 2 g³ - 1/6 = 0.0404. A step takes I/(1 + 2 c w²), which rings
// at the frequency of I to 0.03 % at w = 0.6 and to 0.5 % at 1.2, instead of 1.4 % and 5.2 %.
// Pistons move with a speed that is linear over a step, given by its mean and its end. What they
// push is integrated by the same stages: v1 = (mean - g end)/(1 - g), which is the speed at t + g
// h, and `end`; the end of the way is exact. Oil that hardly yields then flows at the end of a step
// with the speed there (with the mean speed in both stages it would lag by half a step).
#include <algorithm>
#include <cmath>

#include "hydraulics/flow_stage.h"

namespace phs::hydraulics {
namespace {

constexpr double kGamma = 1 - M_SQRT1_2;

// F(t, u) at an instant, and A of the slow states.
void CalcDerivative(const CompiledPhs& sys, double time, const Instant& at, const double* speed,
                    const double* state, double* rate, SlowMatrix* slow) {
  PathSlopes slopes;
  StageLags lags;
  CalcLags(sys, time, at, 0, &lags);
  CalcPathRates(sys, OwnInertances(sys), time, at, lags, speed, state, nullptr, rate, &slopes);
  CalcAllNodeRates(sys, at, speed, state, rate, slow, slopes.heat);
}

/// Whether all that a step changes are flows with inertance: nothing then goes on as it does now.
bool AllRings(const CompiledPhs& sys) {
  return sys.first_slow == sys.paths[0].volume &&
         std::all_of(sys.paths.begin(), sys.paths.end(), [](const Path& p) { return p.flow >= 0; });
}

// The inertances with which the columns of oil ring at their own frequencies in steps of h.
PathInertances RingingInertances(const CompiledPhs& sys, double h, const Instant& start) {
  constexpr double kSlower = 2 * (kGamma * kGamma * (3 - 2 * kGamma) - 1.0 / 6);
  constexpr double kFollowed = 2.5;  // [rad] per step: what rings faster is damped away
  PathInertances out = OwnInertances(sys);
  for (size_t k = 0; k < sys.paths.size(); ++k) {
    if (sys.paths[k].flow < 0) continue;
    double stiffness = 0;  // [Pa/m3]
    for (int end : {sys.paths[k].from, sys.paths[k].to}) {
      if (end != kOpen) stiffness += 1 / start.node[end].slope;
    }
    const double square = h * h * stiffness / out.value[k];
    const double far = square / (kFollowed * kFollowed), faded = 1 + far * far * far;
    out.value[k] /= 1 + kSlower * square / faded;
  }
  return out;
}

// The stage at t + g h of a step h.
StageMotion FirstStage(const CompiledPhs& sys, double h, const StepSpeeds& speeds) {
  StageMotion out;
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    out.speed[i] = (speeds.mean[i] - kGamma * speeds.end[i]) / (1 - kGamma);
    out.way[i] = kGamma * h * out.speed[i];
  }
  return out;
}

StageMotion LastStage(const CompiledPhs& sys, double h, const StepSpeeds& speeds) {
  StageMotion out;
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    out.speed[i] = speeds.end[i], out.way[i] = h * speeds.mean[i];
  }
  return out;
}

// True if a gas with a temperature of its own is at its stop at one of two instants alone.
bool ComesToAStop(const CompiledPhs& sys, const Instant& start, const double* state,
                  const Instant& end, const double* next) {
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    for (const NodeGas& g : sys.nodes[n].gases) {
      if (g.state < 0) continue;
      const auto stopped = [&](const Instant& at, const double* u) {
        return CalcGas(g.gas, at.node[n].p, GasTemperature(g, at.ambient, u)).stopped;
      };
      if (stopped(start, state) != stopped(end, next)) return true;
    }
  }
  return false;
}

enum class Stepped { kDone, kAcrossAStop, kUnsolved };

Stepped HeatStep(const CompiledPhs& sys, double time, double h, const Instant& start,
                 const StepSpeeds& speeds, const double* state, double* rate) {
  const int count = sys.num_states(), first = sys.first_slow;
  double way[kMaxCylinders];
  for (size_t i = 0; i < sys.cylinders.size(); ++i) way[i] = h * speeds.mean[i];
  double k1[kMaxStates], k2[kMaxStates], next[kMaxStates];
  SlowMatrix slow(count), ignored(count);
  CalcDerivative(sys, time, start, speeds.mean, state, k1, &slow);
  slow.SolveShifted(kGamma * h, first, count, k1);
  for (int i = first; i < count; ++i) next[i] = state[i] + h * k1[i];
  std::copy(state, state + first, next);
  Instant end = start;
  MoveTo(sys, time + h, way, start, &end);
  sys.CalcPushed(next, &end);
  sys.SolveNodes(next, &end, &end);
  CalcDerivative(sys, time + h, end, speeds.mean, next, k2, &ignored);
  for (int i = first; i < count; ++i) k2[i] -= 2 * k1[i];
  slow.SolveShifted(kGamma * h, first, count, k2);
  for (int i = first; i < count; ++i) rate[i] = 1.5 * k1[i] + 0.5 * k2[i];
  return ComesToAStop(sys, start, state, end, next) ? Stepped::kAcrossAStop : Stepped::kDone;
}

// One step by both stages: the mean rates over h.
Stepped TwoStages(const CompiledPhs& sys, double time, double h, const Instant& start,
                  const StepSpeeds& speeds, const double* state, StageMemory* memory,
                  double* rate) {
  const int count = sys.num_states(), first = sys.first_slow;
  const double a = kGamma * h;
  double u[kMaxStates], base[kMaxStates], F1[kMaxStates], F2[kMaxStates];
  std::fill(base, base + first, 0.0);
  // First guess: what flows and warms now goes on; flows with inertance may change within less.
  SlowMatrix ignored(count);
  if (!AllRings(sys)) CalcDerivative(sys, time, start, speeds.mean, state, F1, &ignored);
  std::copy(state, state + count, u);
  for (int i = first; i < sys.paths[0].volume; ++i) u[i] += a * F1[i];
  for (const Path& path : sys.paths) {
    if (path.flow < 0) u[path.volume] += a * F1[path.volume];
  }
  Instant at = start;
  StageLags lags;
  const PathInertances inertances = RingingInertances(sys, h, start);
  bool solved = SolveStage(sys, inertances, time + a, a, start, FirstStage(sys, h, speeds), state,
                           u, F1, &at, &lags, memory);
  for (int i = first; i < count; ++i) {
    base[i] = state[i] + (1 - kGamma) * h * F1[i];
    u[i] = base[i] + a * F1[i];
  }
  solved = SolveStage(sys, inertances, time + h, a, start, LastStage(sys, h, speeds), base, u, F2,
                      &at, &lags, memory) &&
           solved;
  for (int i = first; i < count; ++i) rate[i] = (u[i] - state[i]) / h;
  if (!solved) return Stepped::kUnsolved;
  return ComesToAStop(sys, start, state, at, u) ? Stepped::kAcrossAStop : Stepped::kDone;
}

// Where the stages find no solution (a valve that snaps), or a gas comes to its stop, two steps of
// half the length, and so on.
void Step(const CompiledPhs& sys, double time, double h, const Instant& start,
          const StepSpeeds& speeds, const double* state, StageMemory* memory, double* rate,
          int halved = 0) {
  constexpr int kMostUnsolved = 6, kMostAcross = 5;
  const Stepped done = sys.paths.empty()
                           ? HeatStep(sys, time, h, start, speeds, state, rate)
                           : TwoStages(sys, time, h, start, speeds, state, memory, rate);
  if (done == Stepped::kDone) return;
  if (halved >= (done == Stepped::kUnsolved ? kMostUnsolved : kMostAcross)) return;
  const int count = sys.num_states(), first = sys.first_slow;
  const double half = 0.5 * h;
  double middle[kMaxStates] = {}, second[kMaxStates];
  double early[kMaxCylinders] = {}, late[kMaxCylinders] = {}, way[kMaxCylinders] = {};
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    const double by = 0.5 * (speeds.end[i] - speeds.mean[i]);
    early[i] = speeds.mean[i] - by, late[i] = speeds.mean[i] + by, way[i] = half * early[i];
  }
  Step(sys, time, half, start, {early, speeds.mean}, state, memory, rate, halved + 1);
  std::copy(state, state + count, middle);
  for (int i = first; i < count; ++i) middle[i] += half * rate[i];
  Instant at = start;
  MoveTo(sys, time + half, way, start, &at);
  sys.CalcPushed(middle, &at);
  sys.SolveNodes(middle, &at);
  Step(sys, time + half, half, at, {late, speeds.end}, middle, memory, second, halved + 1);
  for (int i = first; i < count; ++i) rate[i] = 0.5 * (rate[i] + second[i]);
}

}  // namespace

void CalcHydraulicRates(const CompiledPhs& sys, double time, double h, const Instant& start,
                        const StepSpeeds& speeds, const double* state, StageMemory* memory,
                        double* rate) {
  if (h > 0) return Step(sys, time, h, start, speeds, state, memory, rate);
  double now[kMaxStates];
  SlowMatrix ignored(sys.num_states());
  CalcDerivative(sys, time, start, speeds.mean, state, now, &ignored);
  std::copy(now + sys.first_slow, now + sys.num_states(), rate + sys.first_slow);
}

double CalcPathEnergy(const CompiledPhs& sys, const double* state) {
  double energy = 0;
  for (const Path& path : sys.paths) {
    if (path.flow >= 0) {
      energy += 0.5 * path.law->Inertance() * state[path.flow] * state[path.flow];
    }
    for (int k = 0; k < path.num_lags; ++k) {
      const FlowLag lag = path.law->Lag({}, k);
      energy += 0.5 * lag.resistance / lag.rate * std::pow(state[path.lag + k], 2);
    }
    energy += path.law->Stored(state[path.volume]);
    if (path.to == kOpen) energy += kAtmosphere * state[path.volume];
    if (path.from == kOpen) energy -= kAtmosphere * state[path.volume];
  }
  return energy;
}

double CalcHydraulicLoss(const CompiledPhs& sys, double time, const Instant& at,
                         const double* state) {
  FlowPlace place = sys.WhereItFlows(time, at);
  double lost = 0, slope;
  for (const Path& path : sys.paths) {
    const double dp = sys.Pressure(at, path.from) - sys.Pressure(at, path.to);
    sys.SetPath(path, at, nullptr, state, &place);
    lost += path.flow >= 0
                ? path.law->Drop(place, state[path.flow], &slope) * state[path.flow]
                : path.law->Flow(place, dp, &slope) * (dp - path.law->Held(place.passed));
    for (int k = 0; k < path.num_lags; ++k) {
      const double behind = state[path.flow] - state[path.lag + k];
      lost += path.law->Lag(place, k).resistance * behind * behind;
    }
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
