#include "rail/running_safety.h"

#include <cmath>

namespace phs::rail {

double CalcNadalLimit(double flange_angle, double friction) {
  const double tangent = std::tan(flange_angle);
  return (tangent - friction) / (1 + friction * tangent);
}

double CalcTrackShiftLimit(double static_wheel_load, double k1) {
  return k1 * (10e3 + 2 * static_wheel_load / 3);
}

}  // namespace phs::rail
