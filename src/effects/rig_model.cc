#include "effects/rig_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "effects/catalogue.h"
#include "effects/element_bench.h"
#include "effects/hinged_beam.h"
#include "effects/rig_channels.h"
#include "effects/unlisted.h"

namespace phs::effects {

using hydraulics::PhsOutputs;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;

namespace {

const std::vector<std::string> kKinds = {"cylinder", "quarter", "full", "element"};

std::vector<std::string> InputNames(RigKind kind) {
  switch (kind) {
    case RigKind::kFull:
      return {"actuator1_m", "actuator2_m"};
    case RigKind::kElement:
      return {"x_m"};
    default:
      return {"actuator_m"};
  }
}

std::vector<std::string> OutputNames(RigKind kind, const PhsParams& params) {
  if (kind == RigKind::kElement) return {"force_N"};
  if (kind != RigKind::kFull) return {"piston_m", "load_cell_N", "p_bore_Pa", "p_rod_Pa"};
  std::vector<std::string> names;
  for (const auto& c : params.cylinders) names.push_back("piston" + c.name + "_m");
  for (const auto& c : params.cylinders) names.push_back("load" + c.name + "_N");
  for (const auto& l : params.lines) names.push_back("p" + l.name + "_Pa");
  return names;
}

Status CheckFits(RigKind kind, const PhsParams& params, const RigOptions& options) {
  const size_t need = kind == RigKind::kFull ? 4 : 1;
  if (params.cylinders.size() != need) {
    return Error{
        "rig",
        "model " + params.name + " has " + std::to_string(params.cylinders.size()) + " cylinders",
        std::to_string(need) + " for this rig", "choose a model of this rig"};
  }
  if (options.substeps < 1 || options.substeps > 1000) {
    return Error{"substeps", std::to_string(options.substeps) + " is out of range", "1 to 1000"};
  }
  if (!(options.beam.lever_m > 0 && options.beam.inertia_kg_m2 > 0 &&
        options.beam.damping_Nms_per_rad >= 0 && options.beam.hinge_friction_Nm >= 0)) {
    return Error{"beam", "a number is out of range", "lever and inertia > 0, others >= 0"};
  }
  return {};
}

Status CheckMotion(RigKind kind, const RigMotion& motion) {
  const size_t need = kind == RigKind::kFull ? 2 : 1;
  const size_t n = static_cast<size_t>(motion.num_samples());
  if (motion.position_m.size() != need || n < 2) {
    return Error{"motion",
                 "has " + std::to_string(motion.position_m.size()) + " channels of " +
                     std::to_string(n) + " samples",
                 std::to_string(need) + " channels, at least 2 samples"};
  }
  if (!(std::isfinite(motion.step_s) && motion.step_s > 0)) {
    return Error{"motion.step_s", "the clock does not advance", "step_s > 0"};
  }
  auto check = [n](const std::vector<double>& row, const std::string& name) -> Status {
    if (row.size() != n) return Error{name, "has another length than the first channel", ""};
    for (size_t i = 0; i < n; ++i) {
      if (std::isfinite(row[i])) continue;
      return Error{name, "sample " + std::to_string(i) + " is no number", "finite numbers",
                   "fill or cut the gap first"};
    }
    return {};
  };
  for (const auto& row : motion.position_m) {
    if (Status s = check(row, "position_m"); !s.ok()) return s;
  }
  if (!motion.speed_m_s.empty() && motion.speed_m_s.size() != need) {
    return Error{"speed_m_s", "not as many channels as positions", ""};
  }
  for (const auto& row : motion.speed_m_s) {
    if (Status s = check(row, "speed_m_s"); !s.ok()) return s;
  }
  if (!motion.pressure_Pa.empty()) {
    if (Status s = check(motion.pressure_Pa, "pressure_Pa"); !s.ok()) return s;
  }
  if (!motion.temperature_K.empty()) return check(motion.temperature_K, "temperature_K");
  return {};
}

}  // namespace

Result<RigKind> ParseRigKind(const std::string& word) {
  for (size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i] == word) return static_cast<RigKind>(i);
  }
  const std::string nearest = NearestWord(word, kKinds);
  return Error{"rig", "unknown rig \"" + word + "\"", "cylinder, quarter, full, element",
               nearest.empty() ? "" : "did you mean " + nearest + "?"};
}

PhsParams HydraulicsOf(const PhsParams& params) {
  PhsParams out = params;
  out.friction = {};
  out.element = {};
  std::erase_if(out.effects, [](const hydraulics::EffectParams& effect) {
    const hydraulics::EffectInfo* info = Catalogue().Find(effect.name);
    if (info == nullptr) return false;
    if (effect.name == UnlistedInfo().name) return IsForce(effect);
    return info->family == "friction" || info->family == "instrument" || info->family == "element";
  });
  return out;
}

