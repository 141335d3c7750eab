#include "effects/moving_mass.h"

#include <memory>

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Walk;

class MovingMass final : public hydraulics::LoadLaw {
 public:
  explicit MovingMass(double mass_kg) : mass_kg_(mass_kg) {}
  void Add(const hydraulics::LoadMotion& motion, std::vector<double>* force) const override {
    for (size_t i = 0; i < force->size(); ++i) (*force)[i] += mass_kg_ * motion.acceleration[i];
  }

 private:
  double mass_kg_;
};

Status InstallMovingMass(const EffectParams& effect, Extension* extension) {
  if (extension->params().cylinders.size() != 1) {
    return Error{"effects." + effect.name, "acts on one part or one cylinder on a rig only",
                 "a model of one cylinder (rig: element, cylinder or quarter)",
                 "give the bodies of a bogie their mass in its own file"};
  }
  extension->AddLoad(std::make_unique<MovingMass>(effect.values.at("mass_kg")));
  return {};
}

}  // namespace

const EffectInfo& MovingMassInfo() {
  static const EffectInfo info = {
      "moving_mass",
      "element",
      "",
      "force m a beyond the declared mass, at the load cell",
      {{"mass_kg", "kg", 1, 0, 1e6, 0, 1e4,
        "m; a wheelset with its motor on the table weighs some 5 t"}},
      InstallMovingMass,
      {
          .rig =
              {
                  {.free = {{"mass_kg", 30, 300, 2}}},
              },
          .bench =
              {
                  {.free = {{"mass_kg", 0.05, 0, 1, Walk::kEach, 0, 20}},
                   .beside = {"element.mass"}},
              },
      }};
  return info;
}

}  // namespace phs::effects
