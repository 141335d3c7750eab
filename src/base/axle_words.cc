#include "base/axle_words.h"

#include <cmath>

namespace phs {

const char* RailPointedTo(double angle_of_attack, int hand) {
  if (!std::isfinite(angle_of_attack)) return "";
  if (hand == 0) return angle_of_attack >= 0 ? "left" : "right";
  return hand * angle_of_attack <= 0 ? "outer" : "inner";
}

}  // namespace phs
