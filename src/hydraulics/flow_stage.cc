#include "hydraulics/flow_stage.h"

#include <algorithm>
#include <cmath>

#include "hydraulics/solve_node.h"

namespace phs::hydraulics {
namespace {

constexpr double kPoor = 1e4;  // change in a stage: 100 Pa on a chamber, 1 mK

// A square matrix of as many rows as there are paths.
struct PathMatrix {
  explicit PathMatrix(size_t rows) : n(rows) {}
  double& operator()(size_t i, size_t k) { return value[i][k]; }

  // By elimination with partial pivoting, in place. Paths couple only where they share a node, so
  // most shares are zero and are left out. Eigen's PartialPivLU cannot know that: a step with
  // resistances takes 12 … 32 % longer with it, up to 12 % with sizes fixed.
  void Factor() {
    for (size_t k = 0; k < n; ++k) {
      size_t& pivot = pivots[k] = k;
      for (size_t i = k + 1; i < n; ++i) {
        if (std::abs(value[i][k]) > std::abs(value[pivot][k])) pivot = i;
      }
      if (pivot != k) std::swap_ranges(value[k], value[k] + n, value[pivot]);
      for (size_t i = k + 1; i < n; ++i) {
        const double share = value[i][k] /= value[k][k];
        if (share == 0) continue;
        for (size_t j = k + 1; j < n; ++j) value[i][j] -= share * value[k][j];
      }
    }
  }
  // Solves M x = b in place of b, once M is factored.
  void Solve(double* b) const {
    for (size_t k = 0; k < n; ++k) std::swap(b[k], b[pivots[k]]);
    for (size_t k = 0; k < n; ++k) {
      for (size_t i = k + 1; i < n; ++i) {
        if (value[i][k] != 0) b[i] -= value[i][k] * b[k];
      }
    }
    for (size_t i = n; i-- > 0;) {
      for (size_t j = i + 1; j < n; ++j) b[i] -= value[i][j] * b[j];
      b[i] /= value[i][i];
    }
  }

  size_t n;
  size_t pivots[kMaxPaths];
  double value[kMaxPaths][kMaxPaths];
};

// Flow of a path at dp and its slope. With a flow `q` of the last iterate: linear about it where
// the law is solved by its drop, q + (dp - Drop(q))/Drop'(q).
double CalcFlow(const FlowLaw& law, const FlowPlace& at, double dp, const double* q,
                double* slope) {
  const bool by_drop = q != nullptr && (law.Sticks() ? *q != 0 : law.SolvedByDrop());
  if (!by_drop) return law.Flow(at, dp, slope);
  constexpr double kLeast = 1e3;  // [Pa s/m3] at rest without laminar resistance
  double rise;
  const double drop = law.Drop(at, *q, &rise);
  *slope = 1 / std::max(rise, kLeast);
  return *q + (dp - drop) * *slope;
}

void CalcDropSlopes(const CompiledPhs& sys, const Instant& at, PathSlopes* slopes) {
  double give[kMaxNodes];  // of a node's pressure to a volume that enters
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    give[n] = 1 / (at.node[n].slope + slopes->heat[n]);
  }
  for (size_t k = 0; k < sys.paths.size(); ++k) {
    const Path& path = sys.paths[k];
    for (size_t l = 0; l < sys.paths.size(); ++l) {
      const Path& other = sys.paths[l];
      auto rise = [&](int node) {  // of its pressure with the volume that the other lets pass
        if (node == kOpen || (node != other.to && node != other.from)) return 0.0;
        return node == other.to ? give[node] : -give[node];
      };
      slopes->drop[k][l] = rise(path.from) - rise(path.to);
    }
  }
}

// One step of the pressures about `at` as it is; the largest move beyond the tangents, relative.
double StepNodes(const CompiledPhs& sys, const double* u, Instant* at) {
  double largest = 0;
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    const double moved = StepNode(sys.nodes[n], at->pushed[n], at->ambient, u, &at->node[n]);
    largest = std::max(largest, moved);
  }
  return largest;
}

