#include "effects/pressure_area.h"

#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
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

Status Install(const EffectParams& effect, Extension* extension) {
  if (!IsBenchPart(extension->params())) return NotABenchPart(effect.name);
  extension->AddLoad(std::make_unique<PressedArea>(effect.values.at("area_m2")));
  return {};
}

}  // namespace

const EffectInfo& PressureAreaInfo() {
  static const EffectInfo info = {"pressure_area",
                                  "element",
                                  "",
                                  "force A p of the pressure channel",
                                  {{"area_m2", "m2", 1e-4, -10, 10, -0.1, 0.1, "A"}},
                                  Install,
                                  {
                                      .bench =
                                          {
                                              {.free = {{"area_m2", 0, 0, 1, Walk::kEach, -50, 50}},
                                               .needs = {"p_Pa"},
                                               .beside = {"element.pressure_area"}},
                                          },
                                  }};
  return info;
}

}  // namespace phs::effects
