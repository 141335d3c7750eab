// Stiffness and damping of the four axle modes of a bogie, measured on its multibody model.
//
// The frame is held; both axles are moved as a sine of given amplitude and frequency in a pattern,
// and the generalised force that resists is read. Patterns, each axle by the same amplitude u:
//   bending    lead yaw +u, trail yaw -u     (radial steering)      [rad]
//   shear      lead yaw +u, trail yaw +u     (parallelogram)        [rad]
//   traction   both axles forward by u                              [m]
//   antiphase  lead forward, trail backward by u (axles spread)     [m]
// Force Q = sum over the pattern of sign * generalised force; Q/u = K cos-part, damping from the
// part in quadrature: Q = -(K u + C du/dt) in the sense of the first harmonic. Friction makes both
// depend on amplitude, so small and large amplitudes are reported. K here is the total over both
// axles; on the relative yaw psi1 - psi2 of the linear curving formula the bending stiffness is
// K/4.
//
// Closed form for the Bo-Bo PHS alone (cylinders at +-b, line compliance C = V_oil/beta + V_g/p):
//   bending 0, shear 8 b^2 A_bore^2 / C_diagonal, traction 8 A_rod^2 / C_cross,
//   antiphase 8 (A_rod^2 / C_cross + A_bore^2 / C_diagonal).
#pragma once

#include <string>
#include <vector>

#include "analysis/mode_closed_form.h"
#include "base/result.h"
#include "vehicle/simulation.h"

namespace phs::analysis {

struct AxleMode {
  std::string name;            ///< bending | shear | traction | antiphase
  bool rotation = false;       ///< true: rad and N m; false: m and N
  double amplitude = 0;        ///< per axle [rad or m]
  double stiffness = 0;        ///< [N m/rad or N/m]
  double damping = 0;          ///< [N m s/rad or N s/m]
  double loss_per_cycle = 0;   ///< [J]
  ModeClosedForm closed_form;  ///< of small motion at the same frequency
  /// The last cycle: displacement of the pattern [rad or m] and force that resists it [N m or N].
  std::vector<double> loop_displacement = {};
  std::vector<double> loop_force = {};
  /// At the greatest displacement, first PHS of the bogie; empty without one.
  std::vector<double> cylinder_stroke_m = {};  ///< extension > 0
  std::vector<double> cylinder_force_N = {};   ///< tension > 0
  std::vector<double> line_pressure_Pa = {};
};

/// Where axles and cylinders are in plan at rest; x along the bogie, y to the left [m].
struct BogiePlan {
  struct Axle {
    std::string name;
    double x = 0;
  };
  struct Cylinder {
    std::string name;
    double from[2] = {0, 0};  ///< on the frame
    double to[2] = {0, 0};    ///< on the axle box
  };
  std::vector<Axle> axles;
  std::vector<Cylinder> cylinders;
  std::vector<std::string> lines;
};

struct AxleModeOptions {
  double frequency_Hz = 0.5;
  double small_displacement_m = 2e-5;  ///< at the cylinders; yaw = displacement / BoxLever
  double large_displacement_m = 2e-3;
};

struct AxleModes {
  std::vector<AxleMode> small;  ///< in the order of the names above
  std::vector<AxleMode> large;
  BogiePlan plan;
  double lever_m = 0;  ///< BoxLever
};

/// Measures on the first bogie (lead and trail) of a simulation, lifted off its rails.
/// Joints needed: "lead_x", "lead_yaw", "trail_x", "trail_yaw" (with the bogie's prefix).
Result<AxleModes> MeasureAxleModes(const vehicle::Simulation& simulation,
                                   const AxleModeOptions& options = {},
                                   const vehicle::Progress& progress = {});

}  // namespace phs::analysis
