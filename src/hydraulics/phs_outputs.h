// What an evaluation of a PHS yields and how its cylinders move over a step.
#pragma once

namespace phs::hydraulics {

/// What one evaluation yields; arrays belong to the caller and are sized by PhsSystem. A null
/// pointer means: not wanted.
struct PhsOutputs {
  // per cylinder
  double* force = nullptr;  ///< tension force on the mountings [N] (> 0 pulls them together)
  double* pressure_force = nullptr;  ///< p_rod A_rod - p_bore A_bore [N]
  double* friction_force = nullptr;  ///< seal friction, sign as it adds to `force` [N]
  double* piston = nullptr;          ///< piston displacement from static [m]
  double* p_bore = nullptr;          ///< chamber pressures, absolute [Pa]
  double* p_rod = nullptr;
  double* damping = nullptr;  ///< how `force` rises with the speed of the mountings [N s/m], >= 0
  // per line
  double* pressure = nullptr;  ///< line pressure, absolute [Pa]
  // whole system
  double stored_energy = 0;  ///< above the static state [J]
  double lost_power = 0;     ///< [W], >= 0 for a passive system
  bool energy = true;        ///< in: false skips the two above (faster)
  bool stored = true;        ///< in: false skips the stored energy alone, which takes logarithms
};

/// How cylinders move over a step: speeds are linear in time, `mean` over it, `end` at its end
/// [m/s].
struct StepSpeeds {
  const double* mean;
  const double* end;
};

}  // namespace phs::hydraulics
