#include "effects/entrained_air.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/dissolving_air.h"
#include "effects/targets.h"
#include "hydraulics/gas_law.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;
using hydraulics::Walk;

/// Dissolving at once: V = bubble(p) free(p).
class AirVolume final : public hydraulics::VolumeLaw {
 public:
  AirVolume(Bubble bubble, Solution solution, double p0)
      : bubble_(bubble), solution_(solution), p0_(p0) {
    double slope;
    static_volume_ = Volume(p0, &slope);
  }
  void Add(double pressure, double, double* volume, double* slope) const noexcept override {
    double dV_dp;
    *volume += static_volume_ - Volume(pressure, &dV_dp);
    *slope -= dV_dp;
  }
  // p V - p0 V0 - int V dp by parts, Simpson in log p: V is continuous where its slope is not.
  double Energy(double pressure, double) const noexcept override {
    constexpr int kPanels = 256;
    const double a = std::log(p0_), step = (std::log(pressure) - a) / kPanels;
    double sum = 0, slope;
    for (int i = 0; i <= 2 * kPanels; ++i) {
      const double p = std::exp(a + 0.5 * i * step);
      sum += (i == 0 || i == 2 * kPanels ? 1 : (i % 2 == 1 ? 4 : 2)) * Volume(p, &slope) * p;
    }
    return sum * step / 6 - (pressure * Volume(pressure, &slope) - p0_ * static_volume_);
  }

 private:
  double Volume(double p, double* dV_dp) const {
    double free_slope;
    const double bubble = bubble_.At(p), free = solution_.FreeShare(p, &free_slope);
    *dV_dp = -bubble * free / (bubble_.exponent * p) + bubble * free_slope;
    return bubble * free;
  }
  Bubble bubble_;
  Solution solution_;
  double p0_, static_volume_ = 0;
};

Status InstallEntrainedAir(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    const hydraulics::LineParams& l = extension->line(line);
    const double volume = effect.values.at("air_fraction") *
                          LineFactor(effect, extension->params(), line) * l.oil_volume_m3;
    const Bubble bubble{volume, effect.values.at("polytropic_exponent")};
    const Solution solution{effect.values.at("saturation_Pa"), hydraulics::kAtmosphere};
    const double time = effect.values.at("dissolving_time_s");
    if (time > 0 && solution.Dissolves()) {
      const LagTimes times{time * effect.values.at("release_ratio"), time};
      extension->AddVolume(
          line, std::make_unique<LaggingAir>(bubble, solution, times, l.static_pressure_Pa));
    } else {
      extension->AddVolume(line,
                           std::make_unique<AirVolume>(bubble, solution, l.static_pressure_Pa));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& EntrainedAirInfo() {
  static const EffectInfo info = {
      "entrained_air",
      "hydraulic",
      "lines",
      "free air of a share of the oil volume, V ~ p^(-1/n), dissolving by Henry's law at once or "
      "with a lag",
      {
          {"air_fraction", "-", 0.005, 0, 0.5, 1e-4, 0.2,
           "air at atmospheric pressure per oil volume"},
          {"polytropic_exponent", "-", 1.0, 0.9, 1.8, 1, 1.7, "n"},
          {"saturation_Pa", "Pa", 0, 0, 1e9, 0, 3e7, "all air dissolved above; 0 = never"},
          {"dissolving_time_s", "s", 0, 0, 1e6, 0, 60, "lag of dissolving; 0 = at once"},
          {"release_ratio", "-", 1, 1e-3, 1e3, 0.05, 20,
           "lag with which it comes out over that of dissolving"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5, "air of rod lines over that of bore lines"},
      },
      InstallEntrainedAir,
      {
          .rig =
              {
                  {.free = {{"air_fraction", 1e-3, 0.02, 3}}, .places = Places::kEach},
                  {.free = {{"air_fraction", 5e-3, 0.01, 2},
                            {"saturation_Pa", 4e6, 1e7, 2, Walk::kInStep}},
                   .places = Places::kEach},
                  {.free = {{"air_fraction", 0.01}, {"dissolving_time_s", 0.4, 2, 2}},
                   .held = {{"saturation_Pa", 8e6}}},
                  {.free = {{"air_fraction", 0.01}, {"dissolving_time_s", 1}},
                   .held = {{"saturation_Pa", 8e6}},
                   .places = Places::kAlone},
              },
          .bogie =
              {
                  {.free = {{"air_fraction", 3e-3, 0.02, 2}}},
              },
          .options =
              {
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
                  {.free = {{"saturation_Pa", 4e6, 1e7, 2}}},
                  {.free = {{"polytropic_exponent", 1.1}}},
                  {.free = {{"dissolving_time_s", 0.3, 2, 2}}, .with = "saturation_Pa"},
                  {.free = {{"release_ratio", 0.4, 2.5, 2}}, .with = "dissolving_time_s"},
              },
          .over = {"m3", "p"},
      }};
  return info;
}

}  // namespace phs::effects
