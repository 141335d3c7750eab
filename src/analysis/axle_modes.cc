#include "analysis/axle_modes.h"

#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "analysis/axle_pattern.h"
#include "plugin/model_text.h"
#include "plugin/observer.h"

namespace phs::analysis {
namespace {

constexpr double kLift = 1.0;  ///< no wheel touches its rail [m]
constexpr int kCycles = 3;     ///< the last one is measured

void LiftOff(const mjModel* m, mjData* d) {
  mj_resetData(m, d);
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] == mjJNT_FREE) d->qpos[m->jnt_qposadr[j] + 2] += kLift;
  }
  mj_forward(m, d);
}

/// Wheels on their rails would be felt with the springs.
Status CheckLiftable(const vehicle::Simulation& simulation) {
  const mjModel* m = simulation.model();
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] == mjJNT_FREE) return {};
  }
  return Error{"bogie '" + simulation.scenario().bogie + "'",
               "has no free joint: it cannot be lifted off its rails", "a <freejoint/> at the root",
               ""};
}

void NotePhs(const plugin::Binding& binding, const mjModel* m, const mjData* d, AxleMode* mode) {
  if (binding.phs().empty()) return;
  plugin::PhsState state = binding.CalcPhs(m, d, 0);
  mode->cylinder_stroke_m = std::move(state.displacement);
  mode->cylinder_force_N = std::move(state.force);
  mode->line_pressure_Pa = std::move(state.pressure);
}

/// First harmonic of the resisting force over the last of a few cycles.
AxleMode Measure(const plugin::Binding& binding, const mjModel* m, mjData* d,
                 const AxlePattern& pattern, const PatternJoints& joints, double amplitude,
                 const AxleModeOptions& options) {
  LiftOff(m, d);
  AxleMode mode;
  mode.name = pattern.name;
  mode.rotation = pattern.rotation;
  mode.amplitude = amplitude;
  mode.closed_form = CalcModeClosedForm(binding, m, d, pattern, joints, options.frequency_Hz);
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
    if (i >= (kCycles - 1) * per_cycle) {
      mode.loop_displacement.push_back(u);
      mode.loop_force.push_back(-force);
      if (i == (kCycles - 1) * per_cycle + per_cycle / 4) NotePhs(binding, m, d, &mode);
    }
    // States go on over the step that the motion really makes, so that they do not lag behind it.
    const double next = amplitude * std::sin(omega * h * (i + 1));
    for (int k = 0; k < 2; ++k) d->qvel[joints.dof[k]] = pattern.sign[k] * (next - u) / h;
    binding.AdvanceStates(m, d, h);
    d->time += h;
    if (i == 0) mean_start = force;
    if (i < (kCycles - 1) * per_cycle) continue;
    in_phase -= 2.0 / per_cycle * (force - mean_start) * std::sin(phase);
    quadrature -= 2.0 / per_cycle * (force - mean_start) * std::cos(phase);
    loss -= force * rate * h;
  }
  mode.stiffness = in_phase / amplitude;
  mode.damping = quadrature / (amplitude * omega);
  mode.loss_per_cycle = loss;
  return mode;
}

/// A slide joint has no pins: drawn from its place on the box, as long as a usual cylinder.
void FindSlideEnds(const mjModel* m, const mjData* d, int actuator, const double* origin,
                   BogiePlan::Cylinder* cylinder) {
  constexpr double kDrawn = 0.4;  // [m]
  const int joint = m->actuator_trnid[2 * actuator];
  const double extends = m->actuator_gear[6 * actuator] < 0 ? -1 : 1;
  for (int k = 0; k < 2; ++k) {
    cylinder->to[k] = d->xanchor[3 * joint + k] - origin[k];
    cylinder->from[k] = cylinder->to[k] - extends * kDrawn * d->xaxis[3 * joint + k];
  }
}

/// Ends of a tendon through two sites, or of a cylinder on a slide joint.
bool FindEnds(const mjModel* m, const mjData* d, int actuator, const double* origin,
              BogiePlan::Cylinder* cylinder) {
  if (m->actuator_trntype[actuator] == mjTRN_JOINT) {
    FindSlideEnds(m, d, actuator, origin, cylinder);
    return true;
  }
  const int tendon = m->actuator_trnid[2 * actuator];
  const int first = m->tendon_adr[tendon];
  if (m->tendon_num[tendon] != 2 || m->wrap_type[first] != mjWRAP_SITE ||
      m->wrap_type[first + 1] != mjWRAP_SITE) {
    return false;
  }
  for (int k = 0; k < 2; ++k) {
    cylinder->from[k] = d->site_xpos[3 * m->wrap_objid[first] + k] - origin[k];
    cylinder->to[k] = d->site_xpos[3 * m->wrap_objid[first + 1] + k] - origin[k];
  }
  return true;
}