std::vector<double> DifferentiateMotion(const std::vector<double>& position, double step_s) {
  const size_t n = position.size();
  std::vector<double> speed(n, 0.0);
  if (n < 2) return speed;
  for (size_t i = 1; i + 1 < n; ++i) speed[i] = (position[i + 1] - position[i - 1]) / (2 * step_s);
  speed[0] = (position[1] - position[0]) / step_s;
  speed[n - 1] = (position[n - 1] - position[n - 2]) / step_s;
  return speed;
}

struct RigModel::Impl {
  RigKind kind;
  PhsParams params;
  RigOptions options;
  PhsSystem system;
  std::vector<std::string> inputs, outputs;

  int Substeps(double step_s) const;
  RigPressures CalcPressures(const RigMotion& motion, const std::vector<double>& speed) const;
  void RunCylinder(const RigMotion& motion, const std::vector<double>& speed,
                   std::shared_ptr<const RigPressures>* pressures, RigPrediction* out) const;
  void RunMounted(const RigMotion& motion, const std::vector<double>& speed,
                  RigPrediction* out) const;
  void RunStepped(const RigMotion& motion, const std::vector<double>& speed,
                  RigPrediction* out) const;
  void RunFull(const RigMotion& motion, const std::vector<std::vector<double>>& speed,
               RigPrediction* out) const;
};

RigModel::RigModel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RigModel::RigModel(RigModel&&) noexcept = default;
RigModel& RigModel::operator=(RigModel&&) noexcept = default;
RigModel::~RigModel() = default;
RigKind RigModel::kind() const { return impl_->kind; }
const std::vector<std::string>& RigModel::input_names() const { return impl_->inputs; }
const std::vector<std::string>& RigModel::output_names() const { return impl_->outputs; }
const PhsSystem& RigModel::system() const { return impl_->system; }

Result<RigModel> RigModel::Create(RigKind kind, const PhsParams& params,
                                  const RigOptions& options) {
  if (Status s = CheckFits(kind, params, options); !s.ok()) return s.error();
  Result<PhsSystem> system = CreatePhsSystem(params);
  if (!system.ok()) return system.error();
  auto impl = std::unique_ptr<Impl>(
      new Impl{kind, params, options, std::move(system.value()), InputNames(kind), {}});
  impl->outputs = OutputNames(kind, params);
  return RigModel(std::move(impl));
}

/// Position between two samples: the cubic through both with their speeds.
class SampleStep {
 public:
  SampleStep(double x0, double x1, double v0, double v1, double h)
      : x0_(x0), x1_(x1), v0_(h * v0), v1_(h * v1) {}
  double At(double s) const {
    const double d = x1_ - x0_;
    return x0_ + s * (v0_ + s * (3 * d - 2 * v0_ - v1_ + s * (v0_ + v1_ - 2 * d)));
  }
  double End() const { return x1_; }

 private:
  double x0_, x1_, v0_, v1_;
};

/// One step of the integration of a driven cylinder.
struct RigStep {
  double time = 0, length = 0;  ///< [s]; no length after the last sample
  double x = 0, v = 0;          ///< position at its start [m], mean speed [m/s]
  int sample = 0;
  bool first = false;  ///< starts at the sample itself
};

/// Calls visit(step) along the motion, `substeps` to a sample and a last one of no length.
template <typename Visit>
void WalkSteps(const RigMotion& motion, const std::vector<double>& speed, int substeps,
               const Visit& visit) {
  const int n = motion.num_samples();
  const double h = motion.step_s / substeps;
  for (int i = 0; i < n; ++i) {
    RigStep at{motion.t0_s + i * motion.step_s, h, motion.position_m[0][i], 0, i, true};
    if (i + 1 == n) {
      at.length = 0, at.v = speed[i];
      visit(at);
      return;
    }
    const SampleStep step(motion.position_m[0][i], motion.position_m[0][i + 1], speed[i],
                          speed[i + 1], motion.step_s);
    for (int k = 0; k < substeps; ++k) {
      const double next = k + 1 < substeps ? step.At((k + 1.0) / substeps) : step.End();
      at.v = (next - at.x) / h, at.first = k == 0;
      visit(at);
      at.time += h, at.x = next;
    }
  }
}

