#include "effects/seal_swelling.h"

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

class Swelling final : public hydraulics::LevelLaw {
 public:
  explicit Swelling(const EffectParams& effect)
      : growth_(effect.values.at("growth")), time_s_(effect.values.at("time_s")) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->of_all *= 1 - growth_ * std::expm1(-std::max(place.at.time, 0.0) / time_s_);
  }

 private:
  double growth_, time_s_;
};

Status Install(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddLevel(i, std::make_unique<Swelling>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& SealSwellingInfo() {
  static const EffectInfo info = {"seal_swelling",
                                  "friction",
                                  "cylinders",
                                  "level (1 + growth (1 - exp(-t/T)))",
                                  {
                                      {"growth", "-", 0.2, 0, 10, 0, 1, "in the end"},
                                      {"time_s", "s", 100, 1e-3, 1e9, 1, 1e6, "T"},
                                  },
                                  Install};
  return info;
}

}  // namespace phs::effects
