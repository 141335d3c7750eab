// The steady state in a curve found directly, without running through time.
//
// In a circular arc of constant cant a vehicle that has settled turns with its track as one rigid
// body: every coordinate of the suspension stands still, wheelsets spin steadily. So the unknowns
// are positions (not the spin angles, not the place along the track), spin speeds and the forward
// speed that the drives hold; the equations, qacc = that of a point fixed to the track frame
// (root), 0 (everything else). An axle without a drive settles at the spin that leaves it no
// moment; a vehicle without any drive coasts: its speed is given and its deceleration is the
// unknown. Newton with a finite-difference Jacobian, step halving, Broyden's updates between.
//
// Sliding seals and other hydraulic states remember the way into the curve. So the solution is
// followed along the track: at each of a few places the quasi-static state is solved with the
// states advanced by the motion since the place before at its running time (the plugin's own exact
// rates over a long step). Track frames differ along a transition by more than this rigid turning
// (twist between the axles is kept, the rate of twist is not), which matters for the memory only:
// the last place lies in the arc.
//
// Left out: inertia of motion relative to the track frame, damper forces of the slow motion.
#pragma once

#include "base/result.h"
#include "vehicle/run_summary.h"

namespace phs::analysis {

struct SteadyCurveOptions {
  double place_in_arc = 5.0 / 6;  ///< of the arc's length: middle of the summary's window, (0, 1)
  int transition_places = 10;     ///< places solved along each transition on the way, 1 … 1000
  int arc_places = 3;             ///< along each arc on the way, 1 … 1000
  double tolerance = 1e-4;        ///< of the accelerations left [m/s^2, rad/s^2]
};

struct SteadyCurve {
  vehicle::SteadyMeans steady;
  double residual = 0;  ///< largest acceleration left [m/s^2, rad/s^2]
  double speed_m_s = 0;
  double coasting_m_s2 = 0;  ///< of a vehicle without drives, < 0: it slows down
  int places = 0;
  long evaluations = 0;    ///< of mj_forward
  double processor_s = 0;  ///< of one core
};

/// In the first arc of the simulation's track. Errors: not one free root; no speed; no arc; no
/// steady state found (with the acceleration left).
Result<SteadyCurve> SolveSteadyCurve(vehicle::Simulation* simulation,
                                     const SteadyCurveOptions& options = {});

/// Over all wheels of a steady curve: sum of T-gamma, largest magnitudes of Y and Y/Q.
struct CurveTotals {
  double T_gamma_N = 0;
  double largest_Y_N = 0;
  double largest_Y_over_Q = 0;
};
CurveTotals CalcCurveTotals(const vehicle::SteadyMeans& steady);

}  // namespace phs::analysis