/// Those asked for, or as many as a ringing oil column needs.
int RigModel::Impl::Substeps(double step_s) const {
  constexpr double kPhase = 0.6;  // [rad] per step: numerical damping below 0.1 %
  constexpr int kMost = 8;
  const double needed = std::ceil(system.max_line_frequency() * step_s / kPhase);
  return std::max(options.substeps, static_cast<int>(std::min<double>(needed, kMost)));
}

RigPressures RigModel::Impl::CalcPressures(const RigMotion& motion,
                                           const std::vector<double>& speed) const {
  const int states = system.num_states();
  std::vector<double> state(states, 0.0), rate(states, 0.0);
  RigPressures out;
  const auto steps = static_cast<size_t>(motion.num_samples()) * Substeps(motion.step_s);
  out.bore.reserve(steps), out.rod.reserve(steps);
  WalkSteps(motion, speed, Substeps(motion.step_s), [&](const RigStep& at) {
    double bore, rod;
    system.CalcHydraulics(at.time, at.length, &at.x, &at.v, state.data(), rate.data(), &bore, &rod);
    out.bore.push_back(bore), out.rod.push_back(rod);
    for (int j = system.num_friction_states(); j < states; ++j) state[j] += at.length * rate[j];
  });
  return out;
}

void RigModel::Impl::RunCylinder(const RigMotion& motion, const std::vector<double>& speed,
                                 std::shared_ptr<const RigPressures>* pressures,
                                 RigPrediction* out) const {
  if (system.has_mounts()) {
    return options.substeps == 1 ? RunMounted(motion, speed, out) : RunStepped(motion, speed, out);
  }
  if (*pressures == nullptr) {
    *pressures = std::make_shared<const RigPressures>(CalcPressures(motion, speed));
  }
  const int friction_states = system.num_friction_states();
  std::vector<double> state(system.num_states(), 0.0), rate(state);
  PhsOutputs force;
  force.energy = false;
  const double* bore = (*pressures)->bore.data();
  const double* rod = (*pressures)->rod.data();
  WalkSteps(motion, speed, Substeps(motion.step_s), [&](const RigStep& at) {
    if (at.first) {
      const auto i = static_cast<size_t>(at.sample);
      force.piston = &out->channels[0][i];
      force.force = &out->channels[1][i];
      force.p_bore = &out->channels[2][i];
      force.p_rod = &out->channels[3][i];
      system.CalcForces(at.time, &at.x, &speed[i], state.data(), bore, rod, &force);
    }
    if (friction_states > 0) {
      system.CalcFrictionRate(at.time, at.length, &at.x, &at.v, state.data(), bore, rod,
                              rate.data());
      for (int j = 0; j < friction_states; ++j) state[j] += at.length * rate[j];
    }
    ++bore, ++rod;
  });
}

void RigModel::Impl::RunStepped(const RigMotion& motion, const std::vector<double>& speed,
                                RigPrediction* out) const {
  std::vector<double> state(system.num_states(), 0.0), rate(state);
  PhsOutputs at_sample;
  at_sample.energy = false;
  WalkSteps(motion, speed, Substeps(motion.step_s), [&](const RigStep& at) {
    if (at.first) {
      const auto i = static_cast<size_t>(at.sample);
      at_sample.piston = &out->channels[0][i];
      at_sample.force = &out->channels[1][i];
      at_sample.p_bore = &out->channels[2][i];
      at_sample.p_rod = &out->channels[3][i];
      system.Calc(at.time, &at.x, &speed[i], state.data(), &at_sample);
    }
    if (at.length == 0) return;
    system.CalcStateRate(at.time, at.length, &at.x, &at.v, state.data(), rate.data());
    for (size_t j = 0; j < state.size(); ++j) state[j] += at.length * rate[j];
  });
}

