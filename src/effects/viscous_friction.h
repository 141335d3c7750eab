// Force proportional to speed, c v, with a coefficient per direction [N s/m], 0 … 1e5.
// A bush that floods only at speed drags beyond a speed v_f alone (from_m_s). Dissipative.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

/// c v (|v|/1 cm/s)^(n - 1), c by direction, of |v| what is beyond v_f.
class ViscousForce final : public hydraulics::ForceLaw {
 public:
  ViscousForce(double extension_Ns_per_m, double retraction_Ns_per_m, double exponent,
               double from_m_s = 0)
      : extension_(extension_Ns_per_m),
        retraction_(retraction_Ns_per_m),
        exponent_(exponent),
        from_(from_m_s) {}
  double Force(const hydraulics::ForcePlace& place) const noexcept override;
  bool OfSpeedAlone() const override { return true; }
  double Damping(int sign) const override {
    return from_ > 0 ? 0 : (sign > 0 ? extension_ : retraction_);
  }

 private:
  double extension_, retraction_, exponent_, from_;
};

const hydraulics::EffectInfo& ViscousFrictionInfo();

}  // namespace phs::effects
