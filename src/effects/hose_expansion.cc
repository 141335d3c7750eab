#include "effects/hose_expansion.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;

/// Integral of a^(e-1) da from a0 to a.
double PowerIntegral(double a0, double a, double e) {
  const double log_ratio = std::log(a / a0);
  return std::abs(e) < 1e-9 ? log_ratio : std::pow(a0, e) * std::expm1(e * log_ratio) / e;
}

/// Volume for a compliance of one at no pressure: dV/dp = a^-m, a = 1 + p/p_k.
class HoseCurve {
 public:
  HoseCurve(double stiffening, double order, double p0)
      : stiffening_(stiffening),
        order_(order),
        start_(1 + p0 / stiffening),
        start_power_(std::pow(start_, 1 - order)) {}
  double Volume(double pressure, double* slope) const {
    // a^(1-m) = a0^(1-m) (1 + g) serves both the integral and the slope.
    const double a = 1 + pressure / stiffening_, e = 1 - order_;
    const double log_ratio = std::log(a / start_), growth = std::expm1(e * log_ratio);
    *slope = start_power_ * (1 + growth) / a;
    return stiffening_ * (std::abs(e) < 1e-9 ? log_ratio : start_power_ * growth / e);
  }
  /// p dV = p_k² (a - 1) a^-m da.
  double Energy(double pressure) const {
    const double a = 1 + pressure / stiffening_;
    return stiffening_ * stiffening_ *
           (PowerIntegral(start_, a, 2 - order_) - PowerIntegral(start_, a, 1 - order_));
  }
  /// Where the volume is that; of one that no pressure gives, a pressure beyond all.
  double PressureOf(double volume) const {
    constexpr double kLeast = 1e-12;
    const double e = 1 - order_, in_units = volume / stiffening_;
    const double log_ratio = std::abs(e) < 1e-9
                                 ? in_units
                                 : std::log(std::max(1 + e * in_units / start_power_, kLeast)) / e;
    return stiffening_ * (start_ * std::exp(log_ratio) - 1);
  }

 private:
  double stiffening_, order_, start_, start_power_;
};

class HoseVolume final : public hydraulics::VolumeLaw {
 public:
  /// `compliance`: at no pressure.
  HoseVolume(double compliance, const HoseCurve& curve) : compliance_(compliance), curve_(curve) {}
  void Add(double pressure, double, double* volume, double* slope) const noexcept override {
    double own;
    *volume += compliance_ * curve_.Volume(pressure, &own);
    *slope += compliance_ * own;
  }
  double Energy(double pressure, double) const noexcept override {
    return compliance_ * curve_.Energy(pressure);
  }

 private:
  double compliance_;
  HoseCurve curve_;
};

/// Kelvin-Voigt element: w = C_c P m,  tau dm/dt = (p - p0)/P - m. Stored C_c (p0 P m + P² m²/2).
class CreepVolume final : public hydraulics::VolumeLaw {
 public:
  CreepVolume(double compliance, double time, double p0)
      : compliance_(compliance), time_(time), p0_(p0) {}
  void Add(double, double memory, double* volume, double*) const noexcept override {
    *volume += compliance_ * kScale * memory;
  }
  double Energy(double, double memory) const noexcept override {
    return compliance_ * kScale * memory * (p0_ + 0.5 * kScale * memory);
  }
  std::string MemoryName() const override { return "hose_creep"; }
  hydraulics::MemoryRate Memory(double pressure, double memory) const noexcept override {
    return {Behind(pressure, memory) / time_, -1 / time_, 1 / (time_ * kScale),
            compliance_ * kScale};
  }
  double Loss(double pressure, double memory) const noexcept override {
    const double behind = kScale * Behind(pressure, memory);
    return compliance_ * behind * behind / time_;
  }

 private:
  double Behind(double pressure, double memory) const { return (pressure - p0_) / kScale - memory; }
  static constexpr double kScale = 1e7;  // P [Pa]: makes the memory of the order of one
  double compliance_, time_, p0_;
};

/// The same behind a braid: w = C P m,  tau dm/dt = V(p)/P - m, V of the curve. With p_w the
/// pressure at which V = P m, stored C int p_w dV, lost C (p - p_w) (V(p) - P m)/tau >= 0.
class BraidedCreep final : public hydraulics::VolumeLaw {
 public:
  /// `compliance`: at no pressure.
  BraidedCreep(double compliance, double time, const HoseCurve& curve)
      : compliance_(compliance), time_(time), curve_(curve) {}
  void Add(double, double memory, double* volume, double*) const noexcept override {
    *volume += compliance_ * kScale * memory;
  }
  double Energy(double, double memory) const noexcept override {
    return compliance_ * curve_.Energy(curve_.PressureOf(kScale * memory));
  }
  std::string MemoryName() const override { return "hose_creep"; }
  hydraulics::MemoryRate Memory(double pressure, double memory) const noexcept override {
    double slope;
    const double behind = curve_.Volume(pressure, &slope) / kScale - memory;
    return {behind / time_, -1 / time_, slope / (time_ * kScale), compliance_ * kScale};
  }
  double Loss(double pressure, double memory) const noexcept override {
    double slope;
    const double behind = curve_.Volume(pressure, &slope) - kScale * memory;
    return compliance_ * behind * (pressure - curve_.PressureOf(kScale * memory)) / time_;
  }

 private:
  static constexpr double kScale = 1e7;  // P [Pa], as above
  double compliance_, time_;
  HoseCurve curve_;
};

