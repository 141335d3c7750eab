#include "rail/wheel_rail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rail/contact_force.h"
#include "rail/contact_search.h"

namespace phs::rail {
namespace {

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

}  // namespace

struct WheelRail::Impl {
  WheelRailParams params;
  std::unique_ptr<CreepLaw> creep;
  std::unique_ptr<ContactSearch> search;
  ContactForceLaw law;
  double rail_y = 0;    ///< origin of the rail profile from the track centre [m]
  double touching = 0;  ///< z_C of the wheelset centre at mere touch
  double flange = 0;
};

WheelRail::WheelRail(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WheelRail::WheelRail(WheelRail&&) noexcept = default;
WheelRail& WheelRail::operator=(WheelRail&&) noexcept = default;
WheelRail::~WheelRail() = default;
const WheelRailParams& WheelRail::params() const { return impl_->params; }
const CreepLaw& WheelRail::creep_law() const { return *impl_->creep; }
double WheelRail::touching_height() const { return impl_->touching; }
double WheelRail::flange_angle() const { return impl_->flange; }

Result<WheelRail> WheelRail::Create(const WheelRailParams& params) {
  if (Status s = Validate(params); !s.ok()) return s.error();
  auto impl = std::make_unique<Impl>();
  impl->params = params;
  auto wheel = LoadProfile(params.wheel_profile, ProfileKind::kWheel);
  if (!wheel.ok()) return wheel.error();
  auto rail = LoadProfile(params.rail_profile, ProfileKind::kRail);
  if (!rail.ok()) return rail.error();
  rail.value().Incline(params.rail_cant);
  rail.value().PutTopAtZero();
  auto creep = CreateCreepLaw(params.creep);
  if (!creep.ok()) return creep.error();
  impl->creep = std::move(creep).value();
  impl->law.params = &impl->params;
  impl->law.creep = impl->creep.get();
  impl->law.hertz =
      Hertz(params.creep.material.shear_modulus_Pa, params.creep.material.poisson_ratio);
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

void WheelRail::Calc(const WheelsetMotion& motion, Side side, const RailOffset& rail,
                     const RailSupport& support, WheelRailForces* out) const noexcept {
  const Vec3 shift = MirrorPolar({0, rail.lateral, rail.vertical}, side);
  Vec3 bend{};
  Overlaps found;
  impl_->law.FindOnSupport(*impl_->search,
                           {motion.lateral, motion.vertical, motion.roll, motion.yaw},
                           impl_->rail_y + shift[1], shift[2], support, &bend, &found);
  ClearSums(out);
  if (found.count == 0) return;
  out->rail_lateral = bend[1];
  out->rail_vertical = bend[2];
  out->stored_energy = 0.5 * (support.lateral_stiffness_N_per_m * bend[1] * bend[1] +
                              support.vertical_stiffness_N_per_m * bend[2] * bend[2]);
  for (int i = 0; i < found.count; ++i) {
    const Overlap& p = found.patch[static_cast<size_t>(i)];
    const PatchAxes axes = AxesOf(p.slope, SlopesAt(p, motion, side, rail));
    impl_->law.AddPatch(motion, found.axle, p, axes, support, out);
  }
}

}  // namespace phs::rail
