// A wheel and a rail put together: profiles read, worn, inclined, placed at their gauge.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rail/linear_contact.h"
#include "rail/wheel_rail_impl.h"

namespace phs::rail {
namespace {

/// Gauge less distance of the flange backs: two flanges of 20 … 40 mm and the clearance. 75 mm is
/// usual [m].
constexpr double kLeastRoom = 0.040;
constexpr double kMostRoom = 0.150;

Status CheckWheelRail(const WheelRailParams& p) {
  const auto in = [](double x, double low, double high) { return x >= low && x <= high; };
  if (!in(p.gauge, 0.3, 2.0)) return Error{"gauge", "is out of range", "0.3 … 2 m", ""};
  if (!in(p.wheel_radius, 0.1, 1.5))
    return Error{"wheel_radius", "is out of range", "0.1 … 1.5 m", ""};
  if (!p.linear && !in(p.flange_back_distance, p.gauge - kMostRoom, p.gauge - kLeastRoom)) {
    return Error{
        "flange_back_distance",
        fmt::format("of {:.4g} m does not fit the gauge of {:.4g} m", p.flange_back_distance,
                    p.gauge),
        fmt::format("{:.4g} … {:.4g} m on this gauge", p.gauge - kMostRoom, p.gauge - kLeastRoom),
        "give a track of the bogie's gauge (--track), or phs_flange_back_m in its MJCF"};
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

WheelRail::WheelRail(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WheelRail::WheelRail(WheelRail&&) noexcept = default;
WheelRail& WheelRail::operator=(WheelRail&&) noexcept = default;
WheelRail::~WheelRail() = default;
const WheelRailParams& WheelRail::params() const { return impl_->params; }
const CreepLaw& WheelRail::creep_law() const { return *impl_->creep; }
double WheelRail::touching_height() const { return impl_->touching; }
double WheelRail::flange_angle() const { return impl_->flange; }
const Profile* WheelRail::wheel_profile() const {
  return impl_->search == nullptr ? nullptr : &impl_->search->wheel();
}
const Profile* WheelRail::rail_profile() const {
  return impl_->search == nullptr ? nullptr : &impl_->search->rail();
}
double WheelRail::rail_position() const { return impl_->rail_y; }
double WheelRail::wheel_position() const {
  return impl_->search == nullptr ? 0 : impl_->search->half_tape();
}

Result<WheelRail> WheelRail::Create(const WheelRailParams& params) {
  if (Status s = CheckWheelRail(params); !s.ok()) return s.error();
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
  impl->search =
      std::make_unique<ContactSearch>(std::move(wheel).value(), std::move(rail).value(), half_tape,
                                      params.wheel_radius, impl->hertz, params.contact_fineness);
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

}  // namespace phs::rail