BogiePlan MakePlan(const plugin::Binding& binding, const plugin::BogiePair& bogie, const mjModel* m,
                   const mjData* d) {
  BogiePlan plan;
  const auto& wheelsets = binding.wheelsets();
  const double* lead = d->xpos + 3 * wheelsets[static_cast<size_t>(bogie.lead)].body;
  const double* trail = d->xpos + 3 * wheelsets[static_cast<size_t>(bogie.trail)].body;
  const double origin[2] = {(lead[0] + trail[0]) / 2, (lead[1] + trail[1]) / 2};
  plan.axles = {{"lead", lead[0] - origin[0]}, {"trail", trail[0] - origin[0]}};
  if (binding.phs().empty()) return plan;
  const plugin::PhsBinding& phs = binding.phs()[0];
  for (size_t i = 0; i < phs.cylinder.size(); ++i) {
    BogiePlan::Cylinder cylinder{phs.system->cylinder_names()[i]};
    if (FindEnds(m, d, phs.cylinder[i], origin, &cylinder)) plan.cylinders.push_back(cylinder);
  }
  plan.lines = phs.system->line_names();
  return plan;
}

}  // namespace

double BoxLever(const mjModel* m) {
  constexpr double kUsual = 0.9;
  return plugin::CustomNumber(m, "phs_box_lever_m").value_or(kUsual);
}

Result<PatternJoints> FindPatternJoints(const mjModel* m, const std::string& prefix,
                                        const AxlePattern& pattern) {
  PatternJoints joints{};
  const char* axles[2] = {"lead", "trail"};
  for (int i = 0; i < 2; ++i) {
    const std::string name = prefix + axles[i] + pattern.joint;
    const int id = mj_name2id(m, mjOBJ_JOINT, name.c_str());
    if (id < 0) {
      return Error{"MJCF joint '" + name + "'", "is missing: the axle modes move it",
                   "slides *_x and hinges *_yaw of both axles against the frame", ""};
    }
    joints.joint[i] = id;
    joints.qpos[i] = m->jnt_qposadr[id];
    joints.dof[i] = m->jnt_dofadr[id];
  }
  return joints;
}

Result<AxleModes> MeasureAxleModes(const vehicle::Simulation& simulation,
                                   const AxleModeOptions& options,
                                   const vehicle::Progress& progress) {
  const mjModel* m = simulation.model();
  const auto bogies = plugin::FindBogies(simulation.binding());
  if (bogies.empty()) {
    return Error{"bogie '" + simulation.scenario().bogie + "'", "has no pair of wheelsets",
                 "wheelsets named lead and trail", ""};
  }
  if (Status s = CheckLiftable(simulation); !s.ok()) return s.error();
  const vehicle::DataPtr data(mj_makeData(m));
  AxleModes modes;
  const plugin::Binding& binding = simulation.binding();
  const plugin::InstantForces instant = simulation.Instant();
  LiftOff(m, data.get());
  modes.lever_m = BoxLever(m);
  modes.plan = MakePlan(binding, bogies[0], m, data.get());
  for (const AxlePattern& pattern : kAxlePatterns) {
    auto joints = FindPatternJoints(m, bogies[0].prefix, pattern);
    if (!joints.ok()) return joints.error();
    const double lever = pattern.rotation ? modes.lever_m : 1.0;
    for (auto [size, measured] : {std::pair{options.small_displacement_m, &modes.small},
                                  std::pair{options.large_displacement_m, &modes.large}}) {
      const double share = static_cast<double>(modes.small.size() + modes.large.size()) /
                           static_cast<double>(2 * std::size(kAxlePatterns));
      if (progress && !progress(share)) return Error{"axle modes", "were interrupted", "", ""};
      measured->push_back(
          Measure(binding, m, data.get(), pattern, joints.value(), size / lever, options));
    }
  }
  return modes;
}

}  // namespace phs::analysis