// Volume W that path k passes in a stage of length a: own dW = gain d(p_from - p_to), with the flow
// q of the law or, with inertance, q = base_q + a dq/dt.
struct PathGain {
  double own = 1, gain = 0;
};

PathGain CalcGain(const Path& path, double inertance, double a, double slope, double back) {
  if (path.flow < 0) return {1 + a * back, a * slope};
  const double light = a / inertance;
  return {1 + light * slope, a * light};
}

PathMatrix CalcPathMatrix(const CompiledPhs& sys, const PathInertances& inertances, double a,
                          const PathSlopes& slopes) {
  const size_t n = sys.paths.size();
  PathMatrix M(n);
  for (size_t k = 0; k < n; ++k) {
    const PathGain g =
        CalcGain(sys.paths[k], inertances.value[k], a, slopes.law[k], slopes.back[k]);
    for (size_t l = 0; l < n; ++l) M(k, l) = (k == l ? g.own : 0) - g.gain * slopes.drop[k][l];
  }
  return M;
}

// Lags of a stage that belong to the flows in `u`: u_k = base_k + a rate (u_flow - u_k).
void FollowFlows(const CompiledPhs& sys, const StageLags& lags, const double* base, double* u) {
  for (const Path& path : sys.paths) {
    for (int k = path.lag; k < path.lag + path.num_lags; ++k) {
      u[k] = (base[k] + lags.at[k].along * u[path.flow]) * lags.at[k].keeps;
    }
  }
}

// Between which volumes what a path passes in a stage lies, as the steps from these say. Beside a
// gas that opens or closes Newton's step may lead too far from either side, and back again.
class PathBracket {
 public:
  // What has passed next after `went`, which Newton's step would change by `change`. What `sticks`
  // and would turn comes to rest first, to the last digit: what were left would be a flow, and the
  // law asked beyond its drag.
  double Next(double went, double change, bool sticks) {
    const double next = went + change;
    if (sticks && !turned_ && went * next < 0) {
      turned_ = true;
      return 0;
    }
    constexpr int kSettled = 4;  // the first steps follow what other paths and pressures do
    if (!turned_ && steps_++ < kSettled) return next;
    if (next == went) return went;  // found, while other paths go on: it is no end of its bracket
    (change > 0 ? low_ : high_) = went;
    if (next > low_ && next < high_) return next;
    return std::isfinite(low_) && std::isfinite(high_) ? 0.5 * (low_ + high_) : next;
  }

 private:
  bool turned_ = false;
  int steps_ = 0;
  double low_ = -INFINITY, high_ = INFINITY;
};

// One Newton step of the paths of a stage, as equations for the volumes passed; the largest change
// [m3]. Flows with inertance in `u` follow from these. `brackets`: of each path, in this stage.
double StepPaths(const CompiledPhs& sys, const PathInertances& inertances, double a,
                 const PathSlopes& slopes, const double* base, const double* F,
                 PathBracket* brackets, double* u) {
  const size_t n = sys.paths.size();
  double change[kMaxPaths];
  for (size_t k = 0; k < n; ++k) {
    const Path& path = sys.paths[k];
    const double passes =
        path.flow < 0 ? a * F[path.volume] : a * (base[path.flow] + a * F[path.flow]);
    change[k] = base[path.volume] + passes - u[path.volume];
  }
  PathMatrix matrix = CalcPathMatrix(sys, inertances, a, slopes);
  matrix.Factor();
  matrix.Solve(change);
  double largest = 0;
  for (size_t k = 0; k < n; ++k) {
    const Path& path = sys.paths[k];
    double& passed = u[path.volume];
    double next = passed + change[k];
    if (path.flow < 0) {
      const double went = passed - base[path.volume];
      const double kept = brackets[k].Next(went, change[k], path.law->Sticks());
      if (kept != went + change[k]) next = base[path.volume] + kept, change[k] = kept - went;
    }
    passed = next;
    if (path.flow >= 0) u[path.flow] = (u[path.volume] - base[path.volume]) / a;
    largest = std::max(largest, std::abs(change[k]));
  }
  return largest;
}

