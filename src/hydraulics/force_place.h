// Where and how a cylinder (or a part on a bench) stands: what forces and readings depend on.
#pragma once

namespace phs::hydraulics {

/// What a further force of a cylinder (or of a part on a bench) may depend on.
struct ForcePlace {
  double time = 0;                ///< [s]
  double piston = 0;              ///< y [m]
  double speed = 0;               ///< [m/s]
  double direction = 0;           ///< friction's own, -1 … 1: turns over its presliding or ramp
  double bore_rise = 0;           ///< p_bore above static [Pa]; element bench: the pressure itself
  double rod_rise = 0;            ///< p_rod above static [Pa]
  double temperature = 0;         ///< above the model's [K]
  double force = 0;               ///< of readings: what the load cell carries, tension > 0 [N]
  const double* state = nullptr;  ///< states of the law itself; null: all 0
  const double* extra = nullptr;  ///< further measured channels, in their order; null: all 0
};

}  // namespace phs::hydraulics
