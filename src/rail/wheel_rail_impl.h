// What a WheelRail holds, for its own files: made once (wheel_rail_create.cc), searched
// (wheel_rail.cc), pressed patch by patch (wheel_rail_patch.cc).
#pragma once

#include <memory>

#include "rail/contact_search.h"
#include "rail/hertz.h"
#include "rail/wheel_rail.h"

namespace phs::rail {

struct WheelRail::Impl {
  WheelRailParams params;
  std::unique_ptr<CreepLaw> creep;
  std::unique_ptr<ContactSearch> search;
  Hertz hertz{82e9, 0.28};
  double rail_y = 0;    ///< origin of the rail profile from the track centre [m]
  double touching = 0;  ///< z_C of the wheelset centre at mere touch
  double flange = 0;    ///< largest flange angle [rad]
  double climb_y = 0;   ///< contacts at smaller y of the wheel profile climb [m]

  /// One more patch: its place, shape and elastic force, added to the sums.
  void Press(const Overlap& overlap, double approach, const Vec3& slopes, double forward_push,
             const RailSupport& support, PressedWheel* pressed,
             WheelRailForces* out) const noexcept;
  /// Normal and creep force of a pressed patch at the speeds of `motion`, added to the sums.
  void AddForces(const WheelsetMotion& motion, const PressedPatch& pressed, ContactPatch* patch,
                 WheelRailForces* out, WheelDamping* damping, CreepMemo* memo) const noexcept;
  /// On the wheelset, about its centre.
  struct Wrench {
    Vec3 force, moment;
  };
  /// Creepages and creep force of a patch whose normal force (of the whole patch) is known: its
  /// wrench; wear and power are added to the sums.
  Wrench AddCreep(const WheelsetMotion& motion, const PressedPatch& axes, ContactPatch* patch,
                  WheelRailForces* out, WheelDamping* damping, CreepMemo* memo) const noexcept;
};

}  // namespace phs::rail
