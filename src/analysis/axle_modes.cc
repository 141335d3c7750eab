#include "analysis/axle_modes.h"

#include <cmath>
#include <numbers>

#include "plugin/observer.h"

namespace phs::analysis {
namespace {

constexpr double kLift = 1.0;  ///< no wheel touches its rail [m]
constexpr int kCycles = 3;     ///< the last one is measured

struct Pattern {
  const char* name;
  bool rotation;
  const char* joint;  ///< "_x" or "_yaw"
  double sign[2];     ///< lead, trail
};
constexpr Pattern kPatterns[] = {{"bending", true, "_yaw", {1, -1}},
                                 {"shear", true, "_yaw", {1, 1}},
                                 {"traction", false, "_x", {1, 1}},
                                 {"antiphase", false, "_x", {1, -1}}};

/// Qpos and dof addresses of the two joints of a pattern.
struct Joints {
  int qpos[2];
  int dof[2];
};

Result<Joints> FindJoints(const mjModel* m, const std::string& prefix, const Pattern& pattern) {
  Joints joints{};
  const char* axles[2] = {"lead", "trail"};
  for (int i = 0; i < 2; ++i) {
    const std::string name = prefix + axles[i] + pattern.joint;
    const int id = mj_name2id(m, mjOBJ_JOINT, name.c_str());
    if (id < 0) {
      return Error{"MJCF joint '" + name + "'", "is missing: the axle modes move it",
                   "slides *_x and hinges *_yaw of both axles against the frame", ""};
    }
    joints.qpos[i] = m->jnt_qposadr[id];
    joints.dof[i] = m->jnt_dofadr[id];
  }
  return joints;
}

/// First harmonic of the resisting force over the last of a few cycles.
AxleMode Measure(const mjModel* m, mjData* d, const Pattern& pattern, const Joints& joints,
                 double amplitude, const AxleModeOptions& options) {
  mj_resetData(m, d);
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] == mjJNT_FREE) d->qpos[m->jnt_qposadr[j] + 2] += kLift;
  }
  const double omega = 2 * std::numbers::pi * options.frequency_Hz;
  const double h = m->opt.timestep;
  const int per_cycle = static_cast<int>(std::lround(1 / (options.frequency_Hz * h)));
  const double rest[2] = {d->qpos[joints.qpos[0]], d->qpos[joints.qpos[1]]};
  double in_phase = 0;
  double quadrature = 0;
  double loss = 0;
  double mean_start = 0;
  for (int i = 0; i < kCycles * per_cycle; ++i) {
    const double phase = omega * h * i;
    const double u = amplitude * std::sin(phase);
    const double rate = amplitude * omega * std::cos(phase);
    for (int k = 0; k < 2; ++k) {
      d->qpos[joints.qpos[k]] = rest[k] + pattern.sign[k] * u;
      d->qvel[joints.dof[k]] = pattern.sign[k] * rate;
    }
    mj_forward(m, d);
    double force = 0;
    for (int k = 0; k < 2; ++k) {
      const int dof = joints.dof[k];
      force += pattern.sign[k] * (d->qfrc_passive[dof] + d->qfrc_actuator[dof]);
    }
    // States go on over the step that the motion really makes, so that they do not lag behind it.
    const double next = amplitude * std::sin(omega * h * (i + 1));
    for (int k = 0; k < 2; ++k) d->qvel[joints.dof[k]] = pattern.sign[k] * (next - u) / h;
    mj_forward(m, d);
    for (int a = 0; a < m->na; ++a) d->act[a] += h * d->act_dot[a];
    d->time += h;
    if (i == 0) mean_start = force;
    if (i < (kCycles - 1) * per_cycle) continue;
    in_phase -= 2.0 / per_cycle * (force - mean_start) * std::sin(phase);
    quadrature -= 2.0 / per_cycle * (force - mean_start) * std::cos(phase);
    loss -= force * rate * h;
  }
  return {pattern.name,
          pattern.rotation,
          amplitude,
          in_phase / amplitude,
          quadrature / (amplitude * omega),
          loss};
}

}  // namespace

Result<AxleModes> MeasureAxleModes(const vehicle::Simulation& simulation,
                                   const AxleModeOptions& options) {
  const mjModel* m = simulation.model();
  const auto bogies = plugin::FindBogies(simulation.binding());
  if (bogies.empty()) {
    return Error{"bogie '" + simulation.scenario().bogie + "'", "has no pair of wheelsets",
                 "wheelsets named lead and trail", ""};
  }
  const vehicle::DataPtr data(mj_makeData(m));
  AxleModes modes;
  for (const Pattern& pattern : kPatterns) {
    auto joints = FindJoints(m, bogies[0].prefix, pattern);
    if (!joints.ok()) return joints.error();
    const double lever = pattern.rotation ? options.lever_m : 1.0;
    modes.small.push_back(Measure(m, data.get(), pattern, joints.value(),
                                  options.small_displacement_m / lever, options));
    modes.large.push_back(Measure(m, data.get(), pattern, joints.value(),
                                  options.large_displacement_m / lever, options));
  }
  return modes;
}

}  // namespace phs::analysis
