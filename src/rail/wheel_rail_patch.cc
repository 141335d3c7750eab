// Forces of one patch: Hertz under the elastic load, damping, creepages, creep force.
#include <algorithm>
#include <cmath>

#include "rail/wear.h"
#include "rail/wheel_rail_impl.h"

namespace phs::rail {

namespace {

Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// From 0 at -1 to 1 at +1 with level ends.
double SmoothStep(double x) {
  const double t = std::clamp(0.5 * (x + 1), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

constexpr double kFlangeBlend = 0.1;  ///< half width of the blend of friction [rad]

/// A: half the curvature of the wheel in the rolling direction, normal to the contact plane: its
/// parallel circle under the inclination of the normal (Meusnier). The rail is straight.
double CurvatureAlong(const Overlap& p) {
  return 0.5 / (p.radius * std::sqrt(1 + p.slope * p.slope));
}

/// The rolling speed; below twice the floor a parabola that ends level at the floor.
double ReferenceSpeed(double speed, double floor) {
  return speed >= 2 * floor ? speed : floor + speed * speed / (4 * floor);
}

/// Axes of a patch: forward along the rail, lateral outwards in the contact plane, normal into the
/// rail. The search takes the rail as parallel to x; its slopes (irregularity, twist of a cant
/// ramp) turn the axes, to first order, so that a wheel that follows its rail feels no closing
/// speed and the work of lifting it comes from the forward motion.
void SetAxes(double slope, const Vec3& slopes, PressedPatch* axes) {
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  axes->forward = {1, slopes[1], slopes[2]};
  axes->lateral = {0, cosine, slope * cosine};
  axes->normal = {0, -slope * cosine, cosine};
  for (Vec3* axis : {&axes->lateral, &axes->normal}) {
    (*axis)[0] = -((*axis)[1] * slopes[1] + (*axis)[2] * slopes[2]);
  }
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

/// Dampers that creep is at a small change of slip: the symmetric part of the slope of the force
/// against the slip speeds, K = sym -d(x, y)/d(xi, eta) / reference, as two dampers
///   kxx (f + r l)^2 + (kyy - r kxy) l^2,   r = kxy/kxx,   where it resists.
void AddCreepDampers(const CreepSlope& slope, double scale, const PressedPatch& axes,
                     const Vec3& point, WheelDamping* damping) {
  const double kxx = std::max(0.0, -slope.x_xi) * scale;
  double kyy = std::max(0.0, -slope.y_eta) * scale;
  const double ratio = kxx > 0 ? -0.5 * (slope.x_eta + slope.y_xi) * scale / kxx : 0;
  kyy = std::max(0.0, kyy - ratio * ratio * kxx);
  const auto add = [&](const Vec3& direction, double coefficient) {
    if (!(coefficient > 0)) return;
    damping->damper[static_cast<size_t>(damping->count++)] = {direction, Cross(point, direction),
                                                              coefficient};
  };
  Vec3 first = axes.forward;
  for (size_t i = 0; i < 3; ++i) first[i] += ratio * axes.lateral[i];
  add(first, kxx);
  add(axes.lateral, kyy);
}

}  // namespace

WheelRail::Impl::Wrench WheelRail::Impl::AddCreep(const WheelsetMotion& motion,
                                                  const PressedPatch& axes, ContactPatch* at,
                                                  WheelRailForces* out, WheelDamping* damping,
                                                  CreepMemo* memo) const noexcept {
  ContactPatch& patch = *at;
  const Vec3 turning = Cross(motion.rotation, patch.point);
  Vec3 velocity = motion.velocity;
  for (size_t i = 0; i < 3; ++i) velocity[i] += turning[i];
  // Rolling speed: mean of the speeds at which the contact moves over rail and wheel (Kalker).
  const double slip_forward = Dot(velocity, axes.forward);
  const double travel = std::copysign(motion.speed, motion.velocity[0]);
  const double reference =
      ReferenceSpeed(std::abs(travel - 0.5 * slip_forward), params.speed_floor);
  patch.xi = -slip_forward / reference;
  patch.eta = -Dot(velocity, axes.lateral) / reference;
  patch.phi = -Dot(motion.rotation, axes.normal) / reference;
  const double slip = reference * std::sqrt(patch.xi * patch.xi + patch.eta * patch.eta);
  const double flange = SmoothStep((std::abs(patch.angle) - params.flange_angle) / kFlangeBlend);
  patch.friction = (1 - flange) * params.tread.At(slip) + flange * params.flange.At(slip);
  // The law's axis 1 is the rolling direction: running backwards turns 1 and 2 about the normal.
  const double way = travel < 0 ? -1 : 1;
  const CreepInput input{patch.a,         patch.b,   patch.normal, way * patch.xi,
                         way * patch.eta, patch.phi, reference,    patch.friction};
  CreepSlope slope;
  const CreepForce whole = damping != nullptr ? creep->CalcWithSlope(input, &slope, memo)
                           : memo != nullptr  ? creep->CalcNear(input, *memo)
                                              : creep->Calc(input);
  if (damping != nullptr) {
    // Running backwards turns both axes of the law: its slopes stay.
    AddCreepDampers(slope, patch.weight / reference, axes, patch.point, damping);
  }
  patch.creep = {patch.weight * way * whole.x, patch.weight * way * whole.y,
                 patch.weight * whole.moment};
  // On the wheel: the opposite of what acts on the rail.
  Vec3 force{};
  for (size_t i = 0; i < 3; ++i) {
    force[i] = -patch.creep.y * axes.lateral[i] - patch.creep.x * axes.forward[i];
  }
  Vec3 moment = Cross(patch.point, force);
  for (size_t i = 0; i < 3; ++i) moment[i] -= patch.creep.moment * axes.normal[i];
  const TGamma wear = CalcTGamma(input, patch.creep);
  out->t_gamma += wear.slip;
  out->t_gamma_spin += wear.spin;
  out->creep_power -= reference * (patch.creep.x * patch.xi + patch.creep.y * patch.eta +
                                   patch.creep.moment * patch.phi);
  return {force, moment};
}

void WheelRail::Impl::Press(const Overlap& overlap, double approach, const Vec3& slopes,
                            double forward_push, const RailSupport& support, PressedWheel* wheel,
                            WheelRailForces* out) const noexcept {
  PressedPatch& pressed = wheel->patch[static_cast<size_t>(out->count)];
  SetAxes(overlap.slope, slopes, &pressed);
  ContactPatch& patch = out->patch[static_cast<size_t>(out->count++)];
  patch.rail_y = overlap.y;
  patch.rail_z = search->rail().At(overlap.y).z;
  patch.wheel_y = overlap.wheel_y;
  patch.wheel_z = overlap.radius - params.wheel_radius;
  patch.angle = -std::atan(overlap.slope);
  patch.rolling_radius = overlap.radius;
  patch.weight = overlap.weight;
  patch.climbs = overlap.at_end || overlap.wheel_y < climb_y;
  // Forces act half-way into the overlap.
  patch.point = overlap.arm;
  for (size_t i = 0; i < 3; ++i) patch.point[i] -= 0.5 * approach * pressed.normal[i];

  // On a sloping rail the wheel touches ahead of or behind its lowest point: where its own normal
  // is the rail's. (The search leaves this out; the change of height there is of second order.)
  Vec3 push = overlap.push;
  Vec3 turn = overlap.turn;
  push[0] = forward_push;
  const double size = std::sqrt(Dot(push, push));
  const double ahead =
      overlap.radius * std::sqrt(1 + overlap.slope * overlap.slope) * push[0] / size;
  patch.point[0] += ahead;
  turn[1] += overlap.arm[2] * push[0] - ahead * push[2];
  turn[2] += ahead * push[1] - overlap.arm[1] * push[0];

  // Held shapes: the force follows the approach as Hertz's does.
  const double ratio = approach / overlap.depth;
  const double held = ratio * std::sqrt(ratio);
  const double elastic = held * size;
  const HertzContact ellipse = hertz.UnderLoad(elastic, CurvatureAlong(overlap), overlap.across);
  patch.a = ellipse.a;
  patch.b = ellipse.b;
  patch.peak_pressure = ellipse.peak_pressure;
  patch.approach = ellipse.approach;
  const double stiffness = 1.5 * elastic / approach;
  pressed.elastic = elastic;
  pressed.damper = 2 * params.damping_ratio * std::sqrt(stiffness * params.wheel_mass) +
                   SupportDamping(pressed.normal, stiffness, support);
  patch.stored_energy = overlap.weight * held * ratio * overlap.energy;
  out->stored_energy += patch.stored_energy;
  for (size_t i = 0; i < 3; ++i) {
    pressed.push[i] = push[i] / size;
    pressed.turn[i] = turn[i] / size;
    out->elastic_force[i] -= overlap.weight * elastic * pressed.push[i];
    out->elastic_moment[i] -= overlap.weight * elastic * pressed.turn[i];
  }
}

void WheelRail::Impl::AddForces(const WheelsetMotion& motion, const PressedPatch& pressed,
                                ContactPatch* at, WheelRailForces* out, WheelDamping* damping,
                                CreepMemo* memo) const noexcept {
  ContactPatch& patch = *at;
  const double weight = patch.weight;
  const double closing = Dot(motion.velocity, pressed.push) + Dot(motion.rotation, pressed.turn);
  const double normal = std::max(0.0, pressed.elastic + pressed.damper * closing);
  if (damping != nullptr && normal > 0) {
    damping->damper[static_cast<size_t>(damping->count++)] = {pressed.push, pressed.turn,
                                                              weight * pressed.damper};
  }
  patch.normal = normal;
  const Wrench creep = AddCreep(motion, pressed, at, out, damping, memo);
  patch.normal = weight * normal;
  for (size_t i = 0; i < 3; ++i) {
    out->force[i] += creep.force[i] - patch.normal * pressed.push[i];
    out->moment[i] += creep.moment[i] - patch.normal * pressed.turn[i];
  }
  out->damping_power += weight * (normal - pressed.elastic) * closing;
  out->beyond_profile = out->beyond_profile || (patch.climbs && patch.normal > 0);
}

}  // namespace phs::rail
