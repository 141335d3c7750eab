#include "rail/wheel_rail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rail/contact_search.h"
#include "rail/elastic_rail.h"
#include "rail/hertz.h"
#include "rail/linear_contact.h"

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

/// A: half the curvature of the wheel in the rolling direction, normal to the contact plane: its
/// parallel circle under the inclination of the normal (Meusnier). The rail is straight.
double CurvatureAlong(const Overlap& p) {
  return 0.5 / (p.radius * std::sqrt(1 + p.slope * p.slope));
}

/// The rolling speed; below twice the floor a parabola that ends level at the floor.
double ReferenceSpeed(double speed, double floor) {
  return speed >= 2 * floor ? speed : floor + speed * speed / (4 * floor);
}

/// Axes of one patch: forward along the rail, lateral outwards in the contact plane, normal into
/// the rail. The search takes the rail as parallel to x; its slopes (irregularity, twist of a cant
/// ramp) turn the axes, to first order, so that a wheel that follows its rail feels no closing
/// speed and the work of lifting it comes from the forward motion.
struct PatchAxes {
  Vec3 forward;
  Vec3 lateral;
  Vec3 normal;
};
PatchAxes AxesOf(double slope, const Vec3& slopes) {
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  PatchAxes axes{
      {1, slopes[1], slopes[2]}, {0, cosine, slope * cosine}, {0, -slope * cosine, cosine}};
  for (Vec3* axis : {&axes.lateral, &axes.normal}) {
    (*axis)[0] = -((*axis)[1] * slopes[1] + (*axis)[2] * slopes[2]);
  }
  return axes;
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

/// Slopes of the rail against x at one patch, C axes. The rail's own slopes hold on its axis; on a
/// cant ramp they change across the head (the section turns about the track's axis), and in a curve
/// the rail turns along the small distance by which a yawed wheel touches ahead of its axle.
Vec3 SlopesAt(const Overlap& p, const WheelsetMotion& motion, Side side, const RailOffset& rail) {
  Vec3 slopes = MirrorPolar({0, rail.lateral_slope, rail.vertical_slope}, side);
  const double hand = side == Side::kLeft ? 1 : -1;
  slopes[1] += hand * (rail.curvature * p.arm[0] - rail.twist * (motion.vertical + p.arm[2]));
  slopes[2] += hand * rail.twist * (motion.lateral + p.arm[1] - rail.half_base);
  return slopes;
}

/// All but the patches, which are filled one by one.
void ClearSums(WheelRailForces* out) {
  out->count = 0;
  for (Vec3* sum : {&out->force, &out->moment, &out->elastic_force, &out->elastic_moment}) {
    *sum = {};
  }
  out->t_gamma = out->t_gamma_spin = 0;
  out->creep_power = out->damping_power = out->stored_energy = 0;
  out->rail_lateral = out->rail_vertical = 0;
  out->beyond_profile = false;
}

/// Longitudinal part of a patch's force into the rail: each strip is square to the rail as it lies
/// there, f_x = -(f_y dy/dx + f_z dz/dx). Summed with the slopes of SlopesAt at every strip's own
/// arm, so that a frame that turns along the track (curve, cant ramp) does no work on its own.
double ForwardPush(const Overlap& p, const WheelsetMotion& motion, Side side,
                   const RailOffset& rail) {
  const Vec3 own = MirrorPolar({0, rail.lateral_slope, rail.vertical_slope}, side);
  const double hand = side == Side::kLeft ? 1 : -1;
  const double turned =
      p.turn[0] - motion.vertical * p.push[1] + (motion.lateral - rail.half_base) * p.push[2];
  return -(p.push[1] * own[1] + p.push[2] * own[2] +
           hand * (rail.curvature * p.turn[2] + rail.twist * turned));
}

Status Validate(const WheelRailParams& p) {
  const auto in = [](double x, double low, double high) { return x >= low && x <= high; };
  if (!in(p.gauge, 0.3, 2.0)) return Error{"gauge", "is out of range", "0.3 … 2 m", ""};
  if (!in(p.wheel_radius, 0.1, 1.5))
    return Error{"wheel_radius", "is out of range", "0.1 … 1.5 m", ""};
  if (!in(p.flange_back_distance, 0.2, p.gauge)) {
    return Error{"flange_back_distance", "is out of range", "0.2 m … gauge", ""};
  }
  if (!in(p.tread.coefficient, 0, 2) || !in(p.flange.coefficient, 0, 2)) {
    return Error{"friction", "is out of range", "0 … 2", ""};
  }
  if (!in(p.damping_ratio, 0, 2) || !(p.wheel_mass > 0) || !(p.speed_floor > 0)) {
    return Error{"contact damping", "is out of range",
                 "damping_ratio 0 … 2, wheel_mass > 0, speed_floor > 0", ""};
  }
  return {};
}

}  // namespace

