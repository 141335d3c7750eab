#include "rail/wheel_rail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rail/contact_search.h"
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
constexpr int kSupportIterations = 12;

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
PatchAxes AxesOf(const TouchingPoint& p, const Vec3& slopes) {
  const double cosine = 1 / std::sqrt(1 + p.slope * p.slope);
  PatchAxes axes{
      {1, slopes[1], slopes[2]}, {0, cosine, p.slope * cosine}, {0, -p.slope * cosine, cosine}};
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
Vec3 SlopesAt(const TouchingPoint& p, const WheelsetMotion& motion, Side side,
              const RailOffset& rail) {
  Vec3 slopes = MirrorPolar({0, rail.lateral_slope, rail.vertical_slope}, side);
  const double hand = side == Side::kLeft ? 1 : -1;
  slopes[1] += hand * (rail.curvature * p.arm[0] - rail.twist * (motion.vertical + p.arm[2]));
  slopes[2] += hand * rail.twist * (motion.lateral + p.arm[1] - rail.half_base);
  return slopes;
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
  double flange = 0;

  double Along(const TouchingPoint& p) const {
    // Curvature of the wheel in the rolling direction, normal to the contact plane; the rail is
    // straight.
    return 0.5 / (p.radius * std::sqrt(1 + p.slope * p.slope));
  }
  Vec3 Deflect(const TouchingPoints& points, const RailSupport& support) const noexcept;
  void Press(const WheelsetMotion& motion, const TouchingPoint& point, const PatchAxes& axes,
             double approach, const RailSupport& support, WheelRailForces* out) const noexcept;
};

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
  for (double y = wheel.value().min_y(); y < wheel.value().max_y(); y += 1e-4) {
    impl->flange = std::max(impl->flange, std::atan(-wheel.value().At(y).slope));
  }
  const double half_tape = params.flange_back_distance / 2 - params.flange_back_position;
  impl->search = std::make_unique<ContactSearch>(std::move(wheel).value(), std::move(rail).value(),
                                                 half_tape, params.wheel_radius);
  // Mere touch: lower a centred wheel from above until a minimum penetrates.
  double above = -params.wheel_radius - 0.05;
  double below = -params.wheel_radius + 0.05;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (above + below);
    (impl->search->Find({0, z, 0, 0}, impl->rail_y, 0).count == 0 ? above : below) = z;
  }
  impl->touching = 0.5 * (above + below);
  if (impl->touching > -params.wheel_radius + 0.049) {
    return Error{params.wheel_profile + " on " + params.rail_profile, "never touch",
                 "profiles that meet at this gauge and flange-back distance", ""};
  }
  return WheelRail(std::move(impl));
}

/// Displacement of an elastic, massless rail under the Hertz forces: k w = sum N n (2 x 2 Newton).
Vec3 WheelRail::Impl::Deflect(const TouchingPoints& points, const RailSupport& s) const noexcept {
  Vec3 w{};
  const double k[3] = {0, s.lateral_stiffness_N_per_m, s.vertical_stiffness_N_per_m};
  if (!(k[1] > 0) && !(k[2] > 0)) return w;
  const double inverse[3] = {0, k[1] > 0 ? 1 / k[1] : 0, k[2] > 0 ? 1 / k[2] : 0};
  for (int iteration = 0; iteration < kSupportIterations; ++iteration) {
    // Residual in displacements, r = w - F(w)/k; jacobian = 1 + sum N' n n / k.
    double r[2] = {w[1], w[2]};
    double j[2][2] = {{1, 0}, {0, 1}};
    for (int i = 0; i < points.count; ++i) {
      const TouchingPoint& p = points.point[static_cast<size_t>(i)];
      const PatchAxes axes = AxesOf(p, {});
      const double approach = p.depth - Dot(axes.normal, w);
      const double n = p.weight * hertz.AtApproach(approach, Along(p), p.across).normal;
      const double stiffness = approach > 0 ? 1.5 * n / approach : 0;
      for (int a = 0; a < 2; ++a) {
        r[a] -= inverse[a + 1] * n * axes.normal[static_cast<size_t>(a) + 1];
        for (int b = 0; b < 2; ++b) {
          j[a][b] += inverse[a + 1] * stiffness * axes.normal[static_cast<size_t>(a) + 1] *
                     axes.normal[static_cast<size_t>(b) + 1];
        }
      }
    }
    const double determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    const double step_y = (r[0] * j[1][1] - r[1] * j[0][1]) / determinant;
    const double step_z = (r[1] * j[0][0] - r[0] * j[1][0]) / determinant;
    w[1] -= step_y;
    w[2] -= step_z;
    if (std::abs(step_y) + std::abs(step_z) < 1e-14) break;
  }
  return w;
}

