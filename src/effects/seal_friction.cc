#include "effects/seal_friction.h"

#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::LevelParts;
using hydraulics::LevelPlace;
using hydraulics::Places;

class Factor final : public hydraulics::LevelLaw {
 public:
  explicit Factor(double factor) : factor_(factor) {}
  void Add(const LevelPlace& /*place*/, LevelParts* level) const noexcept override {
    level->of_all *= factor_;
  }

 private:
  double factor_;
};

Status InstallSealFriction(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddLevel(i, std::make_unique<Factor>(effect.values.at("factor")));
  }
  return {};
}

/// A model without friction has no seal that could hold otherwise.
double SealAsTheOthers(const hydraulics::PhsParams& params) {
  return params.friction.model == hydraulics::FrictionModel::kNone ? 0 : 1;
}

}  // namespace

const EffectInfo& SealFrictionInfo() {
  static const EffectInfo info = {
      "seal_friction",
      "friction",
      "cylinders",
      "level * f: seals of these cylinders hold otherwise than the rest",
      {{"factor", "-", 2, 0, 100, 0.2, 8, "f", true}},
      InstallSealFriction,
      {
          // From none as well: a step from far off says little of a beam that sticks and slides. On a
          // bogie, which trembles, the slope at none drowns.
          .rig = {{.free = {{"factor", 0.6, 1.6, 3}}, .places = Places::kAlone}},
          .bogie = {{.free = {{"factor", 0.6, 1.6, 2}}, .places = Places::kAlone}},
          .declared = SealAsTheOthers,
      }};
  return info;
}

}  // namespace phs::effects