struct WheelRail::Impl {
  WheelRailParams params;
  std::unique_ptr<CreepLaw> creep;
  std::unique_ptr<ContactSearch> search;
  Hertz hertz{82e9, 0.28};
  double rail_y = 0;    ///< origin of the rail profile from the track centre [m]
  double touching = 0;  ///< z_C of the wheelset centre at mere touch
  double flange = 0;    ///< largest flange angle [rad]
  double climb_y = 0;   ///< contacts at smaller y of the wheel profile climb [m]

  void Press(const WheelsetMotion& motion, const Overlap& overlap, double approach,
             const Vec3& slopes, double forward_push, const RailSupport& support,
             WheelRailForces* out) const noexcept;
  void AddCreep(const WheelsetMotion& motion, const PatchAxes& axes, ContactPatch* patch,
                WheelRailForces* out) const noexcept;
};

int WheelRailForces::contacts() const {
  double places = 0;
  for (int k = 0; k < count; ++k) places += patch[static_cast<size_t>(k)].weight;
  return static_cast<int>(std::lround(places));
}

WheelRail::WheelRail(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WheelRail::WheelRail(WheelRail&&) noexcept = default;
WheelRail& WheelRail::operator=(WheelRail&&) noexcept = default;
WheelRail::~WheelRail() = default;
const WheelRailParams& WheelRail::params() const { return impl_->params; }
const CreepLaw& WheelRail::creep_law() const { return *impl_->creep; }
double WheelRail::touching_height() const { return impl_->touching; }
double WheelRail::flange_angle() const { return impl_->flange; }

double WheelRail::LongitudinalCoefficient(const ContactPatch& patch, double speed) const noexcept {
  if (impl_->params.linear) return impl_->params.linear->f11_N;
  constexpr double kSmallCreep = 1e-7;
  const CreepForce force = impl_->creep->Calc(
      {patch.a, patch.b, patch.normal, kSmallCreep, 0, 0, speed, patch.friction});
  return std::abs(force.x) / kSmallCreep;
}

Result<WheelRail> WheelRail::Create(const WheelRailParams& params) {
  if (Status s = Validate(params); !s.ok()) return s.error();
  auto impl = std::make_unique<Impl>();
  impl->params = params;
  if (params.linear) {
    if (Status s = phs::rail::Validate(*params.linear); !s.ok()) return s.error();
    CreepLawParams linear = params.creep;
    linear.method = "linear";
    auto creep = CreateCreepLaw(linear);
    if (!creep.ok()) return creep.error();
    impl->creep = std::move(creep).value();
    impl->touching = -params.wheel_radius;
    return WheelRail(std::move(impl));
  }
  auto wheel = LoadProfile(params.wheel_profile, ProfileKind::kWheel);
  if (!wheel.ok()) return wheel.error();
  if (Status s = phs::rail::Validate(params.wear); !s.ok()) return s.error();
  WearTread(params.wear, &wheel.value());
  auto rail = LoadProfile(params.rail_profile, ProfileKind::kRail);
  if (!rail.ok()) return rail.error();
  rail.value().Incline(params.rail_cant);
  rail.value().PutTopAtZero();
  auto creep = CreateCreepLaw(params.creep);
  if (!creep.ok()) return creep.error();
  impl->creep = std::move(creep).value();
  impl->hertz = Hertz(params.creep.material.shear_modulus_Pa, params.creep.material.poisson_ratio);
  double gauge_point = rail.value().InnerSideAtDepth(params.gauge_height);
  // A rail head of one arc need not reach down to the gauge point: its end stands for it.
  if (!std::isfinite(gauge_point)) gauge_point = rail.value().min_y();
  impl->rail_y = params.gauge / 2 - gauge_point;
  double flange_y = wheel.value().max_y();
  for (double y = wheel.value().max_y(); y > wheel.value().min_y(); y -= 1e-4) {
    const double angle = std::atan(-wheel.value().At(y).slope);
    if (angle > impl->flange) {
      impl->flange = angle;
      flange_y = y;
    }
  }
  // Inside of the steep flank the flange's tip rolls on the rail: it climbs.
  impl->climb_y = flange_y;
  while (impl->climb_y > wheel.value().min_y() &&
         -wheel.value().At(impl->climb_y).slope > 0.5 * std::tan(impl->flange)) {
    impl->climb_y -= 1e-4;
  }
  const double half_tape = params.flange_back_distance / 2 - params.flange_back_position;
  impl->search = std::make_unique<ContactSearch>(std::move(wheel).value(), std::move(rail).value(),
                                                 half_tape, params.wheel_radius, impl->hertz);
  // Mere touch: lower a centred wheel from above until it overlaps.
  Overlaps found;
  double above = -params.wheel_radius - 0.05;
  double below = -params.wheel_radius + 0.05;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (above + below);
    impl->search->Find({0, z, 0, 0}, impl->rail_y, 0, &found);
    (found.count == 0 ? above : below) = z;
  }
  impl->touching = 0.5 * (above + below);
  if (impl->touching > -params.wheel_radius + 0.049) {
    return Error{params.wheel_profile + " on " + params.rail_profile, "never touch",
                 "profiles that meet at this gauge and flange-back distance", ""};
  }
  return WheelRail(std::move(impl));
}

