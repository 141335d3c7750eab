// The compiled form of a PHS, shared by the files that evaluate it. Internal to src/hydraulics.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hydraulics/carried_body.h"
#include "hydraulics/end_stop.h"
#include "hydraulics/extension.h"
#include "hydraulics/friction.h"
#include "hydraulics/mount.h"
#include "hydraulics/node.h"
#include "hydraulics/phs_instant.h"
#include "hydraulics/phs_outputs.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

inline constexpr int kMaxPaths = 32;
inline constexpr int kOpen = -1;  ///< node index of the atmosphere

struct CompiledCylinder {
  int bore = kOpen, rod = kOpen;  ///< nodes of its chambers
  double bore_area = 0, rod_area = 0;
  double bore_p0 = kAtmosphere, rod_p0 = kAtmosphere;
  Friction friction;
  EndStopParams stop;
  Mount mount;
  std::array<ReadingLaws, kSensors> readings;
  /// State indices: the bristle, the first memory of friction, the mounting; those of its branches
  /// follow.
  int bristle = -1, memory = -1, mount_state = -1;
  /// Deflections of the mounting's branches in `state`.
  const double* Branches(const double* state) const { return state + mount_state + 1; }
};

/// Flow from one node to another; `volume` state = volume that went from `from` to `to` [m3].
struct Path {
  int from = kOpen, to = kOpen;
  std::unique_ptr<FlowLaw> law;
  int volume = -1, flow = -1;  ///< state indices; flow only with an inertance
  int lag = -1, num_lags = 0;  ///< state index of the first lag of the flow, and how many
  /// The end that is a part of the other end's line: a chamber (from) or a reservoir (to); -1: none.
  int part = -1;
  int cylinder = -1;  ///< whose piston the law may ask for; -1: none
  int whole() const { return part == from ? to : from; }
};

struct CompiledPhs {
  PhsParams params;
  std::vector<std::string> cylinder_names, line_names, state_names;
  std::vector<CompiledCylinder> cylinders;
  std::vector<Node> nodes;  ///< the first num_lines are the lines themselves
  std::vector<Path> paths;
  std::vector<std::unique_ptr<VolumeLaw>> volume_laws;
  std::vector<std::unique_ptr<const AmbientLaw>> ambient;
  LoadLaws loads;
  std::shared_ptr<const ExtraSeries> extra;  ///< null: none
  int first_slow = 0;  ///< states below: friction and mounting; from here: hydraulic
  bool friction_needs_pressure = false;
  bool has_mounts = false;

  int num_states() const { return static_cast<int>(state_names.size()); }
  double Ambient(double time) const;
  /// Temperature and viscosity of an instant; what flows at `time`, and how warm it is there.
  void SetWarmth(double time, Instant* at) const;
  FlowPlace WhereItFlows(double time, const Instant& at) const {
    FlowPlace place;
    place.time = time, place.warmer = at.ambient - params.temperature_K;
    place.viscosity = at.viscosity;
    return place;
  }
  /// The same for one path. `speed`: of the pistons, or null.
  void SetPath(const Path& path, const Instant& at, const double* speed, const double* state,
               FlowPlace* place) const {
    place->passed = state[path.volume];
    if (path.cylinder < 0) return;
    place->piston = at.piston[path.cylinder];
    place->speed = speed != nullptr ? speed[path.cylinder] : 0;
  }
  /// Time, warmth and further channels.
  void SetTime(double time, Instant* at) const;
  double Pressure(const Instant& at, int node) const {
    return node == kOpen ? kAtmosphere : at.node[node].p;
  }
  /// Volumes pushed into the nodes by pistons, flows and warmth.
  void CalcPushed(const double* state, Instant* at) const;
  /// Those by pistons and warmth alone; and what the flows add.
  void CalcDisplaced(const Instant& at, double* pushed) const;
  void AddPassed(const double* state, double* pushed) const;
  /// Starts from the nodes of `near` where they have no closed form; may be null, may be `at`.
  void SolveNodes(const double* state, Instant* at, const Instant* near = nullptr) const;
  FrictionPlace Place(const Instant& at, int cylinder, const double* state) const;
};

/// Force of the cylinder's chambers on its piston, tension > 0 [N].
double CalcPressureForce(const CompiledPhs& sys, const Instant& at, int cylinder);

/// Mean piston speeds over h and rates of the mount states (mount_step.cc). `near`: solved nodes
/// close by, or null; where oil flows, the solved start of the step. `piston_way`: a guess of the
/// pistons' ways, and the solution; null: each goes as its driven end.
void CalcMountRates(const CompiledPhs& sys, double time, double h, const double* x, const double* v,
                    const double* state, const Instant* near, double* piston_speed, double* rate,
                    double* piston_way = nullptr);

/// PhsSystem::BalanceBody.
bool BalanceBody(const CompiledPhs& sys, double time, double h, const double* x, const double* v,
                 const double* state, const Instant* near, const CarriedBody& body,
                 double* piston_way, double* body_way);

/// Rates of gas temperatures and flows over h (flow_rates.cc).
void CalcHydraulicRates(const CompiledPhs& sys, double time, double h, const Instant& start,
                        const StepSpeeds& piston, const double* state, StageMemory* memory,
                        double* rate);
/// Kinetic energy of oil with inertance, and work done on the atmosphere by oil that left [J].
double CalcPathEnergy(const CompiledPhs& sys, const double* state);
/// Available power lost in gases and paths [W].
double CalcHydraulicLoss(const CompiledPhs& sys, double time, const Instant& at,
                         const double* state);

/// The effect with defaults filled in; errors for unknown names, keys, targets and ranges.
Result<EffectParams> CompleteEffect(const PhsParams& params, const EffectParams& effect,
                                    const EffectTable& table);

}  // namespace phs::hydraulics
