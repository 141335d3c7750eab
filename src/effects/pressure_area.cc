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

/// A p (|p| / 10 MPa)^(n - 1).
class Thrust {
 public:
  explicit Thrust(const EffectParams& effect)
      : area_m2_(effect.values.at("area_m2")), exponent_(effect.values.at("exponent")) {}
  double At(double pressure) const {
    constexpr double kReference = 1e7;  // [Pa]
    if (exponent_ == 1) return area_m2_ * pressure;
    return area_m2_ *
           std::copysign(kReference * std::pow(std::abs(pressure) / kReference, exponent_),
                         pressure);
  }

 private:
  double area_m2_, exponent_;
};

class PressedArea final : public hydraulics::LoadLaw {
 public:
  explicit PressedArea(const Thrust& thrust) : thrust_(thrust) {}
  void Add(const hydraulics::LoadMotion& motion, std::vector<double>* force) const override {
    for (size_t i = 0; i < motion.pressure.size(); ++i)
      (*force)[i] += thrust_.At(motion.pressure[i]);
  }

 private:
  Thrust thrust_;
};

class PressedChamber final : public hydraulics::ForceLaw {
 public:
  PressedChamber(const Thrust& thrust, bool bore) : thrust_(thrust), bore_(bore) {}
  double Force(const hydraulics::ForcePlace& place) const noexcept override {
    return thrust_.At(bore_ ? place.bore_rise : place.rod_rise);
  }

 private:
  Thrust thrust_;
  bool bore_;
};

Status InstallPressureArea(const EffectParams& effect, Extension* extension) {
  const Thrust thrust(effect);
  const auto& params = extension->params();
  if (IsBenchPart(params)) {
    extension->AddLoad(std::make_unique<PressedArea>(thrust));
    return {};
  }
  for (const int line : TargetLines(effect, params)) {
    const std::string& name = params.lines[static_cast<size_t>(line)].name;
    for (size_t i = 0; i < params.cylinders.size(); ++i) {
      const auto& cylinder = params.cylinders[i];
      for (const bool bore : {true, false}) {
        if ((bore ? cylinder.bore_line : cylinder.rod_line) != name) continue;
        extension->AddForce(static_cast<int>(i), std::make_unique<PressedChamber>(thrust, bore));
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
       {"exponent", "-", 1, 0.1, 5, 0.4, 2.5, "n"}},
      InstallPressureArea,
      {
          .rig = {{.free = {{"area_m2", 0}}, .places = Places::kEach}},
          .bench =
              {
                  {.free = {{"area_m2", 0, 0, 1, Walk::kEach, -50, 50}},
                   .needs = {"p_Pa"},
                   .beside = {"element.pressure_area"}},
              },
          .options = {{.free = {{"exponent", 0.7, 1.5, 2}}}},
          .over = {"N", "pq"},
      }};
  return info;
}

}  // namespace phs::effects
