#include "effects/mount_compliance.h"

#include <memory>

#include "effects/hardening.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Walk;

class Spring final : public hydraulics::MountLaw {
 public:
  explicit Spring(const EffectParams& effect)
      : stiffness_(effect.values.at("stiffness_N_per_m")),
        hardening_(effect.values.at("hardening_1_per_m2")),
        tension_ratio_(effect.values.at("tension_ratio")),
        opens_m_(effect.values.at("opens_N") / stiffness_) {}
  double Stiffness() const override { return stiffness_; }
  hydraulics::Stiffening Stiffen(double e) const noexcept override {
    hydraulics::Stiffening out = Harden(hardening_, e);
    if (e <= opens_m_) return out;
    if (opens_m_ == 0) {
      out.side = tension_ratio_;
      return out;
    }
    const double closed = opens_m_ / e * Harden(hardening_, opens_m_).factor;
    return {.factor = closed + tension_ratio_ * (out.factor - closed),
            .slope = tension_ratio_ * out.slope};
  }

 private:
  double stiffness_, hardening_, tension_ratio_, opens_m_;
};

Status InstallMountCompliance(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddMount(i, std::make_unique<Spring>(effect));
  }
  return {};
}

}  // namespace

const EffectInfo& MountComplianceInfo() {
  static const EffectInfo info = {
      "mount_compliance",
      "mounting",
      "cylinders",
      "F = k u (1 + b u^2), beyond F_o its slope times r, u = actuator - piston",
      {
          {"stiffness_N_per_m", "N/m", 4.1e7, 1e3, 1e13, 4e6, 5e10, "k"},
          {"hardening_1_per_m2", "1/m2", 0, 0, 1e14, 0, 1e12, "b"},
          {"tension_ratio", "-", 1, 1e-2, 1e2, 0.1, 3, "r"},
          {"opens_N", "N", 0, 0, 1e9, 0, 1e5, "F_o: tension beyond which r counts"},
      },
      InstallMountCompliance,
      {
          .rig =
              {
                  {.free = {{"stiffness_N_per_m", 2e7, 5e9, 5}}},
              },
          .bench =
              {
                  {.free = {{"stiffness_N_per_m", 20, 500, 2, Walk::kEach, 2, 1e5}}},
              },
          .bogie =
              {
                  {.free = {{"stiffness_N_per_m", 3e7, 2e8, 2}}},
              },
          .options =
              {
                  {.free = {{"hardening_1_per_m2", 1e5, 3e9, 4}}},
                  {.free = {{"tension_ratio", 1}}},
                  {.free = {{"tension_ratio", 0.4}, {"opens_N", 3e3, 2e4, 3}}},
              },
      }};
  return info;
}

}  // namespace phs::effects
