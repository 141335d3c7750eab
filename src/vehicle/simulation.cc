#include "vehicle/simulation.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "base/data_path.h"
#include "base/numbers.h"
#include "base/words.h"
#include "phs_model/phs_model.h"
#include "plugin/kept_wheelsets.h"
#include "plugin/model_text.h"
#include "plugin/registry.h"
#include "plugin/settle.h"
#include "vehicle/compose.h"
#include "vehicle/energy_channels.h"
#include "vehicle/stable_step.h"
#include "vehicle/tangent_state.h"

namespace phs::vehicle {
namespace {

using plugin::UserData;

constexpr double kDerailedLateral =
    0.06;  ///< wheelset this far off the centre has left the rails [m]
constexpr double kDerailedTime =
    0.02;  ///< contact at a profile's end or no wheel load for so long [s]
constexpr int kProgressSteps = 500;  ///< between looks at the progress

/// Watches the flags that the plugin leaves in userdata.
class DerailmentWatch {
 public:
  /// Empty while all is well.
  std::string Check(const mjData* d, double h, int num_wheels) {
    if (d->userdata[UserData::kMaxLateral] > kDerailedLateral) {
      return "a wheelset is " + std::to_string(d->userdata[UserData::kMaxLateral] * 1e3) +
             " mm off the track centre";
    }
    beyond_ = d->userdata[UserData::kBeyondProfile] > 0 ? beyond_ + h : 0;
    airborne_ = d->userdata[UserData::kLifted] >= num_wheels ? airborne_ + h : 0;
    if (beyond_ > kDerailedTime)
      return "a wheel runs on the tip of its flange or off the rail head";
    if (airborne_ > 10 * kDerailedTime) return "no wheel touches the rails";
    return "";
  }

