// What stands in the way between a chamber and its line: a pipe or a plate in the chamber's port.
//   p_chamber - p_line = R q (|q|/q0)^(1/n - 1) + K q|q| + P q/sqrt(q² + q0²),   q0 = 1e-5 m3/s
// n = 1: a pipe (hydraulics/pipe.h). A plate or a reed that the flow lifts opens the more the
// harder it is pressed, so that its flow rises faster than the drop, q ~ dp^n with n > 1, as
// through a gap that the pressure widens (GapFlow): R is then the resistance at q0. Its flow is as
// 1/mu. A valve that a spring holds shut takes the pressure P (PoppetFlow).
#pragma once

#include <memory>

#include "hydraulics/phs_params.h"
#include "hydraulics/pipe.h"

namespace phs::effects {

constexpr double kRestrictionFlow = 1e-5;  ///< q0 [m3/s]: 2 cm/s of a piston of 5 cm²

/// One way through it.
struct RestrictionWay {
  double laminar = 0;      ///< R > 0 at 20 °C [Pa s/m3]
  double turbulent = 0;    ///< K >= 0 [Pa s2/m6]
  double cracking_Pa = 0;  ///< P >= 0
};

/// Law out of the chamber and into it, n >= 1, at the model's static temperature.
std::unique_ptr<hydraulics::FlowLaw> MakeRestriction(const RestrictionWay& out,
                                                     const RestrictionWay& in, double exponent,
                                                     const hydraulics::PhsParams& params);

}  // namespace phs::effects
