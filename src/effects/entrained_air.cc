#include "effects/entrained_air.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "effects/targets.h"
#include "hydraulics/gas_law.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

/// Free share at equilibrium: dissolved in proportion to pressure (Henry's law), all of it at
/// `saturation`; 0 = air never dissolves.
struct Solution {
  double saturation = 0;
  double FreeShare(double p, double* slope) const {
    *slope = 0;
    if (saturation <= hydraulics::kAtmosphere) return 1;
    const double range = saturation - hydraulics::kAtmosphere;
    const double free = 1 - (p - hydraulics::kAtmosphere) / range;
    if (free > 0 && free < 1) *slope = -1 / range;
    return std::clamp(free, 0.0, 1.0);
  }
  double PressureOf(double free) const {
    return hydraulics::kAtmosphere + (1 - free) * (saturation - hydraulics::kAtmosphere);
  }
};

/// Volume of all the air, were it free, at p: A p^(-1/n), A = V_a p_a^(1/n).
struct Bubble {
  double volume = 0, exponent = 1;
  double At(double p) const {
    const double ratio = hydraulics::kAtmosphere / p;
    return volume * (exponent == 1 ? ratio : std::pow(ratio, 1 / exponent));
  }
};

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

/// Dissolving with a lag: V = bubble(p) s, tau ds/dt = free(p) - s; memory s - s(p0).
/// Stored: s A u(p) + phi(s) with u = int (1/n) p^(-1/n) dp from p0, phi' = -A h(p_s(s)), p_s the
/// pressure at which s is the equilibrium, h = p^(1-1/n) + u; lost A (h(p_s) - h(p)) ds/dt >= 0.
class LaggingAir final : public hydraulics::VolumeLaw {
 public:
  LaggingAir(Bubble bubble, Solution solution, double time, double p0)
      : bubble_(bubble), solution_(solution), time_(time), p0_(p0) {
    double slope;
    start_ = solution.FreeShare(p0, &slope);
    amount_ = bubble.volume * std::pow(hydraulics::kAtmosphere, 1 / bubble.exponent);
    static_volume_ = start_ * bubble.At(p0);
  }
  void Add(double pressure, double memory, double* volume, double* slope) const noexcept override {
    const double bubble = bubble_.At(pressure), free = start_ + memory;
    *volume += static_volume_ - bubble * free;
    *slope += bubble * std::max(free, 0.0) / (bubble_.exponent * pressure);
  }
  double Energy(double pressure, double memory) const noexcept override {
    constexpr int kPanels = 32;
    const double step = memory / kPanels;
    double sum = 0;
    for (int i = 0; i <= 2 * kPanels; ++i) {
      const double p = solution_.PressureOf(start_ + 0.5 * i * step);
      sum += (i == 0 || i == 2 * kPanels ? 1 : (i % 2 == 1 ? 4 : 2)) * Potential(p);
    }
    return amount_ * ((start_ + memory) * Work(pressure) - sum * step / 6);
  }
  std::string MemoryName() const override { return "free_air"; }
  hydraulics::MemoryRate Memory(double pressure, double memory) const noexcept override {
    hydraulics::MemoryRate out;
    const double s = start_ + memory;
    out.rate = (solution_.FreeShare(pressure, &out.rate_rise) - s) / time_;
    out.rate_rise /= time_;
    out.rate_slope = -1 / time_;
    out.volume_rise = -bubble_.At(pressure);
    out.loss = amount_ * (Potential(solution_.PressureOf(s)) - Potential(pressure)) * out.rate;
    return out;
  }

 private:
  double Work(double p) const {
    const double log_ratio = std::log(p / p0_), e = 1 - 1 / bubble_.exponent;
    const double power =
        std::abs(e) < 1e-9 ? log_ratio : std::pow(p0_, e) * std::expm1(e * log_ratio) / e;
    return power / bubble_.exponent;
  }
  double Potential(double p) const { return std::pow(p, 1 - 1 / bubble_.exponent) + Work(p); }
  Bubble bubble_;
  Solution solution_;
  double time_, p0_, start_ = 1, amount_ = 0, static_volume_ = 0;
};

Status Install(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    const hydraulics::LineParams& l = extension->line(line);
    const double volume = effect.values.at("air_fraction") *
                          LineFactor(effect, extension->params(), line) * l.oil_volume_m3;
    const Bubble bubble{volume, effect.values.at("polytropic_exponent")};
    const Solution solution{effect.values.at("saturation_Pa")};
    const double time = effect.values.at("dissolving_time_s");
    if (time > 0 && solution.saturation > hydraulics::kAtmosphere) {
      extension->AddVolume(
          line, std::make_unique<LaggingAir>(bubble, solution, time, l.static_pressure_Pa));
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
          {"polytropic_exponent", "-", 1.0, 0.9, 1.7, 1, 1.4, "n"},
          {"saturation_Pa", "Pa", 0, 0, 1e9, 0, 3e7, "all air dissolved above; 0 = never"},
          {"dissolving_time_s", "s", 0, 0, 1e6, 0, 60, "lag of dissolving; 0 = at once"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5, "air of rod lines over that of bore lines"},
      },
      Install};
  return info;
}

}  // namespace phs::effects
