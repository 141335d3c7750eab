// Contact of one wheel with one rail: search, Hertz, creepages, creep forces. Canonical frame C
// (frames.h): right wheel, x forward, y outward, z down; origin of C = track frame origin of the
// wheelset's arc length. Left wheels are mirrored by the caller.
//
// The wheelset is a rigid body: centre (y, z) above the track, attitude yaw then roll, spinning
// about its own axle. Force and moment are those *on the wheelset*, moment about its centre.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "rail/creep_law.h"
#include "rail/frames.h"
#include "rail/profile.h"
#include "rail/track.h"
#include "rail/tread_wear.h"
#include "rail/wheel_contact.h"

namespace phs::rail {

/// Immutable; thread-safe; Calc does not allocate.
class WheelRail {
 public:
  static Result<WheelRail> Create(const WheelRailParams& params);
  WheelRail(WheelRail&&) noexcept;
  WheelRail& operator=(WheelRail&&) noexcept;
  ~WheelRail();

  /// `rail` in T axes is mirrored inside by `side`; `support` may be all zero (rigid track).
  void Calc(const WheelsetMotion& motion, Side side, const RailOffset& rail,
            const RailSupport& support, WheelRailForces* out) const noexcept;
  /// The same in two parts. Press: all that position decides (patches, elastic forces, what is
  /// stored); reads no speed of `motion`.
  void Press(const WheelsetMotion& motion, Side side, const RailOffset& rail,
             const RailSupport& support, PressedWheel* pressed,
             WheelRailForces* out) const noexcept;
  /// Then the forces at the speeds of `motion`, as often as wanted; `out` as Press left it. With
  /// `damping`, also how they resist a change of these speeds. `memo` of the same pressed wheel: filled
  /// with `damping`, else used.
  void CalcForces(const WheelsetMotion& motion, const PressedWheel& pressed, WheelRailForces* out,
                  WheelDamping* damping = nullptr, WheelMemo* memo = nullptr) const noexcept;
  const WheelRailParams& params() const;
  const CreepLaw& creep_law() const;
  /// A wheel lowered on the undisplaced rail until it touches; position in C.
  TouchPoint Touch(double lateral, double roll, double yaw) const noexcept;
  /// Linear longitudinal creep coefficient f11 of a patch at rolling speed `speed` [N].
  double LongitudinalCoefficient(const ContactPatch& patch, double speed) const noexcept;
  /// z_C of the wheelset centre at which a centred, unrolled wheelset just touches the rail.
  double touching_height() const;
  /// Largest flange angle of the wheel profile [rad] (Nadal, derailment).
  double flange_angle() const;
  /// The profiles as they are used (worn, inclined); null where numbers stand for them.
  const Profile* wheel_profile() const;
  const Profile* rail_profile() const;
  /// Origin of the rail profile from the track centre [m].
  double rail_position() const;
  /// Origin of the wheel profile from the wheelset's centre [m].
  double wheel_position() const;

 private:
  struct Impl;
  explicit WheelRail(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace phs::rail
