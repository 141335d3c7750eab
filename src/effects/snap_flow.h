// What stands where a pressure difference d pushes it, and takes or carries oil on its way: a
// seal's ring in its groove, held by its friction, or a wall that snaps over.
//   W_0(d) = V/2 tanh((d - d_c + P_s u)/P),  u = 2W/V      where it would go, as volume
//   dW/dt = (W_0(d -+ P_h) - W)/tau                        once d is P_h beyond; else it stays
// V [m3] between its ends, P [Pa] half the difference over which it crosses, d_c [Pa] where it
// stands in the middle, P_h [Pa] friction over area, tau [s]. P_s [Pa]: it helps itself over, so
// that for P_s > P it has two shapes and snaps at d_c ± (P_s u - P artanh u), u² = 1 - P/P_s; near
// d_c ± P_s for P << P_s. In balance d = d_c + P artanh u - P_s u: it stores
//   d_c W + P V/2 (u artanh u + ln(1 - u²)/2) - P_s V u²/4.
#pragma once

#include "hydraulics/oil_laws.h"

namespace phs::effects {

struct SnapParams {
  double volume_m3 = 0;    ///< V > 0
  double width_Pa = 1;     ///< P > 0
  double centre_Pa = 0;    ///< d_c
  double friction_Pa = 0;  ///< P_h >= 0
  double snap_Pa = 0;      ///< P_s >= 0
  double time_s = 1;       ///< tau > 0
  /// d in the static state, where it stands without friction; of two shapes it has that to whose
  /// side of the middle d lies.
  double rest_Pa = 0;
};

class SnapFlow final : public hydraulics::FlowLaw {
 public:
  explicit SnapFlow(const SnapParams& params);

  double Flow(const hydraulics::FlowPlace& at, double dp, double* slope) const noexcept override;
  double Return(const hydraulics::FlowPlace& at, double dp) const noexcept override;
  double Stored(double passed) const noexcept override;
  double Held(double passed) const noexcept override;

 private:
  /// How far it would go from where it stands [m3].
  double Pushed(double stands, double dp) const;
  double Share(double stands) const;  ///< u
  double Energy(double stands) const;

  SnapParams p_;
  double half_, rest_;
};

}  // namespace phs::effects
