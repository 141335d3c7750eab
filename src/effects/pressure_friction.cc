#include "effects/pressure_friction.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/added_friction.h"
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
  /// `bore_rest`, `rod_rest`: pressures in the static state [Pa].
  PressedSeal(const EffectParams& effect, double bore_rest, double rod_rest)
      : bore_(effect.values.at("bore_N_per_Pa")),
        rod_(effect.values.at("rod_N_per_Pa")),
        bore_share_(effect.values.at("bore_1_per_Pa")),
        rod_share_(effect.values.at("rod_1_per_Pa")),
        larger_share_(effect.values.at("larger_1_per_Pa")),
        difference_(effect.values.at("difference_N_per_Pa")),
        retraction_ratio_(effect.values.at("retraction_ratio")),
        start_Pa_(effect.values.at("start_Pa")),
        exponent_(effect.values.at("exponent")),
        flat_Pa_(effect.values.at("flat_Pa")),
        turn_m_s_(effect.values.at("turn_m_s")),
        bore_rest_(bore_rest),
        rod_rest_(rod_rest),
        at_rest_(bore_rest - rod_rest) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    double grip = bore_ * Beyond(bore_rest_, place.at.bore_rise) +
                  rod_ * Beyond(rod_rest_, place.at.rod_rise);
    if (difference_ != 0) {
      grip += difference_ *
              (std::abs(at_rest_ + place.at.bore_rise - place.at.rod_rise) - std::abs(at_rest_));
    }
    grip *= Turned(place.speed, turn_m_s_);
    level->extra += place.sign > 0 ? grip : retraction_ratio_ * grip;
    if (!PressesCurve()) return;
    double share = bore_share_ * Beyond(bore_rest_, place.at.bore_rise) +
                   rod_share_ * Beyond(rod_rest_, place.at.rod_rise);
    if (larger_share_ != 0) {
      const double rest = std::max(bore_rest_, rod_rest_);
      const double larger =
          std::max(bore_rest_ + place.at.bore_rise, rod_rest_ + place.at.rod_rise);
      share += larger_share_ * Beyond(rest, larger - rest);
    }
    level->of_curve *= std::max(1 + (place.sign > 0 ? share : retraction_ratio_ * share), 0.0);
  }
  bool DependsOnPressure() const override {
    return bore_ != 0 || rod_ != 0 || difference_ != 0 || PressesCurve();
  }

 private:
  bool PressesCurve() const { return bore_share_ != 0 || rod_share_ != 0 || larger_share_ != 0; }
  /// What of a rise presses the seal: the part above `start_Pa`, absolute, bent by the exponent and
  /// by how flat the lip is pressed.
  double Beyond(double rest, double rise) const {
    if (start_Pa_ == 0 && exponent_ == 1 && flat_Pa_ == 0) return rise;
    return Pressed(rest + rise - start_Pa_) - Pressed(rest - start_Pa_);
  }
  double Pressed(double p) const {
    constexpr double kReference = 1e7;  // [Pa]
    if (!(p > 0)) return 0;
    if (flat_Pa_ > 0) p /= 1 + p / flat_Pa_;
    return exponent_ == 1 ? p : kReference * std::pow(p / kReference, exponent_);
  }

  double bore_, rod_, bore_share_, rod_share_, larger_share_, difference_, retraction_ratio_,
      start_Pa_, exponent_, flat_Pa_, turn_m_s_;
  double bore_rest_, rod_rest_, at_rest_;
};

Status InstallPressureFriction(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    const auto& c = extension->params().cylinders[static_cast<size_t>(i)];
    extension->AddLevel(
        i, std::make_unique<PressedSeal>(effect, StaticPressure(c.bore_line, *extension),
                                         StaticPressure(c.rod_line, *extension)));
  }
  return {};
}

}  // namespace

const EffectInfo& PressureFrictionInfo() {
  static const EffectInfo info = {
      "pressure_friction",
      "friction",
      "cylinders",
      "level (1 + a (p^n - p0^n)) + k (p^n - p0^n) of each chamber, p beyond p_s, + k_d (|p_bore - "
      "p_rod| - at rest)",
      {
          {"bore_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_bore"},
          {"rod_N_per_Pa", "N/Pa", 1e-4, -1, 1, 0, 1e-2, "k_rod"},
          {"difference_N_per_Pa", "N/Pa", 0, -1, 1, 0, 1e-2, "k_d"},
          {"bore_1_per_Pa", "1/Pa", 0, -1e-3, 1e-3, 0, 1e-6, "a_bore: of the whole curve"},
          {"rod_1_per_Pa", "1/Pa", 0, -1e-3, 1e-3, 0, 1e-6, "a_rod: of the whole curve"},
          {"larger_1_per_Pa", "1/Pa", 0, -1e-3, 1e-3, 0, 1e-6,
           "a_l: of the whole curve, over the larger of the two"},
          {"retraction_ratio", "-", 1, 0, 1e3, 0.05, 20, "of these terms, in retraction"},
          {"exponent", "-", 1, 0.1, 5, 0.3, 3, "n: k p (p/10 MPa)^(n-1), p beyond p_s"},
          {"flat_Pa", "Pa", 0, 0, 1e9, 0, 3e7,
           "p_f: p/(1 + p/p_f) presses, a lip that is soon flat; 0: p"},
          {"start_Pa", "Pa", 0, 0, 1e9, 0, 2e7, "p_s: each chamber presses beyond it; 0: always"},
          kTurn,
      },
      InstallPressureFriction,
      {
          .rig =
              {
                  {.free = {{"bore_N_per_Pa", 2e-5}}, .held = {{"rod_N_per_Pa", 0}}},
                  {.free = {{"rod_N_per_Pa", 2e-5}}, .held = {{"bore_N_per_Pa", 0}}},
                  {.free = {{"bore_N_per_Pa", 2e-5}, {"rod_N_per_Pa", 2e-5}}, .amounts = 2},
                  {.free = {{"difference_N_per_Pa", 2e-5}},
                   .held = {{"bore_N_per_Pa", 0}, {"rod_N_per_Pa", 0}}},
                  {.free = {{"rod_1_per_Pa", 1e-8}},
                   .held = {{"bore_N_per_Pa", 0}, {"rod_N_per_Pa", 0}}},
                  {.free = {{"bore_1_per_Pa", 1e-8}, {"rod_1_per_Pa", 1e-8}},
                   .held = {{"bore_N_per_Pa", 0}, {"rod_N_per_Pa", 0}},
                   .amounts = 2},
                  {.free = {{"larger_1_per_Pa", 1e-8}},
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
                  {.free = {{"start_Pa", 2e6, 8e6, 2}}},
                  {.free = {{"exponent", 0.6, 1.6, 2}}},
                  {.free = {{"flat_Pa", 5e6}}},
                  TurnOption(),
              },
          .over = {"N", "spq"},
      }};
  return info;
}

}  // namespace phs::effects
