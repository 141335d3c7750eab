#include "effects/entrained_air.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/targets.h"
#include "hydraulics/gas_law.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

class AirVolume final : public hydraulics::VolumeLaw {
 public:
  AirVolume(double volume, double exponent, double saturation, double p0)
      : volume_(volume), exponent_(exponent), saturation_(saturation), p0_(p0) {
    double slope;
    static_volume_ = Volume(p0, &slope);
  }
  void Add(double pressure, double* volume, double* slope) const noexcept override {
    double dV_dp;
    *volume += static_volume_ - Volume(pressure, &dV_dp);
    *slope -= dV_dp;
  }
  // No closed form with dissolving: Simpson in log p, exact enough for energy balances (1e-9).
  double Energy(double pressure) const noexcept override {
    constexpr int kPanels = 64;
    const double a = std::log(p0_), step = (std::log(pressure) - a) / kPanels;
    double sum = 0;
    for (int i = 0; i <= 2 * kPanels; ++i) {
      const double p = std::exp(a + 0.5 * i * step);
      double dV_dp;
      Volume(p, &dV_dp);
      sum += (i == 0 || i == 2 * kPanels ? 1 : (i % 2 == 1 ? 4 : 2)) * -dV_dp * p * p;
    }
    return sum * step / 6;
  }

 private:
  double Volume(double p, double* dV_dp) const {
    const double pa = hydraulics::kAtmosphere;
    const double bubble = volume_ * std::pow(pa / p, 1 / exponent_);
    double free = 1, free_slope = 0;
    if (saturation_ > pa) {
      free = std::clamp(1 - (p - pa) / (saturation_ - pa), 0.0, 1.0);
      if (free > 0 && free < 1) free_slope = -1 / (saturation_ - pa);
    }
    *dV_dp = -bubble * free * free / (exponent_ * p) + 2 * bubble * free * free_slope;
    return bubble * free * free;
  }
  double volume_, exponent_, saturation_, p0_, static_volume_ = 0;
};

Status Install(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    const hydraulics::LineParams& l = extension->line(line);
    extension->AddVolume(
        line, std::make_unique<AirVolume>(effect.values.at("air_fraction") * l.oil_volume_m3,
                                          effect.values.at("polytropic_exponent"),
                                          effect.values.at("saturation_Pa"), l.static_pressure_Pa));
  }
  return {};
}

}  // namespace

const EffectInfo& EntrainedAirInfo() {
  static const EffectInfo info = {
      "entrained_air",
      "hydraulic",
      "lines",
      "free air of a share of the oil volume, V ~ p^(-1/n), optionally dissolving",
      {
          {"air_fraction", "-", 0.005, 0, 0.5, 1e-4, 0.05,
           "air at atmospheric pressure per oil volume"},
          {"polytropic_exponent", "-", 1.0, 0.9, 1.7, 1, 1.4, "n"},
          {"saturation_Pa", "Pa", 0, 0, 1e9, 0, 3e7, "all air dissolved above; 0 = never"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