TouchPoint WheelRail::Touch(double lateral, double roll, double yaw) const noexcept {
  // The gap's shape does not depend on the height: lowered until they overlap, the bodies touch
  // where the vertical overlap is greatest.
  constexpr double kStep = 5e-3;
  constexpr double kLowest = 60e-3;
  TouchPoint touch;
  Overlaps found;
  for (double sunk = kStep; found.count == 0 && sunk < kLowest; sunk += kStep) {
    const double height = impl_->touching + sunk;
    impl_->search->FindPoints({lateral, height, roll, yaw}, impl_->rail_y, 0, &found);
    double most = 0;
    for (int i = 0; i < found.count; ++i) {
      const Overlap& p = found.patch[static_cast<size_t>(i)];
      const double vertical = p.depth * std::sqrt(1 + p.slope * p.slope);
      if (vertical <= most) continue;
      most = vertical;
      touch = {true, height - vertical, p.y, p.wheel_y, -std::atan(p.slope), p.radius};
    }
  }
  return touch;
}

/// Creepages and creep force of a patch whose normal force is known, added to the sums.
void WheelRail::Impl::AddCreep(const WheelsetMotion& motion, const PatchAxes& axes,
                               ContactPatch* at, WheelRailForces* out) const noexcept {
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
  const CreepForce whole = creep->Calc({patch.a, patch.b, patch.normal, way * patch.xi,
                                        way * patch.eta, patch.phi, reference, patch.friction});
  patch.creep = {patch.weight * way * whole.x, patch.weight * way * whole.y,
                 patch.weight * whole.moment};
  // On the wheel: the opposite of what acts on the rail.
  Vec3 force{};
  for (size_t i = 0; i < 3; ++i) {
    force[i] = -patch.creep.y * axes.lateral[i] - patch.creep.x * axes.forward[i];
  }
  const Vec3 moment = Cross(patch.point, force);
  for (size_t i = 0; i < 3; ++i) {
    out->force[i] += force[i];
    out->moment[i] += moment[i] - patch.creep.moment * axes.normal[i];
  }
  out->t_gamma += std::abs(patch.creep.x * patch.xi) + std::abs(patch.creep.y * patch.eta);
  out->t_gamma_spin += std::abs(patch.creep.moment * patch.phi);
  out->creep_power -= reference * (patch.creep.x * patch.xi + patch.creep.y * patch.eta +
                                   patch.creep.moment * patch.phi);
}

