// A throttle between each chamber of a cylinder and its line, with a relief valve beside it: the
// hydraulic damper of a steering.
//
//             +----- R q_t + K q_t|q_t| -----+
//   chamber --+                              +-- line        q = q_t + q_v
//             +----- relief valve (q_v) -----+
//
//   dp = p_chamber - p_line = R q_t + K q_t|q_t|
//   q_v = 0                              |dp| <= p_r
//   q_v = sign(dp) (|dp| - p_r)/R_v      beyond: the spring of the valve gives way with the flow
//
// R [Pa s/m3]: laminar part (a thin bore, 128 mu l/(pi d⁴); stated at 20 °C, follows the viscosity
// of the oil as warm as it is). K [Pa s2/m6]: turbulent part, a sharp edge: rho/(2 (C_d A)²),
// C_d 0.6 … 0.65 (ISO 5167-2 for orifices; Idelchik 1986); it knows no viscosity. p_r [Pa]: both
// directions. R_v [Pa s/m3]: slope of the open valve, <= R by intent. The chamber keeps `oil_share` of
// the line's oil on its side. Opposite yaw of two axles drives oil from chamber to chamber of a
// line and none into a reservoir (physics of the network's null space): so it is at the chambers,
// not at the reservoirs, that a throttle damps steering. Lost power dp q >= 0. State: volume that
// has passed [m3]. Force of one chamber at a slow piston speed v: A dp(A v).
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

/// All at the temperature of the oil.
struct ThrottleParams {
  double laminar = 0;    ///< R > 0 [Pa s/m3]
  double turbulent = 0;  ///< K >= 0 [Pa s2/m6]
  double relief = 0;     ///< p_r > 0 [Pa]
  double valve = 0;      ///< R_v > 0 [Pa s/m3]
};

class ThrottleFlow final : public hydraulics::FlowLaw {
 public:
  explicit ThrottleFlow(const ThrottleParams& params) : p_(params) {}
  double Flow(const hydraulics::FlowPlace& at, double dp, double* slope) const noexcept override;
  double Drop(const hydraulics::FlowPlace& at, double flow, double* slope) const noexcept override;
  bool SolvedByDrop() const noexcept override { return true; }

 private:
  ThrottleParams p_;
};

const hydraulics::EffectInfo& ThrottleInfo();

}  // namespace phs::effects