/// Normal and creep force of one patch, added to the sums.
void WheelRail::Impl::Press(const WheelsetMotion& motion, const TouchingPoint& point,
                            const PatchAxes& axes, double approach, const RailSupport& support,
                            WheelRailForces* out) const noexcept {
  const double along = Along(point);
  const HertzContact hertzian = hertz.AtApproach(approach, along, point.across);
  ContactPatch& patch = out->patch[static_cast<size_t>(out->count)];
  patch = {};
  patch.rail_y = point.y;
  patch.rail_z = point.z - point.depth * std::sqrt(1 + point.slope * point.slope);
  patch.wheel_y = point.wheel_y;
  patch.wheel_z = search->wheel().At(point.wheel_y).z;
  // Forces act half-way into the overlap.
  patch.point = point.arm;
  for (size_t i = 0; i < 3; ++i) patch.point[i] -= 0.5 * point.depth * axes.normal[i];
  // On a sloping rail the wheel touches ahead of or behind its lowest point: where its own normal
  // is the rail's. (The search leaves this out; the change of height there is of second order.)
  patch.point[0] += point.radius * std::sqrt(1 + point.slope * point.slope) * axes.normal[0];
  patch.angle = -std::atan(point.slope);
  patch.approach = approach;
  // A patch that merges with its neighbour keeps its pressure and loses area with its load.
  const double scale = std::sqrt(point.weight);
  patch.a = scale * hertzian.a;
  patch.b = scale * hertzian.b;
  patch.peak_pressure = hertzian.peak_pressure;
  patch.rolling_radius = point.radius;

  const Vec3 spin = Cross(motion.rotation, patch.point);
  Vec3 velocity = motion.velocity;
  for (size_t i = 0; i < 3; ++i) velocity[i] += spin[i];
  const double elastic = point.weight * hertzian.normal;
  const double closing = Dot(velocity, axes.normal);
  const double stiffness = approach > 0 ? 1.5 * elastic / approach : 0;
  const double damper = 2 * params.damping_ratio * std::sqrt(stiffness * params.wheel_mass);
  const double dashpot = damper + SupportDamping(axes.normal, stiffness, support);
  patch.normal = std::max(0.0, elastic + dashpot * closing);
  patch.stored_energy = 0.4 * elastic * approach;

  const double reference = ReferenceSpeed(motion.speed, params.speed_floor);
  patch.xi = -Dot(velocity, axes.forward) / reference;
  patch.eta = -Dot(velocity, axes.lateral) / reference;
  patch.phi = -Dot(motion.rotation, axes.normal) / reference;
  const double slip = reference * std::sqrt(patch.xi * patch.xi + patch.eta * patch.eta);
  const double flange = SmoothStep((std::abs(patch.angle) - params.flange_angle) / kFlangeBlend);
  patch.friction = (1 - flange) * params.tread.At(slip) + flange * params.flange.At(slip);
  patch.creep = creep->Calc(
      {patch.a, patch.b, patch.normal, patch.xi, patch.eta, patch.phi, reference, patch.friction});

  // On the wheel: the opposite of what acts on the rail.
  Vec3 force{};
  for (size_t i = 0; i < 3; ++i) {
    force[i] = -patch.normal * axes.normal[i] - patch.creep.y * axes.lateral[i] -
               patch.creep.x * axes.forward[i];
  }
  const Vec3 moment = Cross(patch.point, force);
  const Vec3 elastic_moment = Cross(patch.point, axes.normal);
  for (size_t i = 0; i < 3; ++i) {
    out->elastic_force[i] -= elastic * axes.normal[i];
    out->elastic_moment[i] -= elastic * elastic_moment[i];
    out->force[i] += force[i];
    out->moment[i] += moment[i] - patch.creep.moment * axes.normal[i];
  }
  out->t_gamma += std::abs(patch.creep.x * patch.xi) + std::abs(patch.creep.y * patch.eta);
  out->t_gamma_spin += std::abs(patch.creep.moment * patch.phi);
  out->creep_power -= reference * (patch.creep.x * patch.xi + patch.creep.y * patch.eta +
                                   patch.creep.moment * patch.phi);
  out->damping_power += (patch.normal - elastic) * closing;
  out->stored_energy += patch.stored_energy;
  out->beyond_profile = out->beyond_profile || (point.at_end && patch.normal > 0);
  ++out->count;
}

void WheelRail::Calc(const WheelsetMotion& motion, Side side, const RailOffset& rail,
                     const RailSupport& support, WheelRailForces* out) const noexcept {
  if (const auto& linear = impl_->params.linear) {
    CalcLinearContact(*linear, impl_->params.wheel_radius, impl_->params.speed_floor, motion, out);
    return;
  }
  *out = WheelRailForces{};
  const Vec3 shift = MirrorPolar({0, rail.lateral, rail.vertical}, side);
  const TouchingPoints points =
      impl_->search->Find({motion.lateral, motion.vertical, motion.roll, motion.yaw},
                          impl_->rail_y + shift[1], shift[2]);
  if (points.count == 0) return;
  const Vec3 bend = impl_->Deflect(points, support);
  out->rail_lateral = bend[1];
  out->rail_vertical = bend[2];
  out->stored_energy = 0.5 * (support.lateral_stiffness_N_per_m * bend[1] * bend[1] +
                              support.vertical_stiffness_N_per_m * bend[2] * bend[2]);
  for (int i = 0; i < points.count; ++i) {
    const TouchingPoint& p = points.point[static_cast<size_t>(i)];
    const PatchAxes axes = AxesOf(p, SlopesAt(p, motion, side, rail));
    const double approach = p.depth - Dot(axes.normal, bend);
    if (approach > 0 && out->count < kMaxPatches) {
      impl_->Press(motion, p, axes, approach, support, out);
    }
  }
}

}  // namespace phs::rail
