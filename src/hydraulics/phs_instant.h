// What position and state decide about a PHS: for callers who ask for forces at several speeds.
#pragma once

#include "hydraulics/extra_series.h"
#include "hydraulics/node.h"

namespace phs::hydraulics {

inline constexpr int kMaxCylinders = 16;
inline constexpr int kMaxNodes = 32;
inline constexpr int kMaxStates = 192;

/// How fast Newton's method converged in the stages before (flow_stage.h): of a change c it left
/// `contraction` c². 0: not known.
struct StageMemory {
  double contraction = 0;
};

/// Everything known at one instant.
struct Instant {
  double time = 0;               ///< [s]
  double ambient = 0;            ///< [K]
  double viscosity = 1;          ///< over that at the static temperature
  double extra[kMaxExtra];       ///< further channels, where there are some
  double piston[kMaxCylinders];  ///< y [m]
  double pushed[kMaxNodes];      ///< D [m3]
  NodeState node[kMaxNodes];
  StageMemory stages;
};

}  // namespace phs::hydraulics
