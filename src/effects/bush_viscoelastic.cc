#include "effects/bush_viscoelastic.h"

#include <memory>

#include "effects/hardening.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Walk;

class Bush final : public hydraulics::MountLaw {
 public:
  explicit Bush(const EffectParams& effect)
      : stiffness_(effect.values.at("stiffness_N_per_m")),
        hardening_(effect.values.at("hardening_1_per_m2")) {
    const auto add = [&](const char* name, double stiffness, double relaxation_s) {
      if (stiffness > 0) branches_.push_back({name, stiffness, stiffness * relaxation_s});
    };
    add("bush", effect.values.at("relaxing_N_per_m"), effect.values.at("relaxation_s"));
    add("bush2", effect.values.at("second_N_per_m"), effect.values.at("second_relaxation_s"));
  }
  double Stiffness() const override { return stiffness_; }
  hydraulics::Stiffening Stiffen(double e) const noexcept override { return Harden(hardening_, e); }
  std::vector<hydraulics::MaxwellBranch> Branches() const override { return branches_; }

 private:
  double stiffness_, hardening_;
  std::vector<hydraulics::MaxwellBranch> branches_;
};

Status InstallBushViscoelastic(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddMount(i, std::make_unique<Bush>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& BushViscoelasticInfo() {
  static const EffectInfo info = {
      "bush_viscoelastic",
      "mounting",
      "cylinders",
      "spring and one or two Maxwell elements between actuator and piston",
      {
          {"stiffness_N_per_m", "N/m", 4e7, 1e3, 1e13, 4e6, 5e10, "k"},
          {"relaxing_N_per_m", "N/m", 2e7, 1, 1e13, 1e6, 5e10, "k2"},
          {"relaxation_s", "s", 0.3, 1e-5, 1e6, 1e-2, 30, "tau"},
          {"second_N_per_m", "N/m", 0, 0, 1e13, 0, 5e10, "k3"},
          {"second_relaxation_s", "s", 3, 1e-5, 1e6, 1e-2, 60, "tau3"},
          {"hardening_1_per_m2", "1/m2", 0, 0, 1e14, 0, 1e12, "b"},
      },
      InstallBushViscoelastic,
      {
          .rig =
              {
                  {.free = {{"stiffness_N_per_m", 3e7, 8e9, 4},
                            {"relaxing_N_per_m", 2e7, 8e9, 4, Walk::kInStep},
                            {"relaxation_s", 0.1, 1, 2}}},
              },
          .options =
              {
                  {.free = {{"second_N_per_m", 3e7, 1e9, 2}, {"second_relaxation_s", 0.03, 5, 2}}},
                  {.free = {{"hardening_1_per_m2", 1e5, 1e8, 3}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
