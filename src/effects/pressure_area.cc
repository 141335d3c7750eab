#include "effects/pressure_area.h"

#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;
using hydraulics::Walk;

class PressedArea final : public hydraulics::LoadLaw {
 public:
  explicit PressedArea(double area_m2) : area_m2_(area_m2) {}
  void Add(const hydraulics::LoadMotion& motion, std::vector<double>* force) const override {
    for (size_t i = 0; i < motion.pressure.size(); ++i)
      (*force)[i] += area_m2_ * motion.pressure[i];
  }

 private:
  double area_m2_;
};

class PressedChamber final : public hydraulics::ForceLaw {
 public:
  PressedChamber(double area_m2, bool bore) : area_m2_(area_m2), bore_(bore) {}
  double Force(const hydraulics::ForcePlace& place) const noexcept override {
    return area_m2_ * (bore_ ? place.bore_rise : place.rod_rise);
  }

 private:
  double area_m2_;
  bool bore_;
};

Status InstallPressureArea(const EffectParams& effect, Extension* extension) {
  const double area = effect.values.at("area_m2");
  const auto& params = extension->params();
  if (IsBenchPart(params)) {
    extension->AddLoad(std::make_unique<PressedArea>(area));
    return {};
  }
  for (const int line : TargetLines(effect, params)) {
    const std::string& name = params.lines[static_cast<size_t>(line)].name;
    for (size_t i = 0; i < params.cylinders.size(); ++i) {
      const auto& cylinder = params.cylinders[i];
      for (const bool bore : {true, false}) {
        if ((bore ? cylinder.bore_line : cylinder.rod_line) != name) continue;
        extension->AddForce(static_cast<int>(i), std::make_unique<PressedChamber>(area, bore));
      }
    }
  }
  return {};
}

}  // namespace

const EffectInfo& PressureAreaInfo() {
  static const EffectInfo info = {"pressure_area",
                                  "element",
                                  "lines",
                                  "force A p: of a chamber's rise, on a bench of its channel",
                                  {{"area_m2", "m2", 1e-4, -10, 10, -0.1, 0.1, "A"}},
                                  InstallPressureArea,
                                  {
                                      .rig = {{.free = {{"area_m2", 0}}, .places = Places::kEach}},
                                      .bench =
                                          {
                                              {.free = {{"area_m2", 0, 0, 1, Walk::kEach, -50, 50}},
                                               .needs = {"p_Pa"},
                                               .beside = {"element.pressure_area"}},
                                          },
                                      .over = {"N", "pq"},
                                  }};
  return info;
}

}  // namespace phs::effects
