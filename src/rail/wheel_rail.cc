#include "rail/wheel_rail.h"

#include <algorithm>
#include <cmath>

#include "rail/elastic_rail.h"
#include "rail/linear_contact.h"
#include "rail/wheel_rail_impl.h"

namespace phs::rail {
namespace {

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

/// The sums that depend on speed.
void ClearSpeedSums(WheelRailForces* out) {
  out->force = out->moment = {};
  out->t_gamma = out->t_gamma_spin = 0;
  out->creep_power = out->damping_power = 0;
  out->beyond_profile = false;
}

/// All but the patches, which are filled one by one.
void ClearSums(WheelRailForces* out) {
  ClearSpeedSums(out);
  out->count = 0;
  out->elastic_force = out->elastic_moment = {};
  out->stored_energy = 0;
  out->rail_lateral = out->rail_vertical = 0;
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

}  // namespace

int WheelRailForces::contacts() const {
  double places = 0;
  for (int k = 0; k < count; ++k) places += patch[static_cast<size_t>(k)].weight;
  return static_cast<int>(std::lround(places));
}

double WheelRail::LongitudinalCoefficient(const ContactPatch& patch, double speed) const noexcept {
  if (impl_->params.linear) return impl_->params.linear->f11_N;
  constexpr double kSmallCreep = 1e-7;
  const CreepForce force = impl_->creep->Calc(
      {patch.a, patch.b, patch.normal, kSmallCreep, 0, 0, speed, patch.friction});
  return std::abs(force.x) / kSmallCreep;
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
    impl_->search->FindPoints({lateral, height, roll, yaw}, impl_->rail_y, 0,
                              ContactSearch::Depth::kVertical, &found);
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

void WheelRail::Calc(const WheelsetMotion& motion, Side side, const RailOffset& rail,
                     const RailSupport& support, WheelRailForces* out) const noexcept {
  PressedWheel pressed;
  Press(motion, side, rail, support, &pressed, out);
  CalcForces(motion, pressed, out);
}

void WheelRail::Press(const WheelsetMotion& motion, Side side, const RailOffset& rail,
                      const RailSupport& support, PressedWheel* pressed,
                      WheelRailForces* out) const noexcept {
  ClearSums(out);
  if (impl_->params.linear) return;
  const Vec3 shift = MirrorPolar({0, rail.lateral, rail.vertical}, side);
  Vec3 bend{};
  Overlaps found;
  const Vec3 rest =
      FindOnSupport(*impl_->search, {motion.lateral, motion.vertical, motion.roll, motion.yaw},
                    impl_->rail_y + shift[1], shift[2], support, &bend, &found);
  if (found.count == 0) return;
  out->rail_lateral = bend[1];
  out->rail_vertical = bend[2];
  out->stored_energy = 0.5 * (support.lateral_stiffness_N_per_m * bend[1] * bend[1] +
                              support.vertical_stiffness_N_per_m * bend[2] * bend[2]);
  for (int i = 0; i < found.count; ++i) {
    const Overlap& p = found.patch[static_cast<size_t>(i)];
    const double approach = p.depth - Dot(NormalOf(p), rest);
    if (!(approach > 0)) continue;
    impl_->Press(p, approach, SlopesAt(p, motion, side, rail), ForwardPush(p, motion, side, rail),
                 support, pressed, out);
  }
}

void WheelRail::CalcForces(const WheelsetMotion& motion, const PressedWheel& pressed,
                           WheelRailForces* out, WheelDamping* damping,
                           WheelMemo* memo) const noexcept {
  if (damping != nullptr) damping->count = 0;
  if (const auto& linear = impl_->params.linear) {
    CalcLinearContact(*linear, impl_->params.wheel_radius, impl_->params.speed_floor, motion, out,
                      damping);
    return;
  }
  ClearSpeedSums(out);
  for (int k = 0; k < out->count; ++k) {
    const auto i = static_cast<size_t>(k);
    impl_->AddForces(motion, pressed.patch[i], &out->patch[i], out, damping,
                     memo == nullptr ? nullptr : &(*memo)[i]);
  }
}

}  // namespace phs::rail