/// Whether a first change leaves nothing, as the stages before contracted. They tell less with
/// every stage that is not measured. A kink that none of them met is left at most as large as the
/// change: 100 Pa on a chamber, in one stage.
bool IsLast(double change, StageMemory* memory) {
  constexpr double kNothing = 0.1;  // 1 mPa on a chamber
  if (memory->contraction <= 0 || change > kPoor) return false;
  if (memory->contraction * change * change > kNothing) return false;
  memory->contraction *= 2;
  return true;
}

}  // namespace

PathInertances OwnInertances(const CompiledPhs& sys) {
  PathInertances own;
  for (size_t k = 0; k < sys.paths.size(); ++k) own.value[k] = sys.paths[k].law->Inertance();
  return own;
}

void CalcLags(const CompiledPhs& sys, double time, const Instant& at, double a, StageLags* lags) {
  if (lags->length == a && lags->viscosity == at.viscosity) return;
  lags->length = a, lags->viscosity = at.viscosity;
  const FlowPlace place = sys.WhereItFlows(time, at);
  for (const Path& path : sys.paths) {
    for (int k = 0; k < path.num_lags; ++k) {
      const FlowLag lag = path.law->Lag(place, k);
      const double along = a * lag.rate;
      lags->at[path.lag + k] = {lag.rate, lag.resistance, along, 1 / (1 + along)};
    }
  }
}

void CalcPathRates(const CompiledPhs& sys, const PathInertances& inertances, double time,
                   const Instant& at, const StageLags& lags, const double* speed,
                   const double* state, const double* flows, double* rate, PathSlopes* slopes) {
  FlowPlace place = sys.WhereItFlows(time, at);
  for (size_t k = 0; k < sys.paths.size(); ++k) {
    const Path& path = sys.paths[k];
    sys.SetPath(path, at, speed, state, &place);
    slopes->back[k] = 0;
    const double dp = sys.Pressure(at, path.from) - sys.Pressure(at, path.to);
    double* slope = &slopes->law[k];
    if (path.flow >= 0) {
      const double flow = state[path.flow];
      double drop = path.law->Drop(place, flow, slope);
      for (int l = path.lag; l < path.lag + path.num_lags; ++l) {
        const StageLags::Lag& lag = lags.at[l];
        const double behind = flow - state[l];
        drop += lag.resistance * behind;
        *slope += lag.resistance * lag.keeps;
        rate[l] = lag.rate * behind;
      }
      rate[path.flow] = (dp - drop) / inertances.value[k];
      rate[path.volume] = flow;
    } else {
      rate[path.volume] =
          CalcFlow(*path.law, place, dp, flows != nullptr ? &flows[path.volume] : nullptr, slope);
      slopes->back[k] = path.law->Return(place, dp);
    }
  }
}

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

void MoveTo(const CompiledPhs& sys, double time, const double* way, const Instant& start,
            Instant* at) {
  sys.SetWarmth(time, at);
  for (size_t i = 0; i < sys.cylinders.size(); ++i) at->piston[i] = start.piston[i] + way[i];
}

