#include "plugin/observer.h"

#include <algorithm>
#include <cmath>

#include "plugin/tendon_forces.h"

namespace phs::plugin {
namespace {

using rail::ContactPatch;
using rail::Side;
using rail::WheelRailForces;

/// Guiding force Y and wheel load Q of one wheel, in track axes: Y > 0 = the wheel pushes the rail
/// outwards (to the field side), Q > 0 downwards. The force on the rail is minus that on the wheel.
struct WheelLoad {
  double y = 0;
  double q = 0;
};
WheelLoad LoadOf(const WheelRailForces& wheel) { return {-wheel.force[1], -wheel.force[2]}; }

/// Creep force of all patches over what friction allows.
double AdhesionUsed(const WheelRailForces& wheel) {
  double used = 0;
  double limit = 0;
  for (int k = 0; k < wheel.count; ++k) {
    const ContactPatch& p = wheel.patch[k];
    used += std::hypot(p.creep.x, p.creep.y);
    limit += p.friction * p.normal;
  }
  return limit > 0 ? used / limit : 0;
}

/// Yaw moment about the wheelset's vertical axis from one PHS, split into its parts.
struct PhsMoment {
  double pressure = 0;
  double friction = 0;
};

PhsMoment YawMoment(const mjModel* m, const mjData* d, const PhsBinding& phs, const PhsState& state,
                    int yaw_dof) {
  PhsMoment moment;
  for (size_t i = 0; i < phs.cylinder.size(); ++i) {
    const double arm = -d->actuator_moment[phs.cylinder[i] * m->nv + yaw_dof];
    moment.friction += arm * state.friction_force[i];
    moment.pressure += arm * (state.force[i] - state.friction_force[i]);
  }
  return moment;
}

double JointPosition(const mjModel* m, const mjData* d, int joint) {
  return joint < 0 ? 0.0 : d->qpos[m->jnt_qposadr[joint]];
}

/// Spring and damper of a joint and of the linkages that end on it.
double JointForce(const mjModel* m, const mjData* d, int joint) {
  if (joint < 0) return 0.0;
  const int dof = m->jnt_dofadr[joint];
  double force = -m->jnt_stiffness[joint] *
                     (JointPosition(m, d, joint) - m->qpos_spring[m->jnt_qposadr[joint]]) -
                 m->dof_damping[dof] * d->qvel[dof];
  ForEachTendonDof(m, d, [&](int t, int moved, double moment) {
    if (moved != dof) return;
    force += moment * (TendonSpringForce(m, d, t) - m->tendon_damping[t] * d->ten_velocity[t]);
  });
  return force;
}

double Largest(const WheelRailForces& wheel, double ContactPatch::*member) {
  double at_largest = 0;
  double load = 0;
  for (int k = 0; k < wheel.count; ++k) {
    if (wheel.patch[k].normal > load) {
      load = wheel.patch[k].normal;
      at_largest = wheel.patch[k].*member;
    }
  }
  return at_largest;
}

double FlangeLoad(const WheelRailForces& wheel, double flange_angle) {
  double load = 0;
  for (int k = 0; k < wheel.count; ++k) {
    if (std::abs(wheel.patch[k].angle) > flange_angle) load += wheel.patch[k].normal;
  }
  return load;
}

int HeaviestBody(const mjModel* m) {
  return static_cast<int>(std::max_element(m->body_mass, m->body_mass + m->nbody) - m->body_mass);
}

}  // namespace

std::vector<BogiePair> FindBogies(const Binding& binding) {
  const auto index_of = [&](const std::string& name) {
    for (size_t i = 0; i < binding.wheelsets().size(); ++i) {
      if (binding.wheelsets()[i].name == name) return static_cast<int>(i);
    }
    return -1;
  };
  std::vector<BogiePair> bogies;
  for (size_t i = 0; i < binding.wheelsets().size(); ++i) {
    const std::string& name = binding.wheelsets()[i].name;
    if (name.size() < 4 || name.compare(name.size() - 4, 4, "lead") != 0) continue;
    const std::string prefix = name.substr(0, name.size() - 4);
    const int trail = index_of(prefix + "trail");
    if (trail >= 0) bogies.push_back({prefix, static_cast<int>(i), trail});
  }
  return bogies;
}

void Observer::Name(const std::string& name, const std::string& unit,
                    const std::string& description) {
  channels_.push_back({name, unit, description});
}

void Observer::NameWheelset(const std::string& name) {
  Name(name + "_lateral_m", "m", "offset of the centre from the track centre line, > 0 left");
  Name(name + "_angle_of_attack_rad", "rad", "yaw against the radial direction of the track");
  Name(name + "_yaw_rad", "rad", "yaw against the bogie frame");
  Name(name + "_sum_Y_N", "N", "lateral force of both wheels on the track, > 0 right");
  Name(name + "_X_N", "N", "longitudinal force of both rails on the wheelset, > 0 forward");
  Name(name + "_slip", "1", "spin times tape circle radius over speed, less 1; > 0 driving");
  Name(name + "_steering_moment_Nm", "N m", "yaw moment of the wheel-rail forces");
  Name(name + "_primary_moment_Nm", "N m", "yaw moment of the primary suspension and links");
  Name(name + "_phs_pressure_moment_Nm", "N m", "yaw moment of the cylinder pressures");
  Name(name + "_phs_friction_moment_Nm", "N m", "yaw moment of the cylinder friction");
  Name(name + "_x_m", "m", "world position of the centre");
  Name(name + "_y_m", "m", "world position of the centre");
  Name(name + "_heading_rad", "rad", "heading of the wheelset in the world");
  for (const char* side : {"_left", "_right"}) {
    const std::string wheel = name + side;
    Name(wheel + "_Y_N", "N", "guiding force, > 0 pushes the rail outwards");
    Name(wheel + "_Q_N", "N", "wheel load");
    Name(wheel + "_Y_over_Q", "1", "Y/Q");
    Name(wheel + "_X_N", "N", "longitudinal force of the rail on the wheel, > 0 forward");
    Name(wheel + "_adhesion_used", "1", "creep force over friction limit, sum over the patches");
    Name(wheel + "_T_gamma_N", "N", "wear number without spin term");
    Name(wheel + "_T_gamma_spin_N", "N", "spin term of the wear number");
    Name(wheel + "_contacts", "1", "contact patches");
    Name(wheel + "_contact_angle_rad", "rad", "contact angle of the most loaded patch");
    Name(wheel + "_contact_y_m", "m", "position of that patch on the wheel profile");
    Name(wheel + "_flange_N", "N", "normal force on the flange");
  }
}

void Observer::NamePhs(const PhsBinding& phs, const std::string& prefix) {
  for (const std::string& name : phs.system->cylinder_names()) {
    const std::string cylinder = prefix + "cylinder_" + name;
    Name(cylinder + "_force_N", "N", "tension force");
    Name(cylinder + "_piston_m", "m", "piston displacement, > 0 extension");
    Name(cylinder + "_friction_N", "N", "friction force");
  }
  for (const std::string& name : phs.system->line_names()) {
    Name(prefix + "line_" + name + "_pressure_Pa", "Pa", "absolute pressure");
  }
}

Observer::Observer(const mjModel* m, const Binding& binding)
    : binding_(binding), car_body_(HeaviestBody(m)), bogies_(FindBogies(binding)) {
  Name("t_s", "s", "time");
  Name("s_m", "m", "arc length of the leading wheelset");
  Name("speed_m_s", "m/s", "speed along the track");
  Name("curvature_1_m", "1/m", "of the track under the leading wheelset, > 0 left");
  Name("cant_rad", "rad", "of the track under the leading wheelset, > 0 right rail raised");
  Name("car_body_lateral_speed_m_s", "m/s", "of its centre of mass, own axes, > 0 left");
  Name("car_body_vertical_speed_m_s", "m/s", "of its centre of mass, own axes, > 0 up");
  for (const WheelsetBinding& w : binding.wheelsets()) NameWheelset(w.name);
  for (const BogiePair& bogie : bogies_) {
    Name(bogie.prefix + "bending_rad", "rad", "yaw of lead minus yaw of trail against the frame");
    Name(bogie.prefix + "shear_rad", "rad", "mean yaw of both axles against the frame");
  }
  const bool several = binding.phs().size() > 1;
  for (const PhsBinding& phs : binding.phs()) NamePhs(phs, several ? phs.name + "_" : "");
}

void Observer::Observe(const mjModel* m, const mjData* d, double* row) const {
  double* out = row;
  std::vector<WheelsetState> wheelsets;
  for (size_t i = 0; i < binding_.wheelsets().size(); ++i) {
    wheelsets.push_back(binding_.CalcWheelset(m, d, static_cast<int>(i)));
  }
  std::vector<PhsState> phs;
  for (size_t i = 0; i < binding_.phs().size(); ++i) {
    phs.push_back(binding_.CalcPhs(m, d, static_cast<int>(i)));
  }
  // Steps of a run are named after the state they start from.
  *out++ = d->time;
  const WheelsetState* first = nullptr;
  for (const WheelsetState& w : wheelsets) {
    if (first == nullptr || w.frame.s > first->frame.s) first = &w;
  }
  *out++ = first == nullptr ? 0 : first->frame.s;
  *out++ = first == nullptr ? 0 : first->speed;
  *out++ = first == nullptr ? 0 : first->frame.curvature;
  *out++ = first == nullptr ? 0 : first->frame.cant;
  mjtNum speed[6];
  mj_objectVelocity(m, d, mjOBJ_BODY, car_body_, speed, 1);
  *out++ = speed[4];
  *out++ = speed[5];
  for (size_t i = 0; i < wheelsets.size(); ++i) {
    const WheelsetBinding& w = binding_.wheelsets()[i];
    const WheelsetState& state = wheelsets[i];
    const WheelLoad left = LoadOf(state.wheel[0]);
    const WheelLoad right = LoadOf(state.wheel[1]);
    *out++ = state.lateral;
    *out++ = state.yaw;
    *out++ = JointPosition(m, d, w.yaw_joint);
    *out++ = right.y - left.y;
    *out++ = state.wheel[0].force[0] + state.wheel[1].force[0];
    *out++ = state.speed > 0
                 ? state.spin * binding_.wheel_rail().params().wheel_radius / state.speed - 1
                 : 0.0;
    *out++ = state.moment_T[2];
    *out++ = JointForce(m, d, w.yaw_joint);
    PhsMoment moment;
    if (w.yaw_joint >= 0) {
      for (size_t k = 0; k < phs.size(); ++k) {
        const PhsMoment part =
            YawMoment(m, d, binding_.phs()[k], phs[k], m->jnt_dofadr[w.yaw_joint]);
        moment.pressure += part.pressure;
        moment.friction += part.friction;
      }
    }
    *out++ = moment.pressure;
    *out++ = moment.friction;
    *out++ = state.centre[0];
    *out++ = state.centre[1];
    *out++ = state.frame.heading + state.yaw;
    for (const WheelRailForces& wheel : state.wheel) {
      const WheelLoad load = LoadOf(wheel);
      *out++ = load.y;
      *out++ = load.q;
      *out++ = load.q > 0 ? load.y / load.q : 0.0;
      *out++ = wheel.force[0];
      *out++ = AdhesionUsed(wheel);
      *out++ = wheel.t_gamma;
      *out++ = wheel.t_gamma_spin;
      *out++ = wheel.contacts();
      *out++ = Largest(wheel, &ContactPatch::angle);
      *out++ = Largest(wheel, &ContactPatch::wheel_y);
      *out++ = FlangeLoad(wheel, binding_.wheel_rail().params().flange_angle);
    }
  }
  for (const BogiePair& bogie : bogies_) {
    const double lead = JointPosition(m, d, binding_.wheelsets()[bogie.lead].yaw_joint);
    const double trail = JointPosition(m, d, binding_.wheelsets()[bogie.trail].yaw_joint);
    *out++ = lead - trail;
    *out++ = (lead + trail) / 2;
  }
  for (const PhsState& state : phs) {
    for (size_t i = 0; i < state.force.size(); ++i) {
      *out++ = state.force[i];
      *out++ = state.piston[i];
      *out++ = state.friction_force[i];
    }
    for (const double pressure : state.pressure) *out++ = pressure;
  }
}

PhsState Binding::CalcPhs(const mjModel*, const mjData* d, int index) const {
  const PhsBinding& p = phs_[index];
  PhsState s;
  for (int i = 0; i < p.system->num_cylinders(); ++i) {
    const size_t at = static_cast<size_t>(i);
    s.displacement.push_back(d->actuator_length[p.cylinder[at]] - p.length0[at]);
    s.speed.push_back(d->userdata[p.speeds_at + i]);
  }
  for (int i = 0; i < p.system->num_states(); ++i) s.state.push_back(d->userdata[p.states_at + i]);
  for (auto* v : {&s.force, &s.pressure_force, &s.friction_force, &s.piston, &s.p_bore, &s.p_rod}) {
    v->resize(p.cylinder.size());
  }
  s.pressure.resize(p.system->num_lines());
  hydraulics::PhsOutputs out{s.force.data(),  s.pressure_force.data(), s.friction_force.data(),
                             s.piston.data(), s.p_bore.data(),         s.p_rod.data(),
                             nullptr,         s.pressure.data()};
  p.system->Calc(d->time, s.displacement.data(), s.speed.data(), s.state.data(), &out);
  s.stored_energy = out.stored_energy;
  s.lost_power = out.lost_power;
  return s;
}

}  // namespace phs::plugin
