#include "effects/backlash.h"

#include <memory>

#include "effects/hardening.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Places;
using hydraulics::Walk;

class Backlash final : public hydraulics::MountLaw {
 public:
  explicit Backlash(const EffectParams& effect)
      : gap_m_(effect.values.at("gap_m")),
        tension_share_(effect.values.at("tension_share")),
        contact_(effect.values.at("contact_N_per_m")),
        hardening_(effect.values.at("hardening_1_per_m2")) {}
  hydraulics::Play FreePlay() const override { return {gap_m_, tension_share_ * gap_m_}; }
  double Stiffness() const override { return contact_; }
  hydraulics::Stiffening Stiffen(double e) const noexcept override { return Harden(hardening_, e); }

 private:
  double gap_m_, tension_share_, contact_, hardening_;
};

Status InstallBacklash(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddMount(i, std::make_unique<Backlash>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& BacklashInfo() {
  static const EffectInfo info = {
      "backlash",
      "mounting",
      "cylinders",
      "free play g, then a stiff contact",
      {
          {"gap_m", "m", 1e-4, 0, 0.05, 1e-6, 2e-3, "total free play"},
          {"contact_N_per_m", "N/m", 1e9, 1e5, 1e12, 2e8, 1e11, "contact stiffness"},
          {"tension_share", "-", 0.5, 0, 1, 0.01, 0.99, "of the play, crossed before tension"},
          {"hardening_1_per_m2", "1/m2", 0, 0, 1e15, 0, 1e13, "b: contact k e (1 + b e²)"},
      },
      InstallBacklash,
      {
          .rig =
              {
                  {.free = {{"gap_m", 4e-6, 4e-4, 4}, {"contact_N_per_m", 5e8, 1.5e10, 2}},
                   .places = Places::kEach},
                  // A pin that rests at one end of its play.
                  {.free = {{"gap_m", 4e-6, 4e-4, 4}, {"contact_N_per_m", 3e9}},
                   .held = {{"tension_share", 0}}},
                  {.free = {{"gap_m", 4e-6, 4e-4, 4}, {"contact_N_per_m", 3e9}},
                   .held = {{"tension_share", 1}}},
              },
          .bench =
              {
                  {.free = {{"gap_m", 1e-3, 0.02, 2, Walk::kEach, 1e-4, 1}},
                   .held = {{"contact_N_per_m", 1e5}}},
              },
          .bogie =
              {
                  {.free = {{"gap_m", 1e-4, 5e-4, 2}}},
              },
          .options =
              {
                  {.free = {{"tension_share", 0.3, 0.7, 2}}},
                  {.free = {{"hardening_1_per_m2", 1e8, 1e10, 2}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
