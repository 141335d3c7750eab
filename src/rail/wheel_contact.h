// What is asked of a wheel on its rail and what comes back: parameters, motion, patches, forces.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "rail/creep_law.h"
#include "rail/frames.h"
#include "rail/track.h"
#include "rail/tread_wear.h"

namespace phs::rail {

/// Three humps of overlap, and the ways of reading neighbours as one (contact_search.h).
inline constexpr int kMaxPatches = 6;

/// Contact given by numbers instead of profiles (linear_contact.h), each per wheel.
struct LinearContactParams {
  double conicity = 0.05;          ///< lambda, 0 … 1
  double half_base_m = 0.75;       ///< contact from the track centre, 0.1 … 2 m
  double f11_N = 1e7;              ///< longitudinal creep coefficient, >= 0
  double f22_N = 1e7;              ///< lateral, >= 0
  double f23_Nm = 0;               ///< lateral-spin, >= 0
  double f33_Nm2 = 0;              ///< spin, >= 0
  double limit_N = 0;              ///< friction times load where creep saturates; 0 = never
  double stiffness_N_per_m = 1e9;  ///< vertical, also in tension
  double damping_Ns_per_m = 1e5;   ///< vertical
  double load_N = 0;               ///< static load, reported with the contact force only
  double clearance_m = 0;          ///< shift at which the flange touches
  double flange_N_per_m = 0;       ///< lateral stiffness beyond; 0 = no flange
};

struct WheelRailParams {
  std::optional<LinearContactParams> linear;  ///< takes the place of the profiles
  std::string wheel_profile;                  ///< path: .prw, or a plain y,z table
  std::string rail_profile;                   ///< path: .prr, or a plain y,z table
  TreadWear wear;                             ///< of the wheel profile
  int contact_fineness = 1;                   ///< of the normal contact's grid: 1 … 4
  double gauge = 1.067;                       ///< [m]
  double gauge_height = 0.014;                ///< depth of the gauge points below the rail top [m]
  double rail_cant = 0;  ///< inclination of the rail section, > 0 towards the track [rad]
  double flange_back_distance = 0.992;   ///< between the flange backs [m]
  double flange_back_position = -0.070;  ///< y of the flange back in the wheel profile [m]
  double wheel_radius = 0.625;           ///< at the profile's origin (tape circle) [m]
  double damping_ratio = 0.1;  ///< normal damping: fraction of critical of a wheel's own mass
  double wheel_mass = 1500;    ///< mass that the damping ratio refers to [kg]
  FrictionLaw tread;
  FrictionLaw flange;          ///< used where the contact angle exceeds flange_angle
  double flange_angle = 0.52;  ///< [rad], blended smoothly over +-0.1 rad
  double speed_floor = 0.5;    ///< creepages refer to at least this speed [m/s]
  CreepLawParams creep;
};

/// State of a wheelset in C.
struct WheelsetMotion {
  double lateral = 0;   ///< y_C of the wheelset centre [m]
  double vertical = 0;  ///< z_C of the wheelset centre (negative: it lies above the rails) [m]
  double roll = 0;      ///< [rad]
  double yaw = 0;       ///< [rad]
  Vec3 velocity{};      ///< of the centre against the rail, C axes [m/s]
  Vec3 rotation{};      ///< angular velocity *including spin* against the rail, C axes [rad/s]
  double speed = 0;     ///< reference rolling speed V > 0 [m/s]
};

struct ContactPatch {
  double rail_y = 0, rail_z = 0;    ///< contact point in the rail profile's axes [m]
  double wheel_y = 0, wheel_z = 0;  ///< in the wheel profile's axes [m]
  Vec3 point{};                     ///< from the wheelset centre, C axes [m]
  double angle = 0;     ///< contact angle: slope of the surface, > 0 falling to the track centre
  double approach = 0;  ///< of Hertz's ellipse under this load [m]
  double a = 0, b = 0;  ///< Hertz semi-axes along / across [m]
  double peak_pressure = 0;         ///< [Pa]
  double rolling_radius = 0;        ///< distance of the point from the axle [m]
  double normal = 0;                ///< N >= 0 [N]
  double xi = 0, eta = 0, phi = 0;  ///< creepages (CONTACT's sign), spin in 1/m
  CreepForce creep;     ///< on the rail, CONTACT's sign and axes (x forward, y in plane outward)
  double friction = 0;  ///< coefficient in use
  double stored_energy = 0;  ///< elastic [J]
  /// Share in (0, 1]: below 1 while two patches grow into one; normal, creep and stored_energy are
  /// those shares, axes and pressure those of the whole patch.
  double weight = 1;
  bool climbs = false;  ///< at the end of a profile, or up the flange
};

struct WheelRailForces {
  int count = 0;  ///< entries of `patch`, 0 = wheel lifted
  std::array<ContactPatch, kMaxPatches> patch{};
  Vec3 force{};              ///< on the wheelset, C axes [N]
  Vec3 moment{};             ///< about the wheelset centre, C axes [N m]
  Vec3 elastic_force{};      ///< the part of `force` that stores energy (normal, undamped)
  Vec3 elastic_moment{};     ///< its moment about the wheelset centre
  double t_gamma = 0;        ///< sum of |Tx xi| + |Ty eta| [N]
  double t_gamma_spin = 0;   ///< sum of |Mz phi| [N]
  double creep_power = 0;    ///< power lost to slip, >= 0 [W]
  double damping_power = 0;  ///< power lost to normal damping (and support damping), >= 0 [W]
  double stored_energy = 0;  ///< contact and support [J]
  double rail_lateral = 0, rail_vertical = 0;  ///< elastic displacement of the rail, C axes [m]
  bool beyond_profile = false;  ///< a contact lies at the end of a profile: climbing or fallen off
  /// Places in contact: patches that grow into one count as the nearer number.
  int contacts() const;
};

/// One patch as its position alone makes it: what its forces at any speed need (C axes).
struct PressedPatch {
  Vec3 forward, lateral, normal{};  ///< axes of the contact plane
  Vec3 push{};                      ///< direction in which the patch presses the rail, unit
  Vec3 turn{};                      ///< its moment about the wheelset centre, per unit of force [m]
  double elastic = 0;               ///< Hertz force of the whole patch [N]
  double damper = 0;                ///< normal damping of the whole patch [N s/m]
};

/// What the creep law keeps of the patches of a pressed wheel between calls at nearby speeds.
using WheelMemo = std::array<CreepMemo, kMaxPatches>;

/// A wheel pressed on its rail: filled by WheelRail::Press, read by WheelRail::CalcForces.
struct PressedWheel {
  std::array<PressedPatch, kMaxPatches> patch;
};

/// How the forces of a wheel resist its speed: a sum of dampers, each along one wrench,
///   wrench on the wheelset -= coefficient (force . v + moment . omega) (force; moment),
/// with v the velocity of the wheelset's centre and omega its rotation. The symmetric part of the
/// slope of creep and normal forces, C axes.
struct WheelDamping {
  struct Damper {
    Vec3 force, moment;
    double coefficient;  ///< >= 0 [N s/m]
  };
  int count = 0;
  std::array<Damper, 3UL * kMaxPatches> damper;
};

/// Where rigid bodies touch.
struct TouchPoint {
  bool found = false;
  double height = 0;   ///< z_C of the wheelset centre [m]
  double rail_y = 0;   ///< in the rail profile's axes [m]
  double wheel_y = 0;  ///< in the wheel profile's axes [m]
  double angle = 0;    ///< contact angle, > 0 falling to the track centre [rad]
  double radius = 0;   ///< rolling radius [m]
};

}  // namespace phs::rail
