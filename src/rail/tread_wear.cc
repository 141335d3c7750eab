#include "rail/tread_wear.h"

#include <cmath>
#include <numbers>

namespace phs::rail {

Status Validate(const TreadWear& wear) {
  const auto in = [](double x, double low, double high) { return x >= low && x <= high; };
  if (!in(wear.depth_m, -0.005, 0.005)) {
    return Error{"tread wear", "depth_m is out of range", "-0.005 … 0.005 m", ""};
  }
  if (!in(wear.half_width_m, 0.01, 0.06)) {
    return Error{"tread wear", "half_width_m is out of range", "0.01 … 0.06 m", ""};
  }
  if (!in(wear.centre_m, -0.03, 0.03)) {
    return Error{"tread wear", "centre_m is out of range", "-0.03 … 0.03 m", ""};
  }
  return {};
}

void WearTread(const TreadWear& wear, Profile* wheel) {
  if (!wear.any()) return;
  wheel->Lower([&](double y) {
    const double u = (y - wear.centre_m) / wear.half_width_m;
    return std::abs(u) < 1 ? 0.5 * wear.depth_m * (1 + std::cos(std::numbers::pi * u)) : 0.0;
  });
}

}  // namespace phs::rail
