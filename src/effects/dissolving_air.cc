#include "effects/dissolving_air.h"

#include <algorithm>
#include <cmath>

namespace phs::effects {

double Solution::FreeShare(double p, double* slope) const {
  *slope = 0;
  if (!Dissolves()) return 1;
  const double range = saturation - all_free;
  const double free = 1 - (p - all_free) / range;
  if (free > 0 && free < 1) *slope = -1 / range;
  return std::clamp(free, 0.0, 1.0);
}

double Bubble::At(double p) const {
  const double ratio = hydraulics::kAtmosphere / p;
  return volume * (exponent == 1 ? ratio : std::pow(ratio, 1 / exponent));
}

LaggingAir::LaggingAir(Bubble bubble, Solution solution, LagTimes times, double p0)
    : bubble_(bubble), solution_(solution), times_(times), p0_(p0) {
  double slope;
  start_ = solution.FreeShare(p0, &slope);
  amount_ = bubble.volume * std::pow(hydraulics::kAtmosphere, 1 / bubble.exponent);
  static_volume_ = start_ * bubble.At(p0);
}

void LaggingAir::Add(double pressure, double memory, double* volume, double* slope) const noexcept {
  const double bubble = bubble_.At(pressure), free = start_ + memory;
  *volume += static_volume_ - bubble * free;
  *slope += bubble * std::max(free, 0.0) / (bubble_.exponent * pressure);
}

double LaggingAir::Energy(double pressure, double memory) const noexcept {
  constexpr int kPanels = 32;
  const double step = memory / kPanels;
  double sum = 0;
  for (int i = 0; i <= 2 * kPanels; ++i) {
    const double p = solution_.PressureOf(start_ + 0.5 * i * step);
    sum += (i == 0 || i == 2 * kPanels ? 1 : (i % 2 == 1 ? 4 : 2)) * Potential(p);
  }
  return amount_ * ((start_ + memory) * Work(pressure) - sum * step / 6);
}

hydraulics::MemoryRate LaggingAir::Memory(double pressure, double memory) const noexcept {
  hydraulics::MemoryRate out;
  const double s = start_ + memory;
  const double missing = solution_.FreeShare(pressure, &out.rate_rise) - s;
  const double time = missing > 0 ? times_.release_s : times_.dissolving_s;
  out.rate = missing / time;
  out.rate_rise /= time;
  out.rate_slope = -1 / time;
  out.volume_rise = -bubble_.At(pressure);
  return out;
}

double LaggingAir::Loss(double pressure, double memory) const noexcept {
  const double solved = solution_.PressureOf(start_ + memory);
  return amount_ * (Potential(solved) - Potential(pressure)) * Memory(pressure, memory).rate;
}

double LaggingAir::Work(double p) const {
  const double log_ratio = std::log(p / p0_), e = 1 - 1 / bubble_.exponent;
  const double power =
      std::abs(e) < 1e-9 ? log_ratio : std::pow(p0_, e) * std::expm1(e * log_ratio) / e;
  return power / bubble_.exponent;
}

double LaggingAir::Potential(double p) const {
  return std::pow(p, 1 - 1 / bubble_.exponent) + Work(p);
}

}  // namespace phs::effects
