#include "rigs/rig_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "effects/catalogue.h"
#include "effects/own_law.h"
#include "effects/unlisted.h"
#include "phs_model/phs_model.h"
#include "rigs/driven_rigs.h"
#include "rigs/element_bench.h"
#include "rigs/element_drive.h"
#include "rigs/hinged_beam.h"
#include "rigs/rig_channels.h"
#include "rigs/rig_cylinder.h"

namespace phs::rigs {

using phs_model::CreatePhsSystem;

using hydraulics::PhsOutputs;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;

namespace {

std::vector<std::string> InputNames(RigKind kind, const RigOptions& options) {
  if (kind == RigKind::kElement && options.driven_by == Drive::kForce) return {"force_N"};
  if (kind == RigKind::kElement) return {"x_m"};
  if (kind == RigKind::kFull) {
    std::vector<std::string> names;
    for (int i = 1; i <= options.actuators; ++i) {
      names.push_back("actuator" + std::to_string(i) + "_m");
    }
    return names;
  }
  if (options.driven_by == Drive::kForce) return {"force_N"};
  if (options.driven_by == Drive::kPressure) return {"actuator_m", "p_bore_Pa", "p_rod_Pa"};
  return {"actuator_m"};
}

std::vector<std::string> OutputNames(RigKind kind, const PhsParams& params,
                                     const RigOptions& options) {
  if (kind == RigKind::kElement && options.driven_by == Drive::kForce) return {"x_m"};
  if (kind == RigKind::kElement) return {"force_N"};
  if (options.driven_by == Drive::kPressure) return {"piston_m", "load_cell_N"};
  if (kind != RigKind::kFull) return {"piston_m", "load_cell_N", "p_bore_Pa", "p_rod_Pa"};
  std::vector<std::string> names;
  for (const auto& c : params.cylinders) names.push_back("piston" + c.name + "_m");
  for (const auto& c : params.cylinders) names.push_back("load" + c.name + "_N");
  for (const auto& l : params.lines) names.push_back("p" + l.name + "_Pa");
  return names;
}

Status CheckDrive(RigKind kind, const RigOptions& options) {
  if (options.actuators != 2 && options.actuators != 4) {
    return Error{"actuators", std::to_string(options.actuators) + " drive the full rig", "2 or 4",
                 "2: cylinders 3 and 4 on the beam"};
  }
  if (options.actuators == 4 && kind != RigKind::kFull) {
    return Error{"actuators", "this rig has one cylinder", "rig: full"};
  }
  if (options.driven_by == Drive::kPosition) return {};
  if (kind == RigKind::kElement && options.driven_by == Drive::kForce) return {};
  if (kind != RigKind::kCylinder && kind != RigKind::kQuarter) {
    return Error{"driven_by", "is for one cylinder with its lines", "rig: cylinder, quarter",
                 "a part on a bench: position or force"};
  }
  if (!(options.moving_mass_kg > 0)) {
    return Error{"moving_mass_kg", "is not positive", "> 0"};
  }
  return {};
}

Status CheckFits(RigKind kind, const PhsParams& params, const RigOptions& options) {
  if (Status s = CheckDrive(kind, options); !s.ok()) return s;
  const size_t need = kind == RigKind::kFull ? 4 : 1;
  if (params.cylinders.size() != need) {
    return Error{
        "rig",
        "model " + params.name + " has " + std::to_string(params.cylinders.size()) + " cylinders",
        std::to_string(need) + " for this rig", "choose a model of this rig"};
  }
  if (params.element.gas_force_N > 0 && params.element.gas_length_m == 0) {
    return Error{"element.gas_length_m", "is 0", "volume over area, in m, not 0"};
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

Status CheckMotion(size_t need, const RigMotion& motion) {
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
  if (!motion.acceleration_m_s2.empty() && motion.acceleration_m_s2.size() != need) {
    return Error{"acceleration_m_s2", "not as many channels as positions", ""};
  }
  for (const auto& row : motion.acceleration_m_s2) {
    if (Status s = check(row, "acceleration_m_s2"); !s.ok()) return s;
  }
  if (!motion.pressure_Pa.empty()) {
    if (Status s = check(motion.pressure_Pa, "pressure_Pa"); !s.ok()) return s;
  }
  if (!motion.temperature_K.empty()) return check(motion.temperature_K, "temperature_K");
  return {};
}

bool IsOf(const hydraulics::EffectParams& effect, const char* family) {
  const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(effect);
  return info != nullptr && info->family == family;
}

/// True if friction moves what makes the pressures.
bool ActsBack(RigKind kind, const PhsParams& params) {
  return kind == RigKind::kFull ||
         std::any_of(params.effects.begin(), params.effects.end(),
                     [](const auto& effect) { return IsOf(effect, "mounting"); });
}

}  // namespace

PhsParams KeptOf(RigKind kind, const PhsParams& params) {
  PhsParams out = params;
  if (ActsBack(kind, params)) {
    std::erase_if(out.effects, [](const auto& effect) { return IsOf(effect, "instrument"); });
    return out;
  }
  out.friction = {};
  out.element = {};
  std::erase_if(out.effects, [](const hydraulics::EffectParams& effect) {
    const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(effect);
    if (info == nullptr) return false;
    if (info == effects::Catalogue().own()) return !effects::OwnActsOnOil(effect);
    if (effect.name == effects::UnlistedInfo().name) return !effects::ActsOnOil(effect);
    return info->family == "friction" || info->family == "instrument" || info->family == "element";
  });
  return out;
}

struct RigModel::Impl {
  RigKind kind;
  PhsParams params;
  RigOptions options;
  PhsSystem system;
  std::vector<std::string> inputs, outputs;

  void RunFull(const RigMotion& motion, const std::vector<std::vector<double>>& speed,
               RigPrediction* out) const;
  void RunOne(const RigMotion& motion, const std::vector<double>& speed,
              std::shared_ptr<const KeptRun>* kept, RigPrediction* out) const;
  /// Full rigs and rigs of one cylinder, without their instruments.
  void RunBare(const RigMotion& motion, const std::vector<std::vector<double>>& speed,
               std::shared_ptr<const KeptRun>* kept, RigPrediction* out) const;
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
  Result<PhsSystem> system = CreatePhsSystem(params, options.extra);
  if (!system.ok()) return system.error();
  if (options.driven_by == Drive::kPressure && system.value().has_mounts()) {
    return Error{"driven_by", "pressures are given and the mounting yields: they would not agree",
                 "a model without play and compliance", "driven_by: position"};
  }
  auto impl = std::unique_ptr<Impl>(
      new Impl{kind, params, options, std::move(system.value()), InputNames(kind, options), {}});
  impl->outputs = OutputNames(kind, params, options);
  return RigModel(std::move(impl));
}

void RigModel::Impl::RunFull(const RigMotion& motion, const std::vector<std::vector<double>>& speed,
                             RigPrediction* out) const {
  const int n = motion.num_samples(), lines = system.num_lines();
  const double h = motion.step_s / options.substeps;
  HingedBeam beam(system, options.beam, motion.t0_s, motion.position_m[0][0],
                  motion.position_m[1][0]);
  double piston[4], force[4];
  std::vector<double> pressure(lines);
  PhsOutputs at;
  at.energy = false;
  at.piston = piston;
  at.force = force;
  at.pressure = pressure.data();
  for (int i = 0; i < n; ++i) {
    const double x1 = motion.position_m[0][i], x2 = motion.position_m[1][i];
    beam.Calc(speed[0][i], speed[1][i], &at);
    for (int c = 0; c < 4; ++c) {
      out->channels[c][i] = piston[c];
      out->channels[4 + c][i] = force[c];
    }
    for (int l = 0; l < lines; ++l) out->channels[8 + l][i] = pressure[l];
    if (i + 1 == n) continue;
    const double v1 = (motion.position_m[0][i + 1] - x1) / motion.step_s;
    const double v2 = (motion.position_m[1][i + 1] - x2) / motion.step_s;
    for (int k = 0; k < options.substeps; ++k) {
      beam.Step(h, x1 + (k + 1) * h * v1, x2 + (k + 1) * h * v2);
    }
  }
}

/// What moves with the actuator behind the load cell.
void AddLoads(const PhsSystem& system, const std::vector<double>& speed, const RigMotion& motion,
              std::vector<double>* load) {
  if (system.loads().empty()) return;
  const std::vector<double> acceleration = AccelerationOf(motion, speed);
  for (const auto& law : system.loads()) {
    law->Add({motion.step_s, acceleration, motion.pressure_Pa, motion.position_m[0], speed,
              motion.t0_s, system.extra()},
             load);
  }
}

/// A rig with one cylinder.
void RigModel::Impl::RunOne(const RigMotion& motion, const std::vector<double>& speed,
                            std::shared_ptr<const KeptRun>* kept, RigPrediction* out) const {
  if (options.driven_by == Drive::kForce) return RunForce(system, options, motion, out);
  if (options.driven_by == Drive::kPressure) {
    out->channels.resize(4, std::vector<double>(speed.size()));
    RunAtPressures(system, motion, speed, {motion.position_m[1], motion.position_m[2]}, out);
  } else {
    RunCylinder(system, options, motion, speed, kept, out);
  }
  AddLoads(system, speed, motion, &out->channels[1]);
}

void RigModel::Impl::RunBare(const RigMotion& motion, const std::vector<std::vector<double>>& speed,
                             std::shared_ptr<const KeptRun>* kept, RigPrediction* out) const {
  if (*kept != nullptr && !(*kept)->channels.empty()) {
    out->channels = (*kept)->channels;
    return;
  }
  if (kind != RigKind::kFull) {
    RunOne(motion, speed[0], kept, out);
  } else if (options.actuators == 4) {
    RunPistons(system, options, motion, speed, out);
  } else {
    RunFull(motion, speed, out);
  }
  if (options.driven_by == Drive::kPosition && ActsBack(kind, params)) {
    *kept = std::make_shared<const KeptRun>(KeptRun{{}, {}, out->channels});
  }
}

Status RigModel::Run(const RigMotion& motion, RigPrediction* prediction) const {
  std::shared_ptr<const KeptRun> kept;
  return Run(motion, prediction, &kept);
}

Status RigModel::Run(const RigMotion& motion, RigPrediction* prediction,
                     std::shared_ptr<const KeptRun>* kept) const {
  if (Status s = CheckMotion(impl_->inputs.size(), motion); !s.ok()) return s;
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
  if (impl_->kind == RigKind::kElement) {
    if (impl_->options.driven_by == Drive::kForce) {
      Status done = RunElementByForce(impl_->system, motion, {}, impl_->options.substeps,
                                      &prediction->channels[0]);
      if (!done.ok()) return done;
    } else {
      RunElementBench(impl_->system, motion, speed[0], &prediction->channels[0], nullptr);
    }
    ApplyBenchInstruments(impl_->system, motion, impl_->options.driven_by, prediction);
    return {};
  }
  impl_->RunBare(motion, speed, kept, prediction);
  ApplyInstruments(impl_->kind, impl_->system, motion.t0_s, motion.step_s, prediction);
  prediction->channels.resize(impl_->outputs.size());  // given pressures are no prediction
  return {};
}

}  // namespace phs::rigs
