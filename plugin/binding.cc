#include "plugin/binding.h"

#include <algorithm>
#include <cmath>

#include "base/data_path.h"
#include "phs_model/phs_model.h"
#include "plugin/dof_chain.h"
#include "plugin/model_checks.h"
#include "plugin/model_mark.h"
#include "plugin/model_text.h"

namespace phs::plugin {
namespace {

constexpr double kSpeedHoldTime = 0.5;  ///< time constant of the speed hold [s]
constexpr double kDefaultFriction = 0.3;

std::string Chosen(const std::string& option, const mjModel* m, const std::string& custom,
                   const std::string& otherwise) {
  return option.empty() ? CustomText(m, custom).value_or(otherwise) : option;
}

/// A profile file by name or path; generated profiles ("cone:1/40") have no file.
Result<std::string> FindProfile(const std::string& kind, const std::string& name) {
  if (name.find(':') != std::string::npos) return name;
  return FindData(kind, "models/profiles", name, {".prw", ".prr", ".yaml", ".csv"});
}

/// Contact given by numbers (phs_contact = "linear"): one custom numeric per parameter.
rail::LinearContactParams LinearContact(const mjModel* m) {
  rail::LinearContactParams p;
  const std::pair<const char*, double*> values[] = {
      {"phs_linear_conicity", &p.conicity},
      {"phs_linear_half_base_m", &p.half_base_m},
      {"phs_linear_f11_N", &p.f11_N},
      {"phs_linear_f22_N", &p.f22_N},
      {"phs_linear_f23_Nm", &p.f23_Nm},
      {"phs_linear_f33_Nm2", &p.f33_Nm2},
      {"phs_linear_limit_N", &p.limit_N},
      {"phs_linear_stiffness_N_per_m", &p.stiffness_N_per_m},
      {"phs_linear_damping_Ns_per_m", &p.damping_Ns_per_m},
      {"phs_linear_load_N", &p.load_N},
      {"phs_linear_clearance_m", &p.clearance_m},
      {"phs_linear_flange_N_per_m", &p.flange_N_per_m}};
  for (const auto& [name, value] : values) *value = CustomNumber(m, name).value_or(*value);
  return p;
}

/// Dofs that may move an actuator: those of the bodies at both ends of its tendon.
std::vector<int> DofsOfActuator(const mjModel* m, int actuator) {
  std::vector<char> moves(static_cast<size_t>(m->nv), 0);
  const int id = m->actuator_trnid[2 * actuator];
  bool known = false;
  if (m->actuator_trntype[actuator] == mjTRN_TENDON) {
    known = true;
    for (int k = 0; k < m->tendon_num[id]; ++k) {
      const int wrap = m->tendon_adr[id] + k;
      if (m->wrap_type[wrap] != mjWRAP_SITE) known = false;
      if (!known) break;
      for (const int dof : DofChain(m, m->site_bodyid[m->wrap_objid[wrap]])) {
        moves[static_cast<size_t>(dof)] = 1;
      }
    }
  }
  std::vector<int> dofs;
  for (int i = 0; i < m->nv; ++i) {
    if (!known || moves[static_cast<size_t>(i)]) dofs.push_back(i);
  }
  return dofs;
}

}  // namespace

bool Binding::Concerns(const mjModel* m) { return MarkSlot(m) >= 0; }

Result<std::unique_ptr<Binding>> Binding::Create(mjModel* m, const AttachOptions& options) {
  if (m->opt.integrator == mjINT_IMPLICIT) {
    return Error{"MJCF <option integrator>", "is 'implicit'", "Euler, RK4",
                 "Euler takes creep and dampers implicitly here"};
  }
  if ((m->opt.disableflags & (mjDSBL_PASSIVE | mjDSBL_ACTUATION)) != 0) {
    return Error{"MJCF <flag>", "switches passive forces or actuation off",
                 "passive=\"enable\" actuation=\"enable\"", ""};
  }
  if (Status s = CheckModel(m, options); !s.ok()) return s.error();
  auto binding = std::make_unique<Binding>();
  if (Status s = binding->BindWheelsets(m); !s.ok()) return s.error();
  if (!binding->wheelsets_.empty()) {
    if (Status s = binding->LoadRail(m, options); !s.ok()) return s.error();
  }
  if (Status s = binding->BindCoupler(m, options); !s.ok()) return s.error();
  if (Status s = binding->BindPhs(m, options); !s.ok()) return s.error();
  auto elements = FindElements(m);
  if (!elements.ok()) return elements.error();
  binding->elements_ = std::move(elements).value();
  binding->ancestors_ = AncestorsOf(m);
  return binding;
}

Status Binding::LoadRail(mjModel* m, const AttachOptions& options) {
  auto track_path = FindData("track", "models/tracks",
                             Chosen(options.track, m, "phs_track", "straight"), {".yaml"});
  if (!track_path.ok()) return track_path.error();
  target_speed_ = CustomNumber(m, "phs_speed_m_s").value_or(0);
  if (options.speed_m_s != AttachOptions::kUnset) target_speed_ = options.speed_m_s;
  auto track = rail::Track::Load(track_path.value(), false, options.track_errors, target_speed_);
  if (!track.ok()) return track.error();
  track_ = std::make_unique<rail::Track>(std::move(track).value());

  friction_ = CustomNumber(m, "phs_friction").value_or(kDefaultFriction);
  if (std::isfinite(track_->friction())) friction_ = track_->friction();

  rail::WheelRailParams params;
  params.tread.coefficient = friction_;
  params.flange.coefficient = friction_;
  rail::FrictionSettings friction = options.friction;
  friction.condition = Chosen(friction.condition, m, "phs_friction_condition", "");
  if (Status s = rail::ApplyFriction(friction, &params); !s.ok()) return s;
  friction_ = params.tread.coefficient;
  const std::string contact = CustomText(m, "phs_contact").value_or("profiles");
  if (contact != "profiles" && contact != "linear") {
    return Error{"MJCF text 'phs_contact'", "is '" + contact + "'", "profiles, linear", ""};
  }
  if (contact == "linear") params.linear = LinearContact(m);
  auto wheel = FindProfile("wheel profile", Chosen(options.wheel_profile, m, "phs_wheel", "S1002"));
  if (!wheel.ok()) return wheel.error();
  params.wheel_profile = wheel.value();
  auto rail = FindProfile("rail profile", Chosen(options.rail_profile, m, "phs_rail", "UIC60"));
  if (!rail.ok()) return rail.error();
  params.rail_profile = rail.value();
  params.wear = options.wear;
  params.contact_fineness = options.contact_fineness;
  params.gauge = track_->gauge();
  params.gauge_height = track_->gauge_height();
  // Clearance between flange and gauge line as on 1435 mm with 1360 mm between the flange backs.
  params.flange_back_distance =
      CustomNumber(m, "phs_flange_back_m").value_or(track_->gauge() - 0.075);
  params.wheel_radius = CustomNumber(m, "phs_wheel_radius_m").value_or(params.wheel_radius);
  const std::string creep = Chosen(options.creep_law, m, "phs_creep", params.creep.method);
  if (Status s = rail::ChooseCreepLaw(creep, &params.creep); !s.ok()) return s;
  auto wheel_rail = rail::WheelRail::Create(params);
  if (!wheel_rail.ok()) return wheel_rail.error();
  wheel_rail_ = std::make_unique<rail::WheelRail>(std::move(wheel_rail).value());

  start_s_ = options.start_s_m == AttachOptions::kUnset ? 1.0 : options.start_s_m;
  const int driven = static_cast<int>(std::count_if(
      wheelsets_.begin(), wheelsets_.end(), [](const auto& w) { return w.drive_actuator >= 0; }));
  root_body_ = m->body_rootid[wheelsets_[0].body];
  if (driven > 0) {
    speed_gain_ = m->body_subtreemass[root_body_] * params.wheel_radius / (driven * kSpeedHoldTime);
  }
  return {};
}

Status Binding::BindWheelsets(mjModel* m) {
  for (const NamedTuple& tuple : TuplesWithPrefix(m, "wheelset:")) {
    WheelsetBinding w;
    w.name = tuple.name;
    const std::vector<int> bodies = tuple.Ids(mjOBJ_BODY);
    const std::vector<int> joints = tuple.Ids(mjOBJ_JOINT);
    const std::vector<int> drives = tuple.Ids(mjOBJ_ACTUATOR);
    const std::string where = "MJCF tuple 'wheelset:" + tuple.name + "'";
    if (bodies.size() != 1 || joints.empty() || m->jnt_type[joints[0]] != mjJNT_HINGE) {
      return Error{where, "needs one body and its spin hinge",
                   "elements: body, hinge joint, optional primary yaw joint, optional actuator",
                   "see bogie_xml/shared/settings.xml"};
    }
    w.body = bodies[0];
    w.spin_dof = m->jnt_dofadr[joints[0]];
    if (m->jnt_bodyid[joints[0]] != w.body) {
      return Error{where,
                   "joint '" + ObjectName(m, mjOBJ_JOINT, joints[0]) +
                       "' is not a joint of body '" + ObjectName(m, mjOBJ_BODY, w.body) + "'",
                   "the hinge about which this body spins", ""};
    }
    if (joints.size() > 1) w.yaw_joint = joints[1];
    if (!drives.empty()) w.drive_actuator = drives[0];
    w.dofs = DofChain(m, w.body);
    if (static_cast<int>(w.dofs.size()) > kMaxChain) {
      return Error{where, "moves with " + std::to_string(w.dofs.size()) + " freedoms",
                   "at most " + std::to_string(kMaxChain), ""};
    }
    wheelsets_.push_back(std::move(w));
  }
  return {};
}

Status Binding::BindCoupler(const mjModel* m, const AttachOptions& options) {
  running_ = options.running;
  if (!running_.active) return {};
  coupler_site_ = mj_name2id(m, mjOBJ_SITE, "coupler");
  if (coupler_site_ < 0) {
    return Error{"MJCF site 'coupler'", "is missing: the train's force acts there",
                 "<site name=\"coupler\" pos=\"…\"/> in the frame or the car body", ""};
  }
  coupler_dofs_ = DofChain(m, m->site_bodyid[coupler_site_]);
  return {};
}

Status Binding::BindPhs(mjModel* m, const AttachOptions& options) {
  int next = UserData::kHeader + m->nv + m->nq;
  for (const NamedTuple& tuple : TuplesWithPrefix(m, "phs:")) {
    PhsBinding p;
    p.name = tuple.name;
    const std::string where = "MJCF tuple 'phs:" + tuple.name + "'";
    const std::string model =
        Chosen(options.phs_model, m, "phs:" + tuple.name, phs_model::kDefaultModel);
    auto path = FindData("PHS model", "models/phs", model, {".yaml"});
    if (!path.ok()) return path.error();
    p.model_path = path.value();
    const std::vector<int> ids = tuple.Ids(mjOBJ_ACTUATOR);
    auto system = phs_model::LoadPhsSystem(p.model_path, options.phs_changes, p.name,
                                           static_cast<int>(ids.size()));
    if (!system.ok()) return system.error();
    p.system = std::make_shared<const hydraulics::PhsSystem>(std::move(system).value());
    const int num_cylinders = p.system->num_cylinders();
    if (num_cylinders > kMaxCylinders || p.system->num_lines() > kMaxLines ||
        p.system->num_states() > kMaxStates) {
      return Error{p.model_path, "has too many cylinders, lines or states",
                   "at most " + std::to_string(kMaxCylinders) + " cylinders, " +
                       std::to_string(kMaxLines) + " lines, " + std::to_string(kMaxStates) +
                       " states in one system",
                   "split it into several systems"};
    }
    if (static_cast<int>(ids.size()) < num_cylinders) {
      return Error{where,
                   "names " + std::to_string(ids.size()) + " actuators, PHS model '" + model +
                       "' has " + std::to_string(num_cylinders) + " cylinders",
                   "one actuator per cylinder, in its order", ""};
    }
    for (int i = 0; i < num_cylinders; ++i) {
      const int a = ids[i];
      const std::string name = ObjectName(m, mjOBJ_ACTUATOR, a);
      if (!IsCylinder(m, a)) {
        return Error{"MJCF actuator '" + name + "'", "is no PHS cylinder",
                     "a general actuator on a tendon or slide joint with biastype=\"user\"", ""};
      }
      p.cylinder.push_back(a);
      p.length0.push_back(m->actuator_length0[a]);
      p.dofs.push_back(DofsOfActuator(m, a));
    }
    for (size_t i = static_cast<size_t>(num_cylinders); i < ids.size(); ++i) {
      if (!IsCylinder(m, ids[i])) continue;  // carries a state
      return Error{where,
                   "has the cylinder '" + ObjectName(m, mjOBJ_ACTUATOR, ids[i]) + "', PHS model '" +
                       model + "' only " + std::to_string(num_cylinders),
                   "a model of as many cylinders, or of a quarter rig", ""};
    }
    for (int a : ids) {
      if (m->actuator_dyntype[a] == mjDYN_USER) p.state_actuator.push_back(a);
    }
    const int num_states = p.system->num_states();
    if (static_cast<int>(p.state_actuator.size()) < num_states) {
      return Error{where,
                   "carries " + std::to_string(p.state_actuator.size()) + " states, PHS model '" +
                       model + "' has " + std::to_string(num_states),
                   "one actuator with dyntype=\"user\" per state",
                   "append " + std::to_string(num_states - p.state_actuator.size()) +
                       " state carriers (phs simulate does so by itself)"};
    }
    p.state_actuator.resize(num_states);
    p.forces_at = next;
    p.speeds_at = p.forces_at + num_cylinders;
    p.rates_at = p.speeds_at + num_cylinders;
    p.states_at = p.rates_at + num_states;
    p.pistons_at = p.states_at + num_states;
    p.pressures_at = p.pistons_at + num_cylinders;
    next = p.pressures_at + p.system->num_lines();
    phs_.push_back(std::move(p));
  }
  if (next > m->nuserdata) {
    return Error{
        "MJCF <size nuserdata>",
        "is " + std::to_string(m->nuserdata) + ", the plugin needs " + std::to_string(next),
        "at least " + std::to_string(next),
        "write <size nuserdata=\"" + std::to_string(next) + "\"/>"};
  }
  owner_.assign(m->nu, nullptr);
  cylinder_at_.assign(m->nu, -1);
  rate_at_.assign(m->nu, -1);
  for (const PhsBinding& p : phs_) {
    for (size_t i = 0; i < p.cylinder.size(); ++i) {
      owner_[p.cylinder[i]] = &p;
      cylinder_at_[p.cylinder[i]] = p.forces_at + static_cast<int>(i);
    }
    for (size_t i = 0; i < p.state_actuator.size(); ++i) {
      owner_[p.state_actuator[i]] = &p;
      rate_at_[p.state_actuator[i]] = p.rates_at + static_cast<int>(i);
    }
  }
  return {};
}

}  // namespace phs::plugin
