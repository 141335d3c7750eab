#include "effects/throttle.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Port;

Status InstallThrottle(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    for (Port chamber : {Port::kBore, Port::kRod}) {
      const double factor = chamber == Port::kRod ? effect.values.at("rod_ratio") : 1;
      const ThrottleParams p{
          factor * AtModelTemperature(effect.values.at("laminar_Pas_per_m3"), extension->params()),
          factor * effect.values.at("turbulent_Pas2_per_m6"), effect.values.at("relief_Pa"),
          effect.values.at("valve_Pas_per_m3")};
      extension->SplitChamber(chamber, i, effect.values.at("oil_share"), "throttle",
                              std::make_unique<ThrottleFlow>(p));
    }
  }
  return {};
}

}  // namespace

double ThrottleFlow::Flow(const hydraulics::FlowPlace& at, double dp,
                          double* slope) const noexcept {
  const double size = std::abs(dp), beyond = std::max(0.0, size - p_.relief);
  const double laminar = at.viscosity * p_.laminar;
  const double root = std::sqrt(laminar * laminar + 4 * p_.turbulent * size);
  *slope = 1 / root + (beyond > 0 ? 1 / p_.valve : 0);
  return std::copysign(2 * size / (laminar + root) + beyond / p_.valve, dp);
}

// Beyond the relief pressure, with g = 1/R_v and q_t > 0: q = q_t + g (R q_t + K q_t² - p_r), a
// quadratic in q_t; the form of its root that holds for K = 0, too.
double ThrottleFlow::Drop(const hydraulics::FlowPlace& at, double flow,
                          double* slope) const noexcept {
  const double size = std::abs(flow), laminar = at.viscosity * p_.laminar;
  double dp = (laminar + p_.turbulent * size) * size;
  *slope = laminar + 2 * p_.turbulent * size;
  if (dp > p_.relief) {
    const double g = 1 / p_.valve, b = 1 + g * laminar, c = size + g * p_.relief;
    const double throttled = 2 * c / (b + std::sqrt(b * b + 4 * g * p_.turbulent * c));
    dp = (laminar + p_.turbulent * throttled) * throttled;
    *slope = 1 / (1 / (laminar + 2 * p_.turbulent * throttled) + g);
  }
  return std::copysign(dp, flow);
}

const EffectInfo& ThrottleInfo() {
  static const EffectInfo info = {
      "throttle",
      "hydraulic",
      "cylinders",
      "p_chamber - p_line = R q + K q|q|, a relief valve beside it",
      {
          {"laminar_Pas_per_m3", "Pa s/m3", 1e10, 1e3, 1e16, 1e7, 1e12, "R at 20 °C"},
          {"turbulent_Pas2_per_m6", "Pa s2/m6", 0, 0, 1e20, 0, 1e16, "K"},
          {"relief_Pa", "Pa", 1.5e6, 1e4, 1e9, 2e5, 2e7, "the valve opens, in either direction"},
          {"valve_Pas_per_m3", "Pa s/m3", 1e9, 1e3, 1e16, 1e7, 1e11,
           "what the open valve adds per flow"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.02, 50,
           "R and K of the rod side over those of the bore side"},
          {"oil_share", "-", 0.2, 0.02, 0.45, 0.1, 0.4, "share of the line's oil at the chamber"},
      },
      InstallThrottle};
  return info;
}

}  // namespace phs::effects