bool SolveStage(const CompiledPhs& sys, const PathInertances& inertances, double time, double a,
                const Instant& start, const StageMotion& motion, const double* base, double* u,
                double* F, Instant* at, StageLags* lags, StageMemory* memory, PathSlopes* found) {
  const int count = sys.num_states(), first = sys.first_slow;
  const int first_flow = sys.paths[0].volume;
  double flow[kMaxStates], step[kMaxStates];
  SlowMatrix slow(count);
  PathSlopes own;
  PathSlopes& slopes = found != nullptr ? *found : own;
  std::fill(slopes.heat, slopes.heat + sys.nodes.size(), 0.0);
  for (const Path& path : sys.paths) {
    if (path.flow >= 0) u[path.volume] = base[path.volume] + a * u[path.flow];
  }
  constexpr int kMostIterations = 30, kStepped = 8;
  double largest = 0, before = 0;
  PathBracket brackets[kMaxPaths];
  double displaced[kMaxNodes];
  MoveTo(sys, time, motion.way, start, at);
  sys.CalcDisplaced(*at, displaced);
  CalcLags(sys, time, *at, a, lags);
  FollowFlows(sys, *lags, base, u);
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    std::copy(displaced, displaced + sys.nodes.size(), at->pushed);
    sys.AddPassed(u, at->pushed);
    // Pressures and flows by one Newton's method: 1e-8 of a pressure leaves nothing.
    // Should they not meet within a few steps, each pressure is solved inside its bracket.
    largest = 0;
    if (iteration < kStepped) {
      largest = 1e8 * StepNodes(sys, u, at);
    } else {
      sys.SolveNodes(u, at, at);
    }
    for (int i = first_flow; i < count; ++i) flow[i] = (u[i] - base[i]) / a;
    CalcPathRates(sys, inertances, time, *at, *lags, motion.speed, u, flow, F, &slopes);
    CalcDropSlopes(sys, *at, &slopes);
    // 1e-14 m3 is 0.01 Pa on a chamber.
    largest = std::max(largest, 1e14 * StepPaths(sys, inertances, a, slopes, base, F, brackets, u));
    FollowFlows(sys, *lags, base, u);
    // Heat answers to the flow as it will be: through a pipe that hardly resists, what the law
    // gives at pressures not yet settled is far off.
    for (const Path& path : sys.paths) F[path.volume] = (u[path.volume] - base[path.volume]) / a;
    if (first < first_flow) CalcAllNodeRates(sys, *at, motion.speed, u, F, &slow, slopes.heat);
    for (int i = first; i < first_flow; ++i) step[i] = base[i] + a * F[i] - u[i];
    slow.SolveShifted(a, first, first_flow, step);
    for (int i = first; i < first_flow; ++i) {
      u[i] += step[i];
      largest = std::max(largest, std::abs(step[i]) * 1e7);
    }
    if (iteration == 1) memory->contraction = largest / (before * before);
    if (largest <= 1) break;
    if (iteration == 0 && IsLast(largest, memory)) break;
    // What is left is at most the share of this change that this is of the one before.
    if (largest < before && largest * largest <= before) break;
    before = largest;
  }
  // The derivative that the solved stage stands for.
  for (int i = first; i < count; ++i) F[i] = (u[i] - base[i]) / a;
  return largest < kPoor;
}

void CalcStageStiffness(const CompiledPhs& sys, const PathInertances& inertances, double a,
                        const Instant& at, const PathSlopes& slopes, const int* moved, int count,
                        double (*of_each)[kMaxCylinders]) {
  PathMatrix matrix = CalcPathMatrix(sys, inertances, a, slopes);
  matrix.Factor();
  const auto give = [&](int node) { return 1 / (at.node[node].slope + slopes.heat[node]); };
  for (int m = 0; m < count; ++m) {
    const CompiledCylinder& c = sys.cylinders[moved[m]];
    double rise[kMaxNodes] = {};  // of each node's pressure with the way, no flow answering
    if (c.bore != kOpen) rise[c.bore] -= c.bore_area * give(c.bore);
    if (c.rod != kOpen) rise[c.rod] += c.rod_area * give(c.rod);
    double passed[kMaxPaths] = {};
    for (size_t k = 0; k < sys.paths.size(); ++k) {
      const Path& path = sys.paths[k];
      const double from = path.from == kOpen ? 0 : rise[path.from];
      const double to = path.to == kOpen ? 0 : rise[path.to];
      passed[k] =
          (from - to) * CalcGain(path, inertances.value[k], a, slopes.law[k], slopes.back[k]).gain;
    }
    matrix.Solve(passed);
    for (size_t k = 0; k < sys.paths.size(); ++k) {
      const Path& path = sys.paths[k];
      if (path.from != kOpen) rise[path.from] -= passed[k] * give(path.from);
      if (path.to != kOpen) rise[path.to] += passed[k] * give(path.to);
    }
    for (size_t i = 0; i < sys.cylinders.size(); ++i) {
      const CompiledCylinder& other = sys.cylinders[i];
      of_each[m][i] = (other.rod == kOpen ? 0 : rise[other.rod] * other.rod_area) -
                      (other.bore == kOpen ? 0 : rise[other.bore] * other.bore_area);
    }
  }
}

}  // namespace phs::hydraulics
