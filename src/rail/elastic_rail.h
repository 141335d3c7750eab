// An elastic rail under a wheel: a section without mass on a lateral and a vertical spring.
//
// It stands displaced by w where the springs balance the contact, k w = F(w): the patches found
// with the rail at w give F, and with their shapes held F falls as Hertz's force, by depth^1.5 of
// each patch. Newton on the held shapes, a new search, Broyden's method for what the shapes change,
// until the rest is below 0.01 um. The first guess takes the deepest points of the undisplaced rail,
// as it gives way far more than the contact.
#pragma once

#include "rail/contact_search.h"
#include "rail/frames.h"
#include "rail/track.h"

namespace phs::rail {

/// Unit normal of a patch, into the rail.
Vec3 NormalOf(const Overlap& patch) noexcept;

/// Patches with the rail where its support holds it. `bend`: the displacement w in C; zero if both
/// springs are absent. Returned: the small rest of w by which the patches were found short of it.
Vec3 FindOnSupport(const ContactSearch& search, const WheelPlacement& wheel, double rail_y,
                   double rail_z, const RailSupport& support, Vec3* bend, Overlaps* found) noexcept;

}  // namespace phs::rail
