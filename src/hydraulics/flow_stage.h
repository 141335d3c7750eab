// One implicit stage of the flows of a system: u = base + a F(t, u) for all hydraulic states.
//
// Paths, pressures and what nodes remember by one Newton's method; a step is made of two stages
// (flow_rates.cc), a piston on a yielding mounting is balanced against one (mount_step.cc).
#pragma once

#include "hydraulics/compiled_phs.h"
#include "hydraulics/node_rates.h"

namespace phs::hydraulics {

/// Inertance of each path [kg/m4], of those that have one.
struct PathInertances {
  double value[kMaxPaths];
};

/// The paths' own.
PathInertances OwnInertances(const CompiledPhs& sys);

/// How the paths answer to what they let pass.
struct PathSlopes {
  /// Slope of each law, over the pressure drop or, of a path with inertance, of the drop over the
  /// flow.
  double law[kMaxPaths];
  double back[kMaxPaths];             ///< FlowLaw::Return
  double drop[kMaxPaths][kMaxPaths];  ///< d(p_from - p_to of k)/d(volume passed by l)
  double heat[kMaxNodes];             ///< what the heat of compression adds to dD/dp of the nodes
};

/// Lags of the flows in a stage of length a, by their states: `along` = a rate, `keeps` = 1/(1 +
/// along).
struct StageLags {
  double length = -1, viscosity = 0;  ///< they hold for; as yet for none
  struct Lag {
    double rate, resistance, along, keeps;
  } at[kMaxStates];
};

/// Those at the warmth of `at`; nothing where they hold already.
void CalcLags(const CompiledPhs& sys, double time, const Instant& at, double a, StageLags* lags);

/// How the pistons move in a stage of a step: by how much since its start, and with what speed.
struct StageMotion {
  double way[kMaxCylinders] = {}, speed[kMaxCylinders] = {};
};

/// Warmth and pistons at time t, when these have moved by `way`.
void MoveTo(const CompiledPhs& sys, double time, const double* way, const Instant& start,
            Instant* at);

/// Rates of volumes passed and of flows with inertance and their lags; slopes of the laws in a
/// stage whose `lags` follow the flow (of no length: at an instant). `speed`: of the pistons;
/// `flows`: those of the last iterate by state, or null.
void CalcPathRates(const CompiledPhs& sys, const PathInertances& inertances, double time,
                   const Instant& at, const StageLags& lags, const double* speed,
                   const double* state, const double* flows, double* rate, PathSlopes* slopes);

/// Rates of the nodes' states, given those of the volumes passed; `heat` of PathSlopes.
void CalcAllNodeRates(const CompiledPhs& sys, const Instant& at, const double* speed,
                      const double* state, double* rate, SlowMatrix* slow, double* heat);

/// Solves a stage; `u` holds a guess and gets the solution, `F` the derivative there, `at`
/// pressures close by and those of the solution, `slopes` (may be null) those there. `lags`: of an
/// earlier stage, or as yet of none. One iteration is enough where what the stages before left of a
/// change says that nothing is left of this one; `memory` says how, and learns. False if no solution
/// was found.
bool SolveStage(const CompiledPhs& sys, const PathInertances& inertances, double time, double a,
                const Instant& start, const StageMotion& motion, const double* base, double* u,
                double* F, Instant* at, StageLags* lags, StageMemory* memory,
                PathSlopes* slopes = nullptr);

/// d(pressure force of each piston)/d(way of those that are moved) [N/m] about a solved stage, the
/// flows answering: a row of `of_each` for each of the `count` that are `moved`.
void CalcStageStiffness(const CompiledPhs& sys, const PathInertances& inertances, double a,
                        const Instant& at, const PathSlopes& slopes, const int* moved, int count,
                        double (*of_each)[kMaxCylinders]);

}  // namespace phs::hydraulics
