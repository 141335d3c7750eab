#include "effects/pressure_area.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;
using hydraulics::Walk;

/// A g(p - z p0), g(p) = p (|p| / 10 MPa)^(n - 1), of the rise of p above `p0`.
class Thrust {
 public:
  Thrust(const EffectParams& effect, double p0)
      : area_m2_(effect.values.at("area_m2")),
        exponent_(effect.values.at("exponent")),
        above_(p0 * (1 - effect.values.at("zeroed_over_static"))) {}
  double At(double rise) const {
    constexpr double kReference = 1e7;  // [Pa]
    const double pressure = rise + above_;
    if (exponent_ == 1) return area_m2_ * pressure;
    return area_m2_ *
           std::copysign(kReference * std::pow(std::abs(pressure) / kReference, exponent_),
                         pressure);
  }

 private:
  double area_m2_, exponent_;
  double above_;  ///< of the static pressure over that of no thrust [Pa]
};

/// T dp'/dt = p - p' over h at a constant p.
void Follow(double h, double p, double late_s, double* behind) {
  *behind -= std::expm1(-h / late_s) * (p - *behind);
}

class PressedArea final : public hydraulics::LoadLaw {
 public:
  PressedArea(const Thrust& thrust, double late_s) : thrust_(thrust), late_s_(late_s) {}
  void Add(const hydraulics::LoadMotion& motion, std::vector<double>* force) const override {
    const std::vector<double>& p = motion.pressure;
    double behind = p.empty() ? 0 : p.front();
    for (size_t i = 0; i < p.size(); ++i) {
      if (late_s_ > 0 && i > 0) Follow(motion.step_s, 0.5 * (p[i - 1] + p[i]), late_s_, &behind);
      (*force)[i] += thrust_.At(late_s_ > 0 ? behind : p[i]);
    }
  }

 private:
  Thrust thrust_;
  double late_s_;
};

class PressedChamber final : public hydraulics::ForceLaw {
 public:
  PressedChamber(const Thrust& thrust, bool bore, double late_s)
      : thrust_(thrust), bore_(bore), late_s_(late_s) {}
  double Force(const hydraulics::ForcePlace& place) const noexcept override {
    if (late_s_ == 0) return thrust_.At(Rise(place));
    return thrust_.At(place.state != nullptr ? *place.state : 0);
  }
  std::vector<std::string> StateNames() const override {
    if (late_s_ == 0) return {};
    return {bore_ ? "pressed_by_bore_Pa" : "pressed_by_rod_Pa"};
  }
  void CalcRates(const hydraulics::ForcePlace& place, double* rate) const noexcept override {
    *rate = (Rise(place) - *place.state) / late_s_;
  }
  void Advance(double h, const hydraulics::ForcePlace& place,
               double* state) const noexcept override {
    Follow(h, Rise(place), late_s_, state);
  }

 private:
  double Rise(const hydraulics::ForcePlace& place) const {
    return bore_ ? place.bore_rise : place.rod_rise;
  }
  Thrust thrust_;
  bool bore_;
  double late_s_;
};

Status InstallPressureArea(const EffectParams& effect, Extension* extension) {
  const double late_s = effect.values.at("late_s");
  const auto& params = extension->params();
  if (IsBenchPart(params)) {
    extension->AddLoad(std::make_unique<PressedArea>(Thrust(effect, 0), late_s));
    return {};
  }
  for (const int line : TargetLines(effect, params)) {
    const hydraulics::LineParams& l = params.lines[static_cast<size_t>(line)];
    const Thrust thrust(effect, l.static_pressure_Pa);
    for (size_t i = 0; i < params.cylinders.size(); ++i) {
      const auto& cylinder = params.cylinders[i];
      for (const bool bore : {true, false}) {
        if ((bore ? cylinder.bore_line : cylinder.rod_line) != l.name) continue;
        extension->AddForce(static_cast<int>(i),
                            std::make_unique<PressedChamber>(thrust, bore, late_s));
      }
    }
  }
  return {};
}

}  // namespace

const EffectInfo& PressureAreaInfo() {
  static const EffectInfo info = {
      "pressure_area",
      "element",
      "lines",
      "force A p (|p|/10 MPa)^(n-1): of a chamber's rise, on a bench of its channel",
      {{"area_m2", "m2", 1e-4, -10, 10, -0.1, 0.1, "A"},
       {"exponent", "-", 1, 0.1, 5, 0.4, 2.5, "n"},
       {"late_s", "s", 0, 0, 1e6, 0, 10, "of p behind a narrow gap; 0: at once"},
       {"zeroed_over_static", "-", 1, -10, 10, -1, 3,
        "pressure at which it shows no thrust, over the static one; not on a bench"}},
      InstallPressureArea,
      {
          .rig = {{.free = {{"area_m2", 0}}, .places = Places::kEach}},
          .bench =
              {
                  {.free = {{"area_m2", 0, 0, 1, Walk::kEach, -50, 50}},
                   .needs = {"p_Pa"},
                   .beside = {"element.pressure_area"}},
              },
          .options = {{.free = {{"exponent", 0.7, 1.5, 2}}},
                      {.free = {{"late_s", 0.03, 0.3, 2}}},
                      {.free = {{"zeroed_over_static", 0}}}},
          .over = {"N", "pq"},
      }};
  return info;
}

}  // namespace phs::effects
