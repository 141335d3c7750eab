// The acceleration of the Earth, as the models that ship have it.
#pragma once

namespace phs {

inline constexpr double kGravity = 9.81;  ///< [m/s2]

}  // namespace phs
