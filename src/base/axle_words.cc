#include "base/axle_words.h"

#include <cmath>

namespace phs {

const char* HandWord(int hand) { return hand > 0 ? "left" : hand < 0 ? "right" : ""; }

int HandOf(std::string_view word) { return word == "left" ? 1 : word == "right" ? -1 : 0; }

const char* RailPointedTo(double angle_of_attack, int hand) {
  if (!std::isfinite(angle_of_attack)) return "";
  if (hand == 0) return angle_of_attack >= 0 ? "left" : "right";
  return hand * angle_of_attack <= 0 ? "outer" : "inner";
}

}  // namespace phs
