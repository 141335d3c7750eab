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

struct RestNumbers {
  double extra_N, time_s, length_m;
};

/// Memory: 1 - phi.
class Dwell final : public hydraulics::LevelLaw {
 public:
  explicit Dwell(const RestNumbers& of) : of_(of) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->extra += of_.extra_N * (1 - place.memory);
  }
  std::string MemoryName() const override { return "dwell"; }
  double MemoryRate(double v, double memory) const noexcept override {
    return -memory / of_.time_s + (1 - memory) * std::abs(v) / of_.length_m;
  }
  double AdvanceMemory(double h, double v, double memory) const noexcept override {
    const double moved = std::abs(v) / of_.length_m;
    const double rate = 1 / of_.time_s + moved;
    const double settled = moved / rate;
    return settled + (memory - settled) * std::exp(-rate * h);
  }

 private:
  RestNumbers of_;
};

/// Memory: a = ln(1 + theta/tau).
class Ageing final : public hydraulics::LevelLaw {
 public:
  explicit Ageing(const RestNumbers& of) : of_(of) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->extra += of_.extra_N * place.memory;
  }
  std::string MemoryName() const override { return "dwell"; }
  double MemoryRate(double v, double memory) const noexcept override {
    const double young = std::exp(-memory);
    return young / of_.time_s - (1 - young) * std::abs(v) / of_.length_m;
  }
  /// At a speed theta comes near d/|v| exponentially.
  double AdvanceMemory(double h, double v, double memory) const noexcept override {
    const double rate = std::abs(v) / of_.length_m, way = rate * h;
    const double grown = way > 1e-9 ? -std::expm1(-way) / rate : h;
    return std::log1p(std::expm1(memory) * std::exp(-way) + grown / of_.time_s);
  }

 private:
  RestNumbers of_;
};

Status InstallDwellFriction(const EffectParams& effect, Extension* extension) {
  if (effect.values.at("extra_N") == 0) return {};
  const RestNumbers of = {effect.values.at("extra_N"), effect.values.at("time_s"),
                          effect.values.at("length_m")};
  const bool ages = effect.values.at("logarithmic") != 0;
  for (int i : TargetCylinders(effect, extension->params())) {
    if (ages) {
      extension->AddLevel(i, std::make_unique<Ageing>(of));
    } else {
      extension->AddLevel(i, std::make_unique<Dwell>(of));
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
