// Models and tracks written for one law each: coned wheels, linear creep, nothing else.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace phs::laws {

/// Straight track on 1067 mm gauge.
inline std::string StraightTrack(double length) {
  return fmt::format(
      "name: law_straight\ngauge_m: 1.067\nsegments:\n  - {{kind: tangent, length_m: {}}}\n",
      length);
}

/// Tangent, transition, arc canted for equilibrium at `speed`.
inline std::string CurvedTrack(double radius, double speed, const std::string& hand = "left") {
  const double base = 1.067 + 0.07;
  const double cant = base * std::sin(std::atan(speed * speed / (9.81 * radius)));
  return fmt::format(
      "name: law_curve\ngauge_m: 1.067\ncant_base_m: {0}\nsegments:\n"
      "  - {{kind: tangent, length_m: 30}}\n  - {{kind: transition, length_m: 60}}\n"
      "  - {{kind: curve, radius_m: {1}, hand: {2}, length_m: 300, cant_m: {3:.9f}}}\n"
      "  - {{kind: transition, length_m: 60}}\n  - {{kind: tangent, length_m: 30}}\n",
      base, radius, hand, cant);
}

/// One free wheelset: boxes that do not spin (light) and the spinning wheelset.
inline std::string FreeWheelset(double mass, double radius) {
  return fmt::format(
      "<mujoco model='free_wheelset'><size nuserdata='96'/>"
      "<option timestep='0.0002' gravity='0 0 -9.81'><flag contact='disable' "
      "constraint='disable'/></option><worldbody><body name='boxes' pos='0 0 {1}'><freejoint/>"
      "<inertial pos='0 0 0' mass='1' diaginertia='0.5 0.5 0.5'/><body name='wheelset'>"
      "<joint name='spin' axis='0 1 0'/><inertial pos='0 0 0' mass='{0}' diaginertia='{2} {3} "
      "{2}'/>"
      "</body></body></worldbody><custom><numeric name='phs_wheel_radius_m' data='{1}'/>"
      "<tuple name='wheelset:lead'><element objtype='body' objname='wheelset'/>"
      "<element objtype='joint' objname='spin'/></tuple></custom>"
      "<keyframe><key name='test'/></keyframe></mujoco>",
      mass, radius, 0.4 * mass, 0.1 * mass);
}

/// Conicity of a coned wheel on a rail head of one radius (Wickens, Fundamentals of Rail Vehicle
/// Dynamics, 2003, section 2.2): the wheelset rolls as it shifts, which moves the contacts.
inline double ConicityOnArc(double cone, double b0, double r0, double rail_radius) {
  return cone * (b0 + rail_radius * cone) / (b0 - r0 * cone);
}

/// Two wheelsets on springs in a light frame, wheelbase 3.1 m, no drives. Light, because weight
/// turns into gravitational and spin forces that the linear formulas leave out.
inline std::string LightBogie(double k_yaw, double k_lateral) {
  std::string axles;
  for (const auto& [name, x] : {std::pair{"lead", 1.55}, std::pair{"trail", -1.55}}) {
    axles += fmt::format(
        "<body name='{0}_boxes' pos='{1} 0 0'>"
        "<joint name='{0}_x' type='slide' axis='1 0 0' stiffness='1e7' damping='2e4'/>"
        "<joint name='{0}_y' type='slide' axis='0 1 0' stiffness='{3}' damping='2e4'/>"
        "<joint name='{0}_z' type='slide' axis='0 0 1' stiffness='1e6' damping='2e4'/>"
        "<joint name='{0}_yaw' type='hinge' axis='0 0 1' stiffness='{2}' damping='1e4'/>"
        "<joint name='{0}_roll' type='hinge' axis='1 0 0' stiffness='1e5' damping='2e3'/>"
        "<inertial pos='0 0 0' mass='50' diaginertia='20 20 20'/><body name='{0}_wheelset'>"
        "<joint name='{0}_spin' axis='0 1 0'/>"
        "<inertial pos='0 0 0' mass='200' diaginertia='80 40 80'/></body></body>",
        name, x, k_yaw, k_lateral);
  }
  std::string tuples;
  for (const char* name : {"lead", "trail"}) {
    tuples += fmt::format(
        "<tuple name='wheelset:{0}'><element objtype='body' objname='{0}_wheelset'/>"
        "<element objtype='joint' objname='{0}_spin'/><element objtype='joint' "
        "objname='{0}_yaw'/></tuple>",
        name);
  }
  return "<mujoco model='light_bogie'><size nuserdata='96'/><compiler angle='radian'/>"
         "<option timestep='0.0002'><flag contact='disable' constraint='disable'/></option>"
         "<worldbody><body name='frame' pos='0 0 0.625'><freejoint/>"
         "<inertial pos='0 0 0' mass='500' diaginertia='300 500 500'/>" +
         axles + "</body></worldbody><custom>" + tuples +
         "</custom><keyframe><key name='test'/></keyframe></mujoco>";
}

}  // namespace phs::laws
