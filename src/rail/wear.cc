#include "rail/wear.h"

#include <cmath>

namespace phs::rail {
namespace {

constexpr double kMildEnd = 100;    // [N]
constexpr double kSevereEnd = 200;  // [N]

}  // namespace

TGamma CalcTGamma(const CreepInput& c, const CreepForce& f) noexcept {
  return {std::abs(f.x * c.xi) + std::abs(f.y * c.eta), std::abs(f.moment * c.phi)};
}

const char* NameOf(WearRegime regime) {
  switch (regime) {
    case WearRegime::kMild:
      return "mild";
    case WearRegime::kSevere:
      return "severe";
    case WearRegime::kCatastrophic:
      return "catastrophic";
  }
  return "";
}

WearRegime WearRegimeOf(double t_gamma) noexcept {
  if (t_gamma <= kMildEnd) return WearRegime::kMild;
  return t_gamma <= kSevereEnd ? WearRegime::kSevere : WearRegime::kCatastrophic;
}

double CalcWornAreaPerKm(double t_gamma, double wheel_diameter) noexcept {
  const double per_mm = 1 / (1e3 * wheel_diameter);
  switch (WearRegimeOf(t_gamma)) {
    case WearRegime::kMild:
      return 0.25 * t_gamma * per_mm;
    case WearRegime::kSevere:
      return 25 * per_mm;
    case WearRegime::kCatastrophic:
      break;
  }
  return (1.19 * t_gamma - 154) * per_mm;
}

double CalcSheffieldWearRate(double t_gamma, double contact_area) noexcept {
  const double q = t_gamma / (1e6 * contact_area);
  if (q <= 10.4) return 5.3 * q;
  if (q <= 77.2) return 55;
  return 61.9 * (q - 77.2) + 55;
}

double CalcRcfDamage(double t_gamma, bool net_of_wear) noexcept {
  constexpr double kStart = 20;
  constexpr double kPeak = 65;
  constexpr double kEnd = 175;
  constexpr double kLargest = 1e-5;
  if (t_gamma <= kStart) return 0;
  if (t_gamma <= kPeak) return kLargest * (t_gamma - kStart) / (kPeak - kStart);
  if (t_gamma <= kEnd || net_of_wear) return kLargest * (kEnd - t_gamma) / (kEnd - kPeak);
  return 0;
}

}  // namespace phs::rail
