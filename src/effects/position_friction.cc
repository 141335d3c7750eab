#include "effects/position_friction.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::LevelParts;
using hydraulics::LevelPlace;
using hydraulics::Walk;

class PositionLevel final : public hydraulics::LevelLaw {
 public:
  explicit PositionLevel(const EffectParams& effect)
      : slope_(effect.values.at("slope_1_per_m")),
        curvature_(effect.values.at("curvature_1_per_m2")),
        spot_share_(effect.values.at("spot_share")),
        spot_centre_(effect.values.at("spot_centre_m")),
        spot_width_(effect.values.at("spot_width_m")),
        wave_sine_(effect.values.at("wave_sine")),
        wave_cosine_(effect.values.at("wave_cosine")),
        wave_length_(effect.values.at("wave_length_m")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    const double y = place.at.piston;
    double shape = 1 + (slope_ + curvature_ * y) * y;
    if (spot_share_ != 0) {
      const double away = (y - spot_centre_) / spot_width_;
      shape += spot_share_ * std::exp(-away * away);
    }
    if (wave_sine_ != 0 || wave_cosine_ != 0) {
      const double phase = 2 * M_PI * y / wave_length_;
      shape += wave_sine_ * std::sin(phase) + wave_cosine_ * (std::cos(phase) - 1);
    }
    level->of_curve *= std::max(shape, 0.0);
  }

 private:
  double slope_, curvature_;
  double spot_share_, spot_centre_, spot_width_;
  double wave_sine_, wave_cosine_, wave_length_;
};

Status InstallPositionFriction(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddLevel(i, std::make_unique<PositionLevel>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& PositionFrictionInfo() {
  static const EffectInfo info = {
      "position_friction",
      "friction",
      "cylinders",
      "level times 1 + s y + c y^2 + tight spot b exp(-((y-y0)/w)^2) + wave",
      {
          {"slope_1_per_m", "1/m", 20, -1e5, 1e5, -500, 500, "s"},
          {"curvature_1_per_m2", "1/m2", 0, -1e9, 1e9, -1e5, 1e5, "c"},
          {"spot_share", "-", 0, -1, 20, -0.5, 2, "b"},
          {"spot_centre_m", "m", 0, -1, 1, -0.03, 0.03, "y0"},
          {"spot_width_m", "m", 1e-3, 1e-6, 1, 1e-4, 0.02, "w"},
          {"wave_sine", "-", 0, -1, 1, -0.9, 0.9, "of the wave"},
          {"wave_cosine", "-", 0, -1, 1, -0.9, 0.9, "of the wave"},
          {"wave_length_m", "m", 1e-3, 1e-6, 1, 2e-4, 0.02, "period"},
      },
      InstallPositionFriction,
      {
          .rig =
              {
                  {.free = {{"slope_1_per_m", 0}}},
                  {.free = {{"spot_share", 0.1},
                            {"spot_centre_m", -1.5e-3, 1.5e-3, 4},
                            {"spot_width_m", 1e-3}},
                   .held = {{"slope_1_per_m", 0}}},
                  {.free = {{"spot_share", 0.1},
                            {"spot_centre_m", -6e-3, 6e-3, 3},
                            {"spot_width_m", 3e-3}},
                   .held = {{"slope_1_per_m", 0}}},
                  {.free = {{"wave_sine", 0}, {"wave_cosine", 0}, {"wave_length_m", 8e-4, 6e-3, 7}},
                   .held = {{"slope_1_per_m", 0}},
                   .amounts = 2},
                  {.free = {{"slope_1_per_m", 0}, {"curvature_1_per_m2", 0}}},
              },
          .bench =
              {
                  {.free = {{"slope_1_per_m", 0, 0, 1, Walk::kEach, -1, 1}}},
                  {.free = {{"slope_1_per_m", 0, 0, 1, Walk::kEach, -1, 1},
                            {"curvature_1_per_m2", 0, 0, 1, Walk::kEach, -1, 5}}},
              },
          .bogie =
              {
                  {.free = {{"slope_1_per_m", 0}}},
              },
          .options =
              {
                  {.free = {{"slope_1_per_m", 0}}},
              },
          // A tight spot wider than the stroke, or a slope where hardly anything moves.
          .contains = {"seal_friction"},
          .over = {"N", "sx"},
      }};
  return info;
}

}  // namespace phs::effects