/// Normal and creep force of one patch, added to the sums.
void WheelRail::Impl::Press(const WheelsetMotion& motion, const Overlap& overlap, double approach,
                            const Vec3& slopes, double forward_push, const RailSupport& support,
                            WheelRailForces* out) const noexcept {
  const PatchAxes axes = AxesOf(overlap.slope, slopes);
  ContactPatch& patch = out->patch[static_cast<size_t>(out->count++)];
  patch.rail_y = overlap.y;
  patch.rail_z = search->rail().At(overlap.y).z;
  patch.wheel_y = overlap.wheel_y;
  patch.wheel_z = overlap.radius - params.wheel_radius;
  patch.angle = -std::atan(overlap.slope);
  patch.rolling_radius = overlap.radius;
  patch.weight = overlap.weight;
  // Forces act half-way into the overlap.
  patch.point = overlap.arm;
  for (size_t i = 0; i < 3; ++i) patch.point[i] -= 0.5 * approach * axes.normal[i];

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
  const double closing = (Dot(motion.velocity, push) + Dot(motion.rotation, turn)) / size;
  const double stiffness = 1.5 * elastic / approach;
  const double damper = 2 * params.damping_ratio * std::sqrt(stiffness * params.wheel_mass) +
                        SupportDamping(axes.normal, stiffness, support);
  const double normal = std::max(0.0, elastic + damper * closing);
  patch.normal = normal;
  AddCreep(motion, axes, &patch, out);

  const double weight = overlap.weight;
  patch.normal = weight * normal;
  patch.stored_energy = weight * held * ratio * overlap.energy;
  const double pressed = weight * normal / size;
  for (size_t i = 0; i < 3; ++i) {
    out->force[i] -= pressed * push[i];
    out->moment[i] -= pressed * turn[i];
    out->elastic_force[i] -= weight * held * push[i];
    out->elastic_moment[i] -= weight * held * turn[i];
  }
  out->damping_power += weight * (normal - elastic) * closing;
  out->stored_energy += patch.stored_energy;
  const bool beyond = overlap.at_end || overlap.wheel_y < climb_y;
  out->beyond_profile = out->beyond_profile || (beyond && patch.normal > 0);
}

void WheelRail::Calc(const WheelsetMotion& motion, Side side, const RailOffset& rail,
                     const RailSupport& support, WheelRailForces* out) const noexcept {
  if (const auto& linear = impl_->params.linear) {
    CalcLinearContact(*linear, impl_->params.wheel_radius, impl_->params.speed_floor, motion, out);
    return;
  }
  const Vec3 shift = MirrorPolar({0, rail.lateral, rail.vertical}, side);
  Vec3 bend{};
  Overlaps found;
  const Vec3 rest =
      FindOnSupport(*impl_->search, {motion.lateral, motion.vertical, motion.roll, motion.yaw},
                    impl_->rail_y + shift[1], shift[2], support, &bend, &found);
  ClearSums(out);
  if (found.count == 0) return;
  out->rail_lateral = bend[1];
  out->rail_vertical = bend[2];
  out->stored_energy = 0.5 * (support.lateral_stiffness_N_per_m * bend[1] * bend[1] +
                              support.vertical_stiffness_N_per_m * bend[2] * bend[2]);
  for (int i = 0; i < found.count; ++i) {
    const Overlap& p = found.patch[static_cast<size_t>(i)];
    const double approach = p.depth - Dot(NormalOf(p), rest);
    if (!(approach > 0)) continue;
    impl_->Press(motion, p, approach, SlopesAt(p, motion, side, rail),
                 ForwardPush(p, motion, side, rail), support, out);
  }
}

}  // namespace phs::rail
