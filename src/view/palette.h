// Colours of what is drawn, in one place.
#pragma once

#include <algorithm>
#include <array>

#include "view/pen.h"

namespace phs::view {

inline constexpr Colour kWheelColour{0.52f, 0.54f, 0.57f, 1};
inline constexpr Colour kRailColour{0.47f, 0.43f, 0.40f, 1};
inline constexpr Colour kSleeperColour{0.62f, 0.60f, 0.56f, 1};
inline constexpr Colour kClipColour{0.25f, 0.24f, 0.24f, 1};
inline constexpr Colour kBallastColour{0.50f, 0.47f, 0.43f, 1};
inline constexpr Colour kGroundColour{0.48f, 0.53f, 0.40f, 1};
inline constexpr Colour kCoilColour{0.86f, 0.62f, 0.12f, 1};
inline constexpr Colour kDamperColour{0.20f, 0.42f, 0.30f, 1};
inline constexpr Colour kChromeColour{0.86f, 0.88f, 0.90f, 1};
inline constexpr Colour kEyeColour{0.22f, 0.23f, 0.25f, 1};
inline constexpr Colour kLinkColour{0.70f, 0.22f, 0.16f, 1};
inline constexpr Colour kLoadColour{0.25f, 0.45f, 0.85f, 1};     ///< Q
inline constexpr Colour kGuidingColour{0.95f, 0.50f, 0.05f, 1};  ///< Y
inline constexpr Colour kForwardColour{0.10f, 0.62f, 0.30f, 1};  ///< X
inline constexpr Colour kPushColour{0.85f, 0.10f, 0.15f, 1};     ///< a cylinder that pushes
inline constexpr Colour kPullColour{0.45f, 0.20f, 0.75f, 1};     ///< a cylinder that pulls

/// From low (blue) over cyan, green and yellow to high (red); `share` 0 … 1.
inline Colour ScaleColour(double share) {
  static constexpr std::array<Colour, 5> kStops = {
      Colour{0.16f, 0.25f, 0.75f, 1}, Colour{0.10f, 0.66f, 0.85f, 1},
      Colour{0.25f, 0.75f, 0.30f, 1}, Colour{0.98f, 0.82f, 0.15f, 1},
      Colour{0.86f, 0.12f, 0.10f, 1}};
  const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const size_t i = std::min(static_cast<size_t>(place), kStops.size() - 2);
  const float t = static_cast<float>(place - static_cast<double>(i));
  const Colour& a = kStops[i];
  const Colour& b = kStops[i + 1];
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b), 1};
}

}  // namespace phs::view
