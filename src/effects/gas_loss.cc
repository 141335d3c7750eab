#include "effects/gas_loss.h"

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

/// V = m V_g0 p0/p: what oil fills where gas has gone; no more than m times the shell.
class LostGas final : public hydraulics::VolumeLaw {
 public:
  LostGas(const EffectParams& effect, double rate, const hydraulics::LineParams& line)
      : rate_(rate),
        exponent_(effect.values.at("exponent")),
        start_Pa_(effect.values.at("start_Pa")),
        amount_(line.gas_volume_m3 * line.static_pressure_Pa),
        p0_(line.static_pressure_Pa),
        fills_(line.reservoir.volume_m3 > 0 ? amount_ / line.reservoir.volume_m3 : 0) {}
  void Add(double pressure, double memory, double* volume, double* slope) const noexcept override {
    const double room = memory * Room(pressure);
    *volume += room;
    if (pressure > fills_) *slope -= room / pressure;
  }
  // At m held, -m p0 V_g0 ln(p/p_a), p_a the atmosphere: what the gas that went does not store.
  double Energy(double pressure, double memory) const noexcept override {
    return -memory * Stored(pressure);
  }
  std::string MemoryName() const override { return "gas_lost"; }
  hydraulics::MemoryRate Memory(double pressure, double memory) const noexcept override {
    const double beyond = (pressure - start_Pa_) / p0_, left = (1 - memory) / kLast;
    hydraulics::MemoryRate out;
    out.volume_rise = Room(pressure);
    if (!(beyond > 0) || !(left > 0)) return out;
    const double full = rate_ * std::pow(beyond, exponent_), part = std::min(1.0, left);
    out.rate = full * part;
    if (left < 1) out.rate_slope = -full / kLast;
    out.rate_rise = exponent_ * out.rate / (pressure - start_Pa_);
    return out;
  }
  double Loss(double pressure, double memory) const noexcept override {
    const double of_all = pressure * Room(pressure) + Stored(pressure);
    return of_all * Memory(pressure, memory).rate;
  }

 private:
  /// Of all the gas at p: its volume [m3], and what it stores against the atmosphere [J].
  double Room(double pressure) const { return amount_ / std::max(pressure, fills_); }
  double Stored(double pressure) const {
    return amount_ * std::log(std::max(pressure, fills_) / hydraulics::kAtmosphere);
  }
  static constexpr double kLast = 0.05;  // the last of it goes ever more slowly
  double rate_, exponent_, start_Pa_, amount_, p0_;
  double fills_;  // the gas fills its shell there [Pa]
};

Status InstallGasLoss(const EffectParams& effect, Extension* extension) {
  const double rate = effect.values.at("loss_1_per_s");
  if (rate <= 0) return {};
  for (const int line : TargetLines(effect, extension->params())) {
    const hydraulics::LineParams& l = extension->line(line);
    if (l.gas_volume_m3 <= 0) continue;
    const double own = rate * LineFactor(effect, extension->params(), line);
    extension->AddVolume(line, std::make_unique<LostGas>(effect, own, l));
  }
  return {};
}

}  // namespace

const EffectInfo& GasLossInfo() {
  static const EffectInfo info = {
      "gas_loss",
      "hydraulic",
      "lines",
      "dm/dt = r ((p - p_s)/p0)^k: share m of the reservoir's gas that has gone",
      {
          {"loss_1_per_s", "1/s", 1e-4, 0, 1, 1e-7, 0.05, "r: share that goes per second at p0"},
          {"exponent", "-", 1, 0, 4, 0, 3, "k: 1 with the pressure, 0 steadily"},
          {"start_Pa", "Pa", 0, 0, 1e9, 0, 2e7, "p_s: gas goes beyond it; 0: at any pressure"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5, "loss of rod lines over that of bore lines"},
      },
      InstallGasLoss,
      {
          .rig =
              {
                  {.free = {{"loss_1_per_s", 1e-4, 1e-2, 3}}, .places = Places::kEach},
              },
          .options =
              {
                  {.free = {{"exponent", 0.3, 1.7, 2}}},
                  {.free = {{"start_Pa", 2e6, 6e6, 2}}},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
              },
      }};
  return info;
}

}  // namespace phs::effects
