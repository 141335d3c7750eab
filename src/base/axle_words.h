// Where an axle points, in the words of every table, card and sentence: no sign can be mistaken.
#pragma once

#include <string_view>

namespace phs {

/// "left" of a left-hand curve (hand > 0), "right" of a right-hand one, "" without a curve.
const char* HandWord(int hand);
/// +1, -1 or 0 of such a word.
int HandOf(std::string_view word);

/// "outer" or "inner" (rail of the curve), "left" or "right" on straight track; "" if the angle is
/// no number.
/// @param angle_of_attack yaw against the radial direction [rad], > 0 to the left
/// @param hand +1 a left-hand curve, -1 a right-hand one, 0 no curve
const char* RailPointedTo(double angle_of_attack, int hand);

}  // namespace phs