// A yielding mount: the piston's speed is that of a step, so steps are laid about the samples, from
// middle to middle. Friction then belongs to the speed at the sample (to second order), and state,
// pressures and piston are taken there as the mean of the step's two ends. Were the steps laid from
// sample to sample, friction would lag by half a step, some hundred newtons about a reversal.
void RigModel::Impl::RunMounted(const RigMotion& motion, const std::vector<double>& speed,
                                RigPrediction* out) const {
  const int n = motion.num_samples(), states = system.num_states();
  const double h = motion.step_s;
  const std::vector<double>& x = motion.position_m[0];
  std::vector<double> state(states, 0.0), middle(states), rate(states, 0.0);
  double force = 0, pressure_force = 0, from = x[0], t = motion.t0_s;
  PhsOutputs end, at;
  end.energy = at.energy = false;
  end.force = &force, end.pressure_force = &pressure_force;
  for (int i = 0; i < n; ++i) {
    // Cubic through both samples with their speeds, half way; straight on after the last.
    const double to = i + 1 < n ? 0.5 * (x[i] + x[i + 1]) + h / 8 * (speed[i] - speed[i + 1])
                                : x[i] + 0.5 * h * speed[i];
    const double step = i == 0 ? 0.5 * h : h, v = (to - from) / step;
    system.CalcStateRate(t, step, &from, &v, state.data(), rate.data());
    for (int j = 0; j < states; ++j) {
      middle[j] = state[j] + (i == 0 ? 0.0 : 0.5 * step * rate[j]);
      state[j] += step * rate[j];
    }
    t += step, from = to;
    system.Calc(t, &to, &v, state.data(), &end);
    const double beside_pressure = force - pressure_force;  // friction and end stop at the sample
    double pressure_at;
    at.piston = &out->channels[0][i];
    at.pressure_force = &pressure_at;
    at.p_bore = &out->channels[2][i];
    at.p_rod = &out->channels[3][i];
    system.Calc(motion.t0_s + i * h, &x[i], &speed[i], middle.data(), &at);
    out->channels[1][i] = pressure_at + beside_pressure;
  }
}

void RigModel::Impl::RunFull(const RigMotion& motion, const std::vector<std::vector<double>>& speed,
                             RigPrediction* out) const {
  const int n = motion.num_samples(), lines = system.num_lines();
  const double h = motion.step_s / options.substeps;
  HingedBeam beam(system, options.beam);
  double piston[4], force[4];
  std::vector<double> pressure(lines);
  PhsOutputs at;
  at.energy = false;
  at.piston = piston;
  at.force = force;
  at.pressure = pressure.data();
  for (int i = 0; i < n; ++i) {
    const double t = motion.t0_s + i * motion.step_s;
    const double x1 = motion.position_m[0][i], x2 = motion.position_m[1][i];
    beam.Calc(t, x1, x2, speed[0][i], speed[1][i], &at);
    for (int c = 0; c < 4; ++c) {
      out->channels[c][i] = piston[c];
      out->channels[4 + c][i] = force[c];
    }
    for (int l = 0; l < lines; ++l) out->channels[8 + l][i] = pressure[l];
    if (i + 1 == n) continue;
    const double v1 = (motion.position_m[0][i + 1] - x1) / motion.step_s;
    const double v2 = (motion.position_m[1][i + 1] - x2) / motion.step_s;
    for (int k = 0; k < options.substeps; ++k) {
      beam.Step(t + k * h, h, x1 + k * h * v1, x2 + k * h * v2, v1, v2);
    }
  }
}

/// Force of a mass that moves with the actuator behind the load cell, tension > 0.
void AddMovedMass(double mass_kg, const std::vector<double>& speed, double step_s,
                  std::vector<double>* load) {
  if (mass_kg == 0) return;
  const std::vector<double> acceleration = DifferentiateMotion(speed, step_s);
  for (size_t i = 0; i < load->size(); ++i) (*load)[i] += mass_kg * acceleration[i];
}

Status RigModel::Run(const RigMotion& motion, RigPrediction* prediction) const {
  std::shared_ptr<const RigPressures> pressures;
  return Run(motion, prediction, &pressures);
}

Status RigModel::Run(const RigMotion& motion, RigPrediction* prediction,
                     std::shared_ptr<const RigPressures>* pressures) const {
  if (Status s = CheckMotion(impl_->kind, motion); !s.ok()) return s;
  const size_t n = static_cast<size_t>(motion.num_samples());
  prediction->channels.resize(impl_->outputs.size());
  for (auto& row : prediction->channels) row.resize(n);
  std::vector<std::vector<double>> derived;
  if (motion.speed_m_s.empty()) {
    for (const auto& row : motion.position_m) {
      derived.push_back(DifferentiateMotion(row, motion.step_s));
    }
  }
  const auto& speed = motion.speed_m_s.empty() ? derived : motion.speed_m_s;
  switch (impl_->kind) {
    case RigKind::kFull:
      impl_->RunFull(motion, speed, prediction);
      break;
    case RigKind::kElement:
      RunElementBench(impl_->system, motion, speed[0], &prediction->channels[0], nullptr);
      break;
    default:
      impl_->RunCylinder(motion, speed[0], pressures, prediction);
      AddMovedMass(impl_->system.element().mass_kg, speed[0], motion.step_s,
                   &prediction->channels[1]);
      break;
  }
  ApplyInstruments(impl_->kind, impl_->system, motion.t0_s, motion.step_s, prediction);
  return {};
}

}  // namespace phs::effects
