// One axle box's springs other than the rest. The boxes of an axle are one body on joints of their
// own, whose stiffness k is that of all n boxes of the body; what one box has beyond its share,
// (f - 1) k / n, is a spring at its place r:
//
//   length    l = q + sum over hinges of ((h x (r - a)) . s) phi     of every slide joint q along s
//   force     (f - 1) k / n (l_0 - l), l_0 at the joints' own springref: same free length
//
// phi the hinge's angle, h its axis, a its anchor. Dampers stay. A box is a site NAME_box.
#pragma once

#include <mujoco/mujoco.h>
#include <tinyxml2.h>

#include <string>
#include <vector>

#include "base/result.h"
#include "vehicle/scenario.h"

namespace phs::vehicle {

/// Boxes of a vehicle, without "_box": "lead_left"; those whose body stands on a slide joint with a
/// spring.
std::vector<std::string> BoxNames(const mjModel* m);

/// Puts the further springs into the document, from `m`, what it compiles to without them. Errors:
/// no such box, with those there are.
Status AddBoxSprings(const Scenario& scenario, const mjModel* m, tinyxml2::XMLElement* root);

}  // namespace phs::vehicle
