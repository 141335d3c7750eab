#include "rail/linear_contact.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "rail/wear.h"

namespace phs::rail {
namespace {

/// What is left of the linear creep force of size `linear` at the limit.
double Saturation(double linear, double limit) {
  if (!(limit > 0) || linear <= 0) return 1;
  const double u = linear / limit;
  return u < 3 ? 1 - u / 3 + u * u / 27 : 1 / u;
}

CreepForce Creep(const LinearContactParams& p, const ContactPatch& patch) {
  CreepForce force{-p.f11_N * patch.xi, -p.f22_N * patch.eta - p.f23_Nm * patch.phi,
                   p.f23_Nm * patch.eta - p.f33_Nm2 * patch.phi};
  const double left = Saturation(std::hypot(force.x, force.y), p.limit_N);
  force.x *= left;
  force.y *= left;
  return force;
}

}  // namespace

Status Validate(const LinearContactParams& p) {
  const struct {
    const char* name;
    double value, low, high;
  } checks[] = {{"conicity", p.conicity, 0, 1},
                {"half_base_m", p.half_base_m, 0.1, 2},
                {"f11_N", p.f11_N, 0, 1e9},
                {"f22_N", p.f22_N, 0, 1e9},
                {"f23_Nm", p.f23_Nm, 0, 1e9},
                {"f33_Nm2", p.f33_Nm2, 0, 1e9},
                {"limit_N", p.limit_N, 0, 1e9},
                {"stiffness_N_per_m", p.stiffness_N_per_m, 1e3, 1e13},
                {"damping_Ns_per_m", p.damping_Ns_per_m, 0, 1e12},
                {"load_N", p.load_N, 0, 1e7},
                {"clearance_m", p.clearance_m, 0, 1},
                {"flange_N_per_m", p.flange_N_per_m, 0, 1e12}};
  for (const auto& c : checks) {
    if (c.value >= c.low && c.value <= c.high) continue;
    return Error{std::string("linear contact ") + c.name, "is " + std::to_string(c.value),
                 std::to_string(c.low) + " … " + std::to_string(c.high), ""};
  }
  return {};
}

void CalcLinearContact(const LinearContactParams& p, double radius, double speed_floor,
                       const WheelsetMotion& motion, WheelRailForces* out,
                       WheelDamping* damping) noexcept {
  *out = WheelRailForces{};
  out->count = 1;
  ContactPatch& patch = out->patch[0];
  patch.rolling_radius = radius + p.conicity * motion.lateral;
  // On the wheel's tread, which rolls with the wheelset: its distance from the axle stays the
  // rolling radius, or the spin would give a rolled wheelset a creepage.
  patch.point = {0, p.half_base_m, patch.rolling_radius + p.half_base_m * motion.roll};
  const Vec3& w = motion.rotation;
  const Vec3& r = patch.point;
  const Vec3 velocity = {motion.velocity[0] + w[1] * r[2] - w[2] * r[1],
                         motion.velocity[1] + w[2] * r[0] - w[0] * r[2],
                         motion.velocity[2] + w[0] * r[1] - w[1] * r[0]};
  const double reference = std::max(motion.speed, speed_floor);
  patch.xi = -velocity[0] / reference;
  patch.eta = -velocity[1] / reference;
  patch.phi = -w[2] / reference;
  patch.creep = Creep(p, patch);

  patch.approach = motion.vertical + p.half_base_m * motion.roll + radius;
  const double elastic = p.stiffness_N_per_m * patch.approach;
  const double damper = p.damping_Ns_per_m * velocity[2];
  patch.normal = std::max(0.0, p.load_N + elastic + damper);
  const double beyond = p.flange_N_per_m > 0 ? std::max(0.0, motion.lateral - p.clearance_m) : 0.0;
  patch.stored_energy = 0.5 * p.stiffness_N_per_m * patch.approach * patch.approach +
                        0.5 * p.flange_N_per_m * beyond * beyond;

  // The load balances a weight that the model may leave out (gravity off): it is reported, not
  // applied.
  out->elastic_force = {0, -p.flange_N_per_m * beyond, -elastic};
  out->force = {-patch.creep.x, out->elastic_force[1] - patch.creep.y, -elastic - damper};
  // Lever of the vertical force: a; of the creep forces: (a, r); the flange acts at the axle.
  out->elastic_moment = {-p.half_base_m * elastic, 0, 0};
  out->moment = {r[1] * out->force[2] + r[2] * patch.creep.y, -r[2] * patch.creep.x,
                 r[1] * patch.creep.x - patch.creep.moment};
  const TGamma wear = CalcTGamma({.xi = patch.xi, .eta = patch.eta, .phi = patch.phi}, patch.creep);
  out->t_gamma = wear.slip;
  out->t_gamma_spin = wear.spin;
  out->creep_power = -reference * (patch.creep.x * patch.xi + patch.creep.y * patch.eta +
                                   patch.creep.moment * patch.phi);
  out->damping_power = damper * velocity[2];
  out->stored_energy = patch.stored_energy;
  if (damping == nullptr) return;
  // Secant of the saturated force: never more than the slope at the origin.
  const double left = Saturation(
      std::hypot(p.f11_N * patch.xi, p.f22_N * patch.eta + p.f23_Nm * patch.phi), p.limit_N);
  damping->count = 3;
  damping->damper[0] = {{1, 0, 0}, {0, r[2], -r[1]}, left * p.f11_N / reference};
  damping->damper[1] = {{0, 1, 0}, {-r[2], 0, r[0]}, left * p.f22_N / reference};
  damping->damper[2] = {{0, 0, 1}, {p.half_base_m, 0, 0}, p.damping_Ns_per_m};
}

}  // namespace phs::rail
