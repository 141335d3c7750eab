// A bogie from a URDF and its mapping as MJCF, ready for simulate and compare (docs/import.md).
//
// The URDF gives links, masses, inertias and places; the mapping gives meaning and springs. Rules:
//   - the frame is the root link; it gets a free joint;
//   - axle boxes and other sprung links hang on the frame by a joint of type "floating", or "fixed"
//     to which the mapping's directions are added; each direction with springs becomes a slide or
//     hinge through the link's origin, in the order of the mapping; directions that are not named
//     are rigid;
//   - a wheelset hangs on its boxes by a "continuous" joint about y: its spin;
//   - every link has mass; links that the mapping does not name must be fixed to one that it does,
//     and are carried along as rigid bodies.
#pragma once

#include <string>

#include "base/result.h"
#include "vehicle/bogie_mapping.h"
#include "vehicle/urdf_file.h"

namespace phs::vehicle {

/// MJCF text. Errors name the URDF element or the mapping's entry.
Result<std::string> ImportBogie(const UrdfModel& urdf, const BogieMapping& mapping);

}  // namespace phs::vehicle