/// Elements that share what comes late, `add(share, time)`: one, or three with times a factor d apart.
template <typename Add>
void AddLate(const EffectParams& effect, const Add& add) {
  const double time = effect.values.at("creep_time_s"), d = effect.values.at("creep_spread");
  if (d == 1) return add(1.0, time);
  for (const double own : {time / d, time, time * d}) add(1.0 / 3, own);
}

Status InstallHoseExpansion(const EffectParams& effect, Extension* extension) {
  for (int line : TargetLines(effect, extension->params())) {
    const double p0 = extension->line(line).static_pressure_Pa;
    const double factor = LineFactor(effect, extension->params(), line);
    const double stiffening = effect.values.at("stiffening_Pa");
    const double order = effect.values.at("stiffening_order");
    const double late = effect.values.at("late_share");
    const double whole = factor * effect.values.at("compliance_m3_per_Pa") *
                         std::pow(1 + effect.values.at("stated_at_Pa") / stiffening, order);
    const double creeping = factor * effect.values.at("creep_m3_per_Pa");
    const HoseCurve curve(stiffening, order, p0);
    if (const double at_once = (1 - late) * whole; at_once > 0) {
      extension->AddVolume(line, std::make_unique<HoseVolume>(at_once, curve));
    }
    if (late * whole > 0) {
      AddLate(effect, [&](double share, double time) {
        extension->AddVolume(line,
                             std::make_unique<BraidedCreep>(share * late * whole, time, curve));
      });
    }
    if (creeping > 0) {
      AddLate(effect, [&](double share, double time) {
        extension->AddVolume(line, std::make_unique<CreepVolume>(share * creeping, time, p0));
      });
    }
  }
  return {};
}

}  // namespace

const EffectInfo& HoseExpansionInfo() {
  static const EffectInfo info = {
      "hose_expansion",
      "hydraulic",
      "lines",
      "dV/dp = C ((p_k + p)/(p_k + p_s))^-m, a share of it late, and a creeping part tau dw/dt = "
      "C_c (p - p0) - w",
      {
          {"compliance_m3_per_Pa", "m3/Pa", 2e-13, 0, 1e-9, 1e-14, 5e-11, "C"},
          {"stiffening_Pa", "Pa", 1e9, 1e4, 1e12, 1e6, 1e9, "p_k"},
          {"stiffening_order", "-", 1, 0, 100, 0.5, 20, "m; many: nearly exponential"},
          {"stated_at_Pa", "Pa", 0, 0, 1e8, 0, 1e7, "p_s: C is the compliance there"},
          {"creep_m3_per_Pa", "m3/Pa", 0, 0, 1e-9, 0, 2e-11, "C_c"},
          {"creep_time_s", "s", 1, 1e-4, 1e6, 0.05, 60, "tau"},
          {"late_share", "-", 0, 0, 1, 0, 1, "s: of dV/dp, that comes with tau"},
          {"creep_spread", "-", 1, 1, 100, 1, 30, "d: a third each with tau/d, tau, tau d"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5,
           "compliance of rod lines over that of bore lines"},
      },
      InstallHoseExpansion,
      {
          .rig =
              {
                  // One that never stiffens is oil volume, which is free already.
                  {.free = {{"compliance_m3_per_Pa", 2e-13, 1e-12, 2},
                            {"stiffening_Pa", 8e6, 5e7, 2}},
                   .held = {{"stated_at_Pa", 2e6}},
                   .places = Places::kEach,
                   .amounts = 2},
                  // A braid that locks: nearly exp(-p/p_k m).
                  {.free = {{"compliance_m3_per_Pa", 1e-12}, {"stiffening_Pa", 6e6, 4e7, 2}},
                   .held = {{"stated_at_Pa", 2e6}, {"stiffening_order", 8}},
                   .places = Places::kEach,
                   .amounts = 2},
                  // Rubber behind it that gives late.
                  {.free = {{"compliance_m3_per_Pa", 1e-12},
                            {"stiffening_Pa", 3e7},
                            {"late_share", 0.6},
                            {"creep_time_s", 0.4, 3, 2}},
                   .held = {{"stated_at_Pa", 2e6}, {"stiffening_order", 8}},
                   .places = Places::kEach,
                   .amounts = 2},
                  {.free = {{"creep_m3_per_Pa", 1e-13}, {"creep_time_s", 0.3, 4, 3}},
                   .held = {{"compliance_m3_per_Pa", 0}}},
                  {.free = {{"creep_m3_per_Pa", 1e-13}, {"creep_time_s", 1}},
                   .held = {{"compliance_m3_per_Pa", 0}},
                   .places = Places::kAlone},
              },
          .bogie =
              {
                  {.free = {{"compliance_m3_per_Pa", 1e-12}}},
              },
          .options =
              {
                  {.free = {{"stiffening_order", 4}}, .with = "compliance_m3_per_Pa"},
                  {.free = {{"creep_m3_per_Pa", 1e-13}, {"creep_time_s", 0.5, 4, 2}},
                   .without = "creep_time_s"},
                  {.free = {{"late_share", 0.3}, {"creep_time_s", 0.5, 4, 2}},
                   .with = "compliance_m3_per_Pa",
                   .without = "creep_time_s"},
                  {.free = {{"creep_spread", 5}}, .with = "creep_m3_per_Pa"},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
              },
          .over = {"m3", "p"},
      }};
  return info;
}

}  // namespace phs::effects
