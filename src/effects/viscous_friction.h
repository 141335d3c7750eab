// Force proportional to speed, c v, with a coefficient per direction [N s/m], 0 … 1e5. Dissipative.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

/// c v (|v|/1 cm/s)^(n - 1), c by direction.
class ViscousForce final : public hydraulics::ForceLaw {
 public:
  ViscousForce(double extension_Ns_per_m, double retraction_Ns_per_m, double exponent)
      : extension_(extension_Ns_per_m), retraction_(retraction_Ns_per_m), exponent_(exponent) {}
  double Force(const hydraulics::ForcePlace& place) const noexcept override;
  bool OfSpeedAlone() const override { return true; }
  double Damping(int sign) const override { return sign > 0 ? extension_ : retraction_; }

 private:
  double extension_, retraction_, exponent_;
};

const hydraulics::EffectInfo& ViscousFrictionInfo();

}  // namespace phs::effects
