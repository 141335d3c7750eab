#include "effects/presliding.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"
#include "hydraulics/bristle.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Walk;

class Bristle : public hydraulics::BristleLaw {
 public:
  explicit Bristle(const EffectParams& effect)
      : stiffness_(effect.values.at("stiffness_N_per_m")), share_(effect.values.at("share")) {}
  double Stiffness() const final { return stiffness_; }
  double Share() const final { return share_; }

 private:
  double stiffness_, share_;
};

class StickingBristle final : public Bristle {
 public:
  explicit StickingBristle(const EffectParams& effect)
      : Bristle(effect), law_{effect.values.at("breakaway_ratio")} {}
  double Yield(double along, double z_s) const noexcept override { return law_.Yield(along, z_s); }
  double Advance(double along, double way, double z_s) const noexcept override {
    return law_.Advance(along, way, z_s);
  }

 private:
  hydraulics::ElastoPlastic law_;
};

double SignedPower(double x, double n) { return std::copysign(std::pow(std::abs(x), n), x); }

/// g = 1 - along/z_s; after a way x [z_s]: dg/dx = -sgn(g) |g|^i.
class CreepingBristle final : public Bristle {
 public:
  explicit CreepingBristle(const EffectParams& effect)
      : Bristle(effect), exponent_(effect.values.at("exponent")) {}
  /// Behind a reversal g = 2.
  double Steepest() const override { return std::exp2(exponent_); }
  double Yield(double along, double z_s) const noexcept override {
    return exponent_ == 1 ? along / z_s : 1 - SignedPower(1 - along / z_s, exponent_);
  }
  double Advance(double along, double way, double z_s) const noexcept override {
    return z_s * (1 - GapAfter(1 - along / z_s, way / z_s));
  }

 private:
  double GapAfter(double gap, double x) const {
    if (std::abs(exponent_ - 1) < 1e-9 || gap == 0) return gap * std::exp(-x);
    const double left = std::pow(std::abs(gap), 1 - exponent_) + (exponent_ - 1) * x;
    return left > 0 ? std::copysign(std::pow(left, 1 / (1 - exponent_)), gap) : 0;
  }
  double exponent_;
};

Status InstallPresliding(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    if (effect.values.at("creeping") >= 0.5) {
      extension->SetBristle(i, std::make_unique<CreepingBristle>(effect));
    } else {
      extension->SetBristle(i, std::make_unique<StickingBristle>(effect));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& PreslidingInfo() {
  static const EffectInfo info = {
      "presliding",
      "friction",
      "cylinders",
      "elasto-plastic bristle of stiffness sigma0",
      {
          {"stiffness_N_per_m", "N/m", 3.6e7, 1e3, 1e12, 2e6, 5e8, "sigma0"},
          {"breakaway_ratio", "-", 0.7, 0, 0.99, 0.1, 0.95, "elastic share of the level"},
          {"creeping", "-", 0, 0, 1, 0, 1, "1: bristle of Dahl and LuGre, 0: elasto-plastic"},
          {"exponent", "-", 1, 0.05, 10, 0.3, 4, "i of the creeping bristle (Dahl)"},
          {"share", "-", 1, 0.01, 1, 0.02, 1, "of the level that sticks; the rest slides at once"},
      },
      InstallPresliding,
      {
          .rig =
              {
                  {.free = {{"stiffness_N_per_m", 6e6, 1e8, 3}, {"breakaway_ratio", 0.5}}},
                  {.free = {{"stiffness_N_per_m", 1e7, 1.5e8, 3}, {"exponent", 1, 2, 2}},
                   .held = {{"creeping", 1}, {"breakaway_ratio", 0}}},
                  {.free = {{"stiffness_N_per_m", 6e6, 1e8, 3}, {"share", 0.2}},
                   .held = {{"breakaway_ratio", 0.5}}},
              },
          .bench =
              {
                  {.free = {{"stiffness_N_per_m", 10, 1e4, 4, Walk::kEach, 2, 1e6}},
                   .held = {{"breakaway_ratio", 0.5}},
                   .of_static_friction = true},
              },
          .options =
              {
                  {.free = {{"share", 0.7}}},
              },
          .over = {"N", "s"},
      }};
  return info;
}

}  // namespace phs::effects
