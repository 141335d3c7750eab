// Chambers and reservoirs behind a resistance at rest with their lines (PhsSystem::SettleChambers).
//
// With one pressure p in all parts of a line, part k takes up D_k(p) (node.h). Their sum is what the
// pistons and other flows have pushed into the line, D; the volume that goes out of chamber k through
// its split is what was pushed into it less D_k(p), into a reservoir D_k(p) goes. The line itself is
// solved as ever:
//
//   p = p_line(D - sum of D_k(p) of its parts)
//
// whose right side falls with p: one root.
#include <algorithm>
#include <cmath>

#include "base/rising_root.h"
#include "hydraulics/phs_system_impl.h"
#include "hydraulics/solve_node.h"

namespace phs::hydraulics {
namespace {

/// Pressure of line `line` and its parts together; `at` has what is pushed into each of them.
double CommonPressure(const CompiledPhs& sys, const Instant& at, int line, const double* state) {
  const Node& node = sys.nodes[static_cast<size_t>(line)];
  const auto beyond = [&](double log_pressure) {
    const double p = std::exp(log_pressure);
    double pushed = at.pushed[line];
    for (const Path& path : sys.paths) {
      if (path.part < 0 || path.whole() != line) continue;
      double slope = 0;
      pushed += at.pushed[path.part] - CalcAbsorbed(sys.nodes[static_cast<size_t>(path.part)], p,
                                                    at.ambient, state, &slope);
    }
    return log_pressure - std::log(SolveNode(node, pushed, at.ambient, state).p);
  };
  RootSearch search;
  search.near = std::log(node.p0);
  search.step = 0.1;
  search.reach = 30;
  search.tolerance = 1e-13;
  const auto found = RisingRoot(beyond, search);
  return found ? std::exp(*found) : node.p0;
}

}  // namespace

void PhsSystem::SettleChambers(double time, const double* x, double* state) const {
  const CompiledPhs& sys = *impl_;
  for (const Path& path : sys.paths) {
    if (path.part < 0) continue;
    state[path.volume] = 0;
    if (path.flow >= 0) state[path.flow] = 0;
    std::fill_n(state + std::max(path.lag, 0), path.num_lags, 0.0);
  }
  Instant at;
  Solve(time, x, state, &at);
  for (int line = 0; line < num_lines(); ++line) {
    double p = -1;  // found once a part asks for it
    for (const Path& path : sys.paths) {
      if (path.part < 0 || path.whole() != line) continue;
      if (p < 0) p = CommonPressure(sys, at, line, state);
      double slope = 0;
      const double into =
          CalcAbsorbed(sys.nodes[static_cast<size_t>(path.part)], p, at.ambient, state, &slope) -
          at.pushed[path.part];
      state[path.volume] = path.part == path.to ? into : -into;
    }
  }
}

}  // namespace phs::hydraulics