 private:
  double beyond_ = 0;
  double airborne_ = 0;
};

/// Processor time of this thread [s]: what the run costs on one core, whatever else is running.
double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What every verb needs: something that runs on rails.
Status CheckWheelsets(const Scenario& scenario, const mjModel* m) {
  if (!plugin::TuplesWithPrefix(m, "wheelset:").empty()) return {};
  return Error{"bogie " + Quoted(scenario.bogie), "names no wheelset",
               "<custom><tuple name=\"wheelset:lead\"> with a body, its spin hinge, its yaw hinge "
               "and, if driven, its motor",
               "see plugin/README.md"};
}

/// MuJoCo reads "nan" as a number; the vehicle would find no rest with it.
Status CheckFinite(const Scenario& scenario, const mjModel* m) {
  const auto check = [&](int type, int id, const char* what, double value) -> Status {
    if (std::isfinite(value)) return {};
    return Error{"bogie " + Quoted(scenario.bogie) + ": " + plugin::ObjectName(m, type, id),
                 std::string("has a ") + what + " that is no number", "finite numbers", ""};
  };
  for (int j = 0; j < m->njnt; ++j) {
    if (Status s = check(mjOBJ_JOINT, j, "stiffness", m->jnt_stiffness[j]); !s.ok()) return s;
  }
  for (int i = 0; i < m->nv; ++i) {
    const double damping = m->dof_damping[i] + m->dof_armature[i];
    if (Status s = check(mjOBJ_JOINT, m->dof_jntid[i], "damping or armature", damping); !s.ok()) {
      return s;
    }
  }
  for (int b = 1; b < m->nbody; ++b) {
    const double mass = m->body_mass[b] + m->body_inertia[3 * b] + m->body_pos[3 * b] +
                        m->body_pos[3 * b + 1] + m->body_pos[3 * b + 2];
    if (Status s = check(mjOBJ_BODY, b, "mass, inertia or position", mass); !s.ok()) return s;
  }
  return {};
}

/// Springs and dampers that the scenario gives instead of the file's.
Status ChangeJoints(const Scenario& scenario, mjModel* m) {
  for (const Scenario::JointChange& change : scenario.joints) {
    const int id = mj_name2id(m, mjOBJ_JOINT, change.joint.c_str());
    if (id < 0 || m->jnt_type[id] == mjJNT_FREE) {
      std::vector<std::string> known;
      for (int j = 0; j < m->njnt; ++j) {
        if (m->jnt_type[j] != mjJNT_FREE) known.push_back(plugin::ObjectName(m, mjOBJ_JOINT, j));
      }
      return Error{"joints: " + Quoted(change.joint), "is no joint of bogie " + scenario.bogie,
                   JoinWords(known), DidYouMean(change.joint, known)};
    }
    if (change.stiffness >= 0) m->jnt_stiffness[id] = change.stiffness;
    if (change.damping >= 0) m->dof_damping[m->jnt_dofadr[id]] = change.damping;
  }
  return {};
}

/// A bogie without a PHS has no use for what a scenario says of one; a wrong name is one all the same.
Status CheckUnusedPhs(const Scenario& scenario) {
  constexpr int kCylinders = 4;
  const std::string& model = scenario.phs.empty() ? phs_model::kDefaultModel : scenario.phs;
  const auto path = FindData("PHS model", "models/phs", model, {".yaml"});
  if (!path.ok()) return path.error();
  const auto& changes = scenario.phs_changes;
  return phs_model::LoadChangedParams(path.value(), changes, "", kCylinders).status();
}

/// A failure at a place that the run never reaches would be none.
Status CheckPlaces(const Scenario& scenario, const rail::Track& track) {
  for (const phs_model::Failure& failure : scenario.phs_changes.failures) {
    if (!(failure.at_m > track.length())) continue;
    return Error{"failures: line " + Quoted(failure.line) + ": at_m",
                 Shortest(failure.at_m) + " m lies beyond the track " + track.name(),
                 "up to " + Shortest(track.length()) + " m", ""};
  }
  return {};
}

}  // namespace

int RunOutcome::Find(const std::string& name) const {
  for (size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Simulation::~Simulation() {
  if (model_ != nullptr) plugin::Detach(model_.get());
}

const plugin::Binding& Simulation::binding() const { return *plugin::Find(model_.get()); }

Result<Simulation> Simulation::Create(const Scenario& scenario, StepCheck check) {
  InstallEngineHandlers();
  auto loaded = ComposeVehicle(scenario);
  if (!loaded.ok()) return loaded.error();
  Simulation sim;
  sim.scenario_ = scenario;
  sim.model_ = std::move(loaded).value();
  if (Status s = CheckWheelsets(scenario, sim.model_.get()); !s.ok()) return s.error();
  if (Status s = CheckFinite(scenario, sim.model_.get()); !s.ok()) return s.error();
  if (scenario.timestep_s != 0) sim.model_->opt.timestep = scenario.timestep_s;
  sim.scenario_.timestep_s = sim.model_->opt.timestep;
  if (Status s = ChangeJoints(scenario, sim.model_.get()); !s.ok()) return s.error();
  plugin::AttachOptions options;
  options.track = scenario.track;
  options.wheel_profile = scenario.wheel;
  options.rail_profile = scenario.rail;
  options.creep_law = scenario.creep;
  options.contact_fineness = scenario.contact_fineness;
  options.phs_model = scenario.phs;
  options.friction = scenario.friction;
  options.speed_m_s = scenario.speed_m_s;
  options.start_s_m = scenario.start_s_m;
  options.phs_changes = scenario.phs_changes;
  options.running = scenario.running;
  options.track_errors = scenario.track_errors;
  options.wear = scenario.wear;
  try {
    if (Status s = plugin::Attach(sim.model_.get(), options); !s.ok()) return s.error();
    if (Status s = CheckPlaces(scenario, sim.binding().track()); !s.ok()) return s.error();
    if (sim.binding().phs().empty()) {
      if (Status s = CheckUnusedPhs(scenario); !s.ok()) return s.error();
    }
    sim.data_.reset(mj_makeData(sim.model_.get()));
    plugin::ResetToStart(sim.model_.get(), sim.data_.get());
    const Eigen::VectorXd scale = ActivationScale(sim.model_.get(), sim.binding());
    double* largest = check == StepCheck::kLargest ? &sim.largest_stable_step_ : nullptr;
    if (Status s = CheckStep(sim.model_.get(), sim.data_.get(), scale, largest); !s.ok()) {
      return s.error();
    }
  } catch (const EngineError& e) {
    return Error{scenario.bogie, std::string("MuJoCo: ") + e.what(), "", ""};
  }
  return sim;
}

Result<RunOutcome> Simulation::Run(const Progress& progress, const OwnInputs& own) {
  mjModel* m = model_.get();
  mjData* d = data_.get();
  plugin::ResetToStart(m, d);
  const plugin::Binding& bound = binding();
  const plugin::Observer observer(m, bound);
  const plugin::KeptWheelsets kept(bound, d);
  RunOutcome run;
  run.channels = observer.channels();
  const std::ptrdiff_t num_observed = std::ssize(run.channels);
  const size_t front_at = static_cast<size_t>(run.Find("s_m"));
  for (const EnergyRow& energy : EnergyChannels()) {
    run.channels.push_back({energy.name, energy.unit, energy.text});
  }
  run.columns.resize(run.channels.size());
  const double h = m->opt.timestep;
  const long record_every = std::max(1L, std::lround(scenario_.record_interval_s / h));
  const double end_s = bound.track().length();
  const long last_step = scenario_.duration_s > 0
                             ? std::lround(scenario_.duration_s / h)
                             : std::lround(2 * (end_s / bound.target_speed()) / h) + 1;
  const int num_wheels = 2 * static_cast<int>(bound.wheelsets().size());
  EnergyKeeper keeper(bound);
  DerailmentWatch watch;
  PhsWatch phs_watch(bound);
  std::vector<double> row(run.channels.size());
  std::optional<OwnInputsInRun> inputs;
  if (own) inputs.emplace(m, d, &observer, own);
  const double begin = ThreadSeconds();
  double front_s = scenario_.start_s_m;
  for (long step = 0; step <= last_step; ++step) {
    const bool record = step % record_every == 0;
    if (record) {
      m->opt.enableflags |= mjENBL_ENERGY;
    } else {
      m->opt.enableflags &= ~mjENBL_ENERGY;
    }
    const double time = d->time;
    try {
      mj_step(m, d);
    } catch (const EngineError& e) {
      run.status = "diverged";
      run.reason = e.what();
      break;
    }
    if (inputs && !inputs->going_on()) {
      run.status = "stopped";
      run.reason = "ended by the caller's own inputs";
      break;
    }
    if (const std::string warning = EngineWarning(d); !warning.empty()) {
      run.status = "diverged";
      run.reason = warning + " at t = " + std::to_string(time) + " s";
      break;
    }
    run.steps = step + 1;
    run.end_time_s = time;
    if (inputs) inputs->AfterStep(m, d);
    keeper.Step(m, d);
    phs_watch.Check(d, time, h);
    if (record) {
      keeper.Read(m, d);
      run.energy = keeper.book();
      observer.Observe(m, d, row.data());
      double* value = row.data() + num_observed;
      for (const EnergyRow& energy : EnergyChannels()) {
        *value++ = energy.value(run.energy, d, bound);
      }
      for (size_t i = 0; i < row.size(); ++i) run.columns[i].push_back(row[i]);
      front_s = row[front_at];
    }
    if (std::string why = watch.Check(d, h, num_wheels); !why.empty()) {
      run.status = "derailed";
      run.reason = why + " at s = " + std::to_string(front_s) + " m";
      break;
    }
    if (record && scenario_.duration_s <= 0 && front_s >= end_s) break;
    if (progress && step % kProgressSteps == 0 &&
        !progress(std::clamp(
            scenario_.duration_s > 0 ? static_cast<double>(step) / last_step : front_s / end_s, 0.0,
            1.0))) {
      run.status = "stopped";
      run.reason = "interrupted";
      break;
    }
  }
  run.warnings = phs_watch.Warnings();
  const double spent = ThreadSeconds() - begin;
  run.real_time_factor = spent > 0 ? run.end_time_s / spent : 0;
  return run;
}

}  // namespace phs::vehicle
