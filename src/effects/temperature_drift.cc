#include "effects/temperature_drift.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/drift_time.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Walk;

class Ramp final : public hydraulics::AmbientLaw {
 public:
  explicit Ramp(const EffectParams& effect)
      : rate_(effect.values.at("rate_K_per_s")),
        start_s_(effect.values.at("start_s")),
        stop_s_(effect.values.at("stop_s")),
        settling_s_(effect.values.at("settling_s")),
        limit_K_(effect.values.at("limit_K")) {}
  double Rise(double time) const noexcept override {
    const double seconds = DriftTime(time, start_s_, settling_s_, stop_s_);
    return std::clamp(rate_ * seconds, -limit_K_, limit_K_);
  }

 private:
  double rate_, start_s_, stop_s_, settling_s_, limit_K_;
};

class Swing final : public hydraulics::AmbientLaw {
 public:
  explicit Swing(const EffectParams& effect)
      : amplitude_K_(effect.values.at("amplitude_K")),
        cosine_K_(effect.values.at("cosine_K")),
        period_s_(effect.values.at("period_s")) {}
  double Rise(double time) const noexcept override {
    const double phase = 2 * M_PI * time / period_s_;
    return amplitude_K_ * std::sin(phase) + cosine_K_ * (std::cos(phase) - 1);
  }

 private:
  double amplitude_K_, cosine_K_, period_s_;
};

Status InstallTemperatureDrift(const EffectParams& effect, Extension* extension) {
  extension->AddAmbient(std::make_unique<Ramp>(effect));
  extension->AddAmbient(std::make_unique<Swing>(effect));
  for (size_t i = 0; i < extension->params().lines.size(); ++i) {
    const int line = static_cast<int>(i);
    hydraulics::LineParams& l = extension->line(line);
    l.expansion_1_per_K =
        LineFactor(effect, extension->params(), line) * effect.values.at("expansion_1_per_K");
    l.softening_1_per_K = effect.values.at("softening_1_per_K");
  }
  return {};
}

}  // namespace

const EffectInfo& TemperatureDriftInfo() {
  static const EffectInfo info = {
      "temperature_drift",
      "environment",
      "",
      "T = T_static + rate t from start_s on (limited, or rate T_s (1 - exp(-t/T_s)), back again "
      "from "
      "stop_s on) + A sin(2 pi t/period) + B (cos(2 pi t/period) - 1)",
      {
          {"rate_K_per_s", "K/s", 0.01, -10, 10, -0.05, 0.05, "r"},
          {"settling_s", "s", 0, 0, 1e6, 0, 1e4, "T_s of a warming that settles; 0 = never"},
          {"start_s", "s", 0, -1e12, 1e12, 0, 1e6, "the ramp begins at this time"},
          {"stop_s", "s", 1e12, -1e12, 1e12, 0, 1e6,
           "it ends there, and with T_s what it gave goes"},
          {"limit_K", "K", 40, 0, 100, 1, 60, "limit of the ramp"},
          {"amplitude_K", "K", 0, -60, 60, -30, 30, "A; < 0: it first cools"},
          {"cosine_K", "K", 0, -60, 60, -30, 30, "of a swing that does not begin in its middle"},
          {"period_s", "s", 86400, 1e-3, 1e12, 10, 1e5, "period"},
          {"expansion_1_per_K", "1/K", 6.65e-4, 0, 0.01, 0, 1e-3, "oil less housing"},
          {"softening_1_per_K", "1/K", 0, 0, 0.02, 0, 0.012, "relative fall of the bulk modulus"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5,
           "expansion of the oil of rod lines over that of bore lines"},
      },
      InstallTemperatureDrift,
      {
          .rig =
              {
                  {.free = {{"rate_K_per_s", 0.04, 2e-3, 2, Walk::kEitherWay},
                            {"settling_s", 50, 1000, 2, Walk::kInStep}}},
                  {.free = {{"amplitude_K", 1}, {"period_s", 25, 300, 5}},
                   .held = {{"rate_K_per_s", 0}}},
              },
          .options =
              {
                  {.free = {{"cosine_K", 0}}, .with = "period_s"},
                  {.free = {{"expansion_1_per_K", 4e-4}}},
                  {.free = {{"softening_1_per_K", 4e-3}}},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
                  {.free = {{"start_s", 15, 60, 3}}, .without = "period_s"},
                  {.free = {{"stop_s", 15, 60, 3}}, .without = "period_s"},
              },
          .over = {"m3_per_s", "t"},
      }};
  return info;
}

}  // namespace phs::effects
