#include "effects/pressure_friction.h"

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

class PressedSeal final : public hydraulics::LevelLaw {
 public:
  /// `at_rest`: p_bore - p_rod in the static state [Pa].
  PressedSeal(const EffectParams& effect, double at_rest)
      : bore_(effect.values.at("bore_N_per_Pa")),
        rod_(effect.values.at("rod_N_per_Pa")),
        difference_(effect.values.at("difference_N_per_Pa")),
        retraction_ratio_(effect.values.at("retraction_ratio")),
        at_rest_(at_rest) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    double grip = bore_ * place.at.bore_rise + rod_ * place.at.rod_rise;
    if (difference_ != 0) {
      grip += difference_ *
              (std::abs(at_rest_ + place.at.bore_rise - place.at.rod_rise) - std::abs(at_rest_));
    }
    level->extra += place.sign > 0 ? grip : retraction_ratio_ * grip;
  }
  bool DependsOnPressure() const override { return bore_ != 0 || rod_ != 0 || difference_ != 0; }

 private:
  double bore_, rod_, difference_, retraction_ratio_, at_rest_;
};

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto& c = extension->params().cylinders[static_cast<size_t>(i)];
    const double at_rest =
        StaticPressure(c.bore_line, *extension) - StaticPressure(c.rod_line, *extension);
    extension->AddLevel(i, std::make_unique<PressedSeal>(effect, at_rest));
  }
  return {};
}

}  // namespace

const EffectInfo& PressureFrictionInfo() {
  static const EffectInfo info = {
      "pressure_friction",
      "friction",
      "cylinders",
      "level + k (p - p0) of each chamber + k_d (|p_bore - p_rod| - at rest), by direction",
      {
          {"bore_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_bore"},
          {"rod_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_rod"},
          {"difference_N_per_Pa", "N/Pa", 0, -1, 1, 0, 1e-2, "k_d"},
          {"retraction_ratio", "-", 1, 0, 1e3, 0.05, 20, "of these terms, in retraction"},
      },
      Install,
      {
          .rig =
              {
                  {.free = {{"bore_N_per_Pa", 2e-5}}, .held = {{"rod_N_per_Pa", 0}}},
                  {.free = {{"rod_N_per_Pa", 2e-5}}, .held = {{"bore_N_per_Pa", 0}}},
                  {.free = {{"bore_N_per_Pa", 2e-5}, {"rod_N_per_Pa", 2e-5}}, .amounts = 2},
                  {.free = {{"difference_N_per_Pa", 2e-5}},
                   .held = {{"bore_N_per_Pa", 0}, {"rod_N_per_Pa", 0}}},
              },
          .bench =
              {
                  {.free = {{"bore_N_per_Pa", 0.1, 0, 1, Walk::kEach, -1, 20}},
                   .held = {{"rod_N_per_Pa", 0}},
                   .needs = {"p_Pa"}},
              },
          .bogie =
              {
                  {.free = {{"bore_N_per_Pa", 2e-5}, {"rod_N_per_Pa", 2e-5}}, .amounts = 2},
              },
          .options =
              {
                  {.free = {{"difference_N_per_Pa", 0}}},
                  {.free = {{"retraction_ratio", 1}}},
              },
          .over = {"N", "spq"},
      }};
  return info;
}

}  // namespace phs::effects
