#include "rail/contact_force.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {
namespace {

double Dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// From 0 at -1 to 1 at +1 with level ends.
double SmoothStep(double x) {
  const double t = std::clamp(0.5 * (x + 1), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

constexpr double kFlangeBlend = 0.1;  ///< half width of the blend of friction [rad]
constexpr int kSupportIterations = 40;

/// The rolling speed; below twice the floor a parabola that ends level at the floor.
double ReferenceSpeed(double speed, double floor) {
  return speed >= 2 * floor ? speed : floor + speed * speed / (4 * floor);
}

/// Damper of the support as felt by the wheel along `normal`: the massless rail on its spring k
/// moves by the share k_H/(k + k_H) of the wheel's motion, so its damper c acts with that share
/// squared.
double SupportDamping(const Vec3& normal, double contact_stiffness, const RailSupport& s) {
  const auto part = [&](double direction, double k, double c) {
    if (!(k > 0) || !(c > 0)) return 0.0;
    const double seen = contact_stiffness * direction * direction;
    const double share = seen / (k + seen);
    return c * share * share * direction * direction;
  };
  return part(normal[1], s.lateral_stiffness_N_per_m, s.lateral_damping_Ns_per_m) +
         part(normal[2], s.vertical_stiffness_N_per_m, s.vertical_damping_Ns_per_m);
}

/// Where along x a force along `n` passes through the axle, as normals of a surface of revolution
/// do: n.(e x r) = 0. Ahead of or behind the axle for a yawed flange and on a sloping rail. So
/// normal forces do no work on the spin.
double ArmAhead(const Vec3& e, const Vec3& r, const Vec3& n) {
  return (n[0] * (e[1] * r[2] - e[2] * r[1]) + e[0] * (n[2] * r[1] - n[1] * r[2])) /
         (n[2] * e[1] - n[1] * e[2]);
}

}  // namespace

PatchAxes AxesOf(double slope, const Vec3& slopes) noexcept {
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  PatchAxes axes{
      {1, slopes[1], slopes[2]}, {0, cosine, slope * cosine}, {0, -slope * cosine, cosine}};
  for (Vec3* axis : {&axes.lateral, &axes.normal}) {
    (*axis)[0] = -((*axis)[1] * slopes[1] + (*axis)[2] * slopes[2]);
  }
  return axes;
}

double CurvatureAlong(const Overlap& overlap) noexcept {
  // Parallel circle of radius R under the inclination of the normal (Meusnier): cos(angle)/R.
  return 0.5 / (overlap.radius * std::sqrt(1 + overlap.slope * overlap.slope));
}

void ContactForceLaw::FindOnSupport(const ContactSearch& search, const WheelPlacement& wheel,
                                    double rail_y, double rail_z, const RailSupport& s, Vec3* bend,
                                    Overlaps* overlaps) const noexcept {
  *bend = {};
  const double k[2] = {s.lateral_stiffness_N_per_m, s.vertical_stiffness_N_per_m};
  Overlaps& found = *overlaps;
  search.Find(wheel, rail_y, rail_z, &found);
  if (!(k[0] > 0) && !(k[1] > 0)) return;
  const double give[2] = {k[0] > 0 ? 1 / k[0] : 0, k[1] > 0 ? 1 / k[1] : 0};
  Vec3& w = *bend;
  for (int iteration = 0; iteration < kSupportIterations && found.count > 0; ++iteration) {
    // Residual in displacements, r = w - F(w)/k; jacobian = 1 + sum N' n n / k.
    double r[2] = {w[1], w[2]};
    double j[2][2] = {{1, 0}, {0, 1}};
    for (int i = 0; i < found.count; ++i) {
      const Overlap& p = found.patch[static_cast<size_t>(i)];
      const Vec3 normal = AxesOf(p.slope, {}).normal;
      const double n = p.weight * hertz.AtApproach(p.depth, CurvatureAlong(p), p.across).normal;
      for (size_t a = 0; a < 2; ++a) {
        r[a] -= give[a] * n * normal[a + 1];
        for (size_t b = 0; b < 2; ++b) {
          j[a][b] += give[a] * 1.5 * n / p.depth * normal[a + 1] * normal[b + 1];
        }
      }
    }
    const double determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    const double step_y = (r[0] * j[1][1] - r[1] * j[0][1]) / determinant;
    const double step_z = (r[1] * j[0][0] - r[0] * j[1][0]) / determinant;
    w[1] -= step_y;
    w[2] -= step_z;
    search.Find(wheel, rail_y + w[1], rail_z + w[2], &found);
    if (std::abs(step_y) + std::abs(step_z) < 1e-13) break;
  }
}

void ContactForceLaw::AddPatch(const WheelsetMotion& motion, const Vec3& axle,
                               const Overlap& overlap, const PatchAxes& axes,
                               const RailSupport& support, WheelRailForces* out) const noexcept {
  const HertzContact h = hertz.AtApproach(overlap.depth, CurvatureAlong(overlap), overlap.across);
  ContactPatch& patch = out->patch[static_cast<size_t>(out->count++)];
  patch.rail_y = overlap.y;
  patch.rail_z = overlap.z;
  patch.wheel_y = overlap.wheel_y;
  patch.wheel_z = overlap.radius - params->wheel_radius;
  // Forces act half-way into the overlap.
  patch.point = overlap.arm;
  for (size_t i = 0; i < 3; ++i) patch.point[i] -= 0.5 * overlap.depth * axes.normal[i];
  patch.point[0] = ArmAhead(axle, patch.point, axes.normal);
  patch.angle = -std::atan(overlap.slope);
  patch.approach = overlap.depth;
  patch.a = h.a;
  patch.b = h.b;
  patch.peak_pressure = h.peak_pressure;
  patch.rolling_radius = overlap.radius;
  patch.weight = overlap.weight;

  const Vec3 turning = Cross(motion.rotation, patch.point);
  Vec3 velocity = motion.velocity;
  for (size_t i = 0; i < 3; ++i) velocity[i] += turning[i];
  const double closing = Dot(velocity, axes.normal);
  const double stiffness = 1.5 * h.normal / overlap.depth;
  const double damper = 2 * params->damping_ratio * std::sqrt(stiffness * params->wheel_mass) +
                        SupportDamping(axes.normal, stiffness, support);
  const double normal = std::max(0.0, h.normal + damper * closing);

  // Rolling speed: mean of the speeds at which the contact moves over rail and wheel (Kalker).
  const double slip_forward = Dot(velocity, axes.forward);
  const double travel = std::copysign(motion.speed, motion.velocity[0]);
  const double rolling = std::abs(travel - 0.5 * slip_forward);
  const double reference = ReferenceSpeed(rolling, params->speed_floor);
  patch.xi = -slip_forward / reference;
  patch.eta = -Dot(velocity, axes.lateral) / reference;
  patch.phi = -Dot(motion.rotation, axes.normal) / reference;
  const double slip = reference * std::sqrt(patch.xi * patch.xi + patch.eta * patch.eta);
  const double flange = SmoothStep((std::abs(patch.angle) - params->flange_angle) / kFlangeBlend);
  patch.friction = (1 - flange) * params->tread.At(slip) + flange * params->flange.At(slip);
  // The law's axis 1 is the rolling direction: running backwards turns 1 and 2 about the normal.
  const double way = travel < 0 ? -1 : 1;
  CreepForce creep_force = creep->Calc(
      {h.a, h.b, normal, way * patch.xi, way * patch.eta, patch.phi, reference, patch.friction});
  creep_force.x *= way;
  creep_force.y *= way;

  const double w = overlap.weight;
  patch.normal = w * normal;
  patch.creep = {w * creep_force.x, w * creep_force.y, w * creep_force.moment};
  patch.stored_energy = w * 0.4 * h.normal * overlap.depth;

  // On the wheel: the opposite of what acts on the rail.
  Vec3 force{};
  for (size_t i = 0; i < 3; ++i) {
    force[i] = -patch.normal * axes.normal[i] - patch.creep.y * axes.lateral[i] -
               patch.creep.x * axes.forward[i];
  }
  const Vec3 moment = Cross(patch.point, force);
  const double elastic = w * h.normal;
  const Vec3 elastic_moment = Cross(patch.point, axes.normal);
  for (size_t i = 0; i < 3; ++i) {
    out->force[i] += force[i];
    out->elastic_force[i] -= elastic * axes.normal[i];
    out->elastic_moment[i] -= elastic * elastic_moment[i];
    out->moment[i] += moment[i] - patch.creep.moment * axes.normal[i];
  }
  out->t_gamma += std::abs(patch.creep.x * patch.xi) + std::abs(patch.creep.y * patch.eta);
  out->t_gamma_spin += std::abs(patch.creep.moment * patch.phi);
  out->creep_power -= reference * (patch.creep.x * patch.xi + patch.creep.y * patch.eta +
                                   patch.creep.moment * patch.phi);
  out->damping_power += w * (normal - h.normal) * closing;
  out->stored_energy += patch.stored_energy;
  out->beyond_profile = out->beyond_profile || (overlap.at_end && patch.normal > 0);
}

}  // namespace phs::rail
