#include "effects/dwell_friction.h"

#include <cmath>
#include <memory>
#include <string>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::LevelParts;
using hydraulics::LevelPlace;
using hydraulics::Walk;

/// Memory: 1 - phi.
class Dwell final : public hydraulics::LevelLaw {
 public:
  explicit Dwell(const EffectParams& effect)
      : extra_N_(effect.values.at("extra_N")),
        time_s_(effect.values.at("time_s")),
        length_m_(effect.values.at("length_m")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->extra += extra_N_ * (1 - place.memory);
  }
  std::string MemoryName() const override { return "dwell"; }
  double MemoryRate(double v, double memory) const noexcept override {
    return -memory / time_s_ + (1 - memory) * std::abs(v) / length_m_;
  }
  double AdvanceMemory(double h, double v, double memory) const noexcept override {
    const double moved = std::abs(v) / length_m_;
    const double rate = 1 / time_s_ + moved;
    const double settled = moved / rate;
    return settled + (memory - settled) * std::exp(-rate * h);
  }

 private:
  double extra_N_, time_s_, length_m_;
};

/// Memory: a = ln(1 + theta/tau).
class Ageing final : public hydraulics::LevelLaw {
 public:
  explicit Ageing(const EffectParams& effect)
      : extra_N_(effect.values.at("extra_N")),
        time_s_(effect.values.at("time_s")),
        length_m_(effect.values.at("length_m")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->extra += extra_N_ * place.memory;
  }
  std::string MemoryName() const override { return "dwell"; }
  double MemoryRate(double v, double memory) const noexcept override {
    const double young = std::exp(-memory);
    return young / time_s_ - (1 - young) * std::abs(v) / length_m_;
  }
  /// At a speed theta comes near d/|v| exponentially.
  double AdvanceMemory(double h, double v, double memory) const noexcept override {
    const double rate = std::abs(v) / length_m_, way = rate * h;
    const double grown = way > 1e-9 ? -std::expm1(-way) / rate : h;
    return std::log1p(std::expm1(memory) * std::exp(-way) + grown / time_s_);
  }

 private:
  double extra_N_, time_s_, length_m_;
};

Status InstallDwellFriction(const EffectParams& effect, Extension* extension) {
  if (effect.values.at("extra_N") == 0) return {};
  const bool ages = effect.values.at("logarithmic") != 0;
  for (int i : TargetCylinders(effect, extension->params())) {
    if (ages) {
      extension->AddLevel(i, std::make_unique<Ageing>(effect));
    } else {
      extension->AddLevel(i, std::make_unique<Dwell>(effect));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& DwellFrictionInfo() {
  static const EffectInfo info = {
      "dwell_friction",
      "friction",
      "cylinders",
      "level + F_d phi, phi grows at rest, up to one or as ln(1 + theta/tau), and is wiped out by "
      "sliding",
      {
          {"extra_N", "N", 300, 0, 1e6, 0, 10000, "F_d"},
          {"time_s", "s", 5, 1e-3, 1e9, 0.01, 1000, "tau"},
          {"length_m", "m", 1e-4, 1e-9, 1, 1e-5, 1e-3, "d"},
          {"logarithmic", "-", 0, 0, 1, 0, 1, "1: grows with the logarithm of the rest"},
      },
      InstallDwellFriction,
      {
          .rig =
              {
                  {.free = {{"extra_N", 300}, {"time_s", 1, 10, 2}, {"length_m", 2e-5, 5e-4, 2}}},
                  {.free = {{"extra_N", 200}, {"time_s", 0.1}, {"length_m", 5e-5, 5e-4, 2}},
                   .held = {{"logarithmic", 1}}},
              },
          .bench =
              {
                  {.free = {{"extra_N", 0.2, 0, 1, Walk::kEach, 0, 5},
                            {"time_s", 0.02, 0.1, 2, Walk::kEach, 1e-3, 1},
                            {"length_m", 0.01, 0.1, 2, Walk::kInStep, 1e-4, 1}}},
              },
          .bogie =
              {
                  {.free = {{"extra_N", 300}, {"time_s", 3}, {"length_m", 1e-4}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
