#include "effects/temperature_drift.h"

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  hydraulics::TemperatureTerms& t = extension->temperature();
  t.present = true;
  t.rate_K_per_s = effect.values.at("rate_K_per_s");
  t.start_s = effect.values.at("start_s");
  t.settling_s = effect.values.at("settling_s");
  t.limit_K = effect.values.at("limit_K");
  t.amplitude_K = effect.values.at("amplitude_K");
  t.period_s = effect.values.at("period_s");
  t.expansion_1_per_K = effect.values.at("expansion_1_per_K");
  t.softening_1_per_K = effect.values.at("softening_1_per_K");
  for (size_t i = 0; i < extension->params().lines.size(); ++i) {
    const int line = static_cast<int>(i);
    extension->line(line).expansion_ratio = LineFactor(effect, extension->params(), line);
  }
  return {};
}

}  // namespace

const EffectInfo& TemperatureDriftInfo() {
  static const EffectInfo info = {
      "temperature_drift",
      "environment",
      "",
      "T = T_static + rate t from start_s on (limited, or rate T_s (1 - exp(-t/T_s))) + A sin(2 pi "
      "t/period)",
      {
          {"rate_K_per_s", "K/s", 0.01, -10, 10, -0.05, 0.05, "r"},
          {"settling_s", "s", 0, 0, 1e6, 0, 1e4, "T_s of a warming that settles; 0 = never"},
          {"start_s", "s", 0, -1e12, 1e12, 0, 1e6, "the ramp begins at this time"},
          {"limit_K", "K", 40, 0, 100, 1, 60, "limit of the ramp"},
          {"amplitude_K", "K", 0, -60, 60, -30, 30, "A; < 0: it first cools"},
          {"period_s", "s", 86400, 1e-3, 1e12, 60, 1e5, "period"},
          {"expansion_1_per_K", "1/K", 6.65e-4, 0, 0.01, 0, 1e-3, "oil less housing"},
          {"softening_1_per_K", "1/K", 0, 0, 0.02, 0, 0.012, "relative fall of the bulk modulus"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5,
           "expansion of the oil of rod lines over that of bore lines"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
