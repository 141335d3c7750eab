// The longitudinal loads that a locomotive's axle boxes must carry (thesis, Table 4-2), laid
// quietly on a bogie: how far the axles move, what pressures and cylinder forces arise, which part
// gives first.
//
// The frame is held, every dof but x and yaw of the two steered axles stays at rest. Per box a
// force P acts along the track on the axle in a pattern; x and yaw follow from equilibrium with
// guidance springs, linkages and the PHS (seal friction and oil flow left out: it has had time to
// settle, and friction could hang on to either side). Lines that were filled out of balance with
// their pistons held (bo_bo_measured) first move the axles to where they balance. Sign: extension and tension > 0, pressures
// absolute.
//
//   traction   both axles pull the frame forward: +P on all four boxes
//   braking    both axles hold the frame back: -P
//   shear      same-sense yaw: -P on left boxes, +P on right boxes of both axles
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "vehicle/simulation.h"

namespace phs::analysis {

/// One row of the thesis's table: a pattern and the load per box at its upper end.
struct LoadCase {
  std::string name;
  std::string pattern;  ///< traction | braking | shear
  double load_N = 0;    ///< per box
  std::string source;
};
/// Steering 30 kN, traction and electric braking 52 kN, braking 82 kN, unusual (5 g) 175 kN.
std::vector<LoadCase> StandardLoadCases();

struct PartLimits {
  double cylinder_N = 60e3;          ///< largest working load of a cylinder (thesis, chapter 4)
  double pressure_floor_Pa = 0.1e6;  ///< below the atmosphere a chamber begins to draw a vacuum
  double stroke_m = 0.030;
};

/// State at one load.
struct LoadState {
  double load_N = 0;
  double x_m[2] = {0, 0};  ///< lead, trail in the frame, from where they stand without load
  double yaw_rad[2] = {0, 0};
  std::vector<double> force_N;  ///< per cylinder
  std::vector<double> piston_m;
  std::vector<double> pressure_Pa;  ///< per line
};

/// A limit and the load per box at which it is reached first; NaN = not within the case.
struct LimitReached {
  std::string what;  ///< "cylinder 1 at 60 kN", "line L4 empty", …
  double load_N = 0;
};

struct LoadResult {
  LoadCase load_case;
  LoadState end;
  std::vector<LimitReached> limits;  ///< in the order they are reached
};

/// Errors: no PHS, joints missing, no equilibrium.
Result<std::vector<LoadResult>> CalcLoadCases(const vehicle::Simulation& simulation,
                                              const std::vector<LoadCase>& cases,
                                              const PartLimits& limits = {});

/// loads.json: each case with the state at its full load, and of that the largest shift of an axle,
/// the largest force of a cylinder (magnitudes) and the least pressure of a line.
nlohmann::ordered_json LoadsJson(const vehicle::Simulation& simulation,
                                 const std::vector<LoadResult>& results);

/// Stiffness of same-sense yaw with one load held.
struct HeldLoad {
  std::string name;
  bool held = false;  ///< false: the load has no equilibrium, its numbers say nothing
  double shear_stiffness_Nm_per_rad = 0;
  LoadState state = {};
};
struct HeldShear {
  HeldLoad rest;
  std::vector<HeldLoad> cases;
};

/// At rest and with each load held both axles are turned alike by an infinitely small angle from
/// where the load has put them, seals free; the sum of their moments over the angle, springs and
/// linkages included.
Result<HeldShear> CalcHeldShear(const vehicle::Simulation& simulation,
                                const std::vector<LoadCase>& cases);

/// `{"rest": {"shear_stiffness_Nm_per_rad", "lines": [{"name", "pressure_Pa"}]}, "cases": [{"name",
/// "held", "shear_stiffness_Nm_per_rad", "largest_shift_m", "least_pressure_Pa", "lines"}]}`; a load
/// that is not held has `held` 0 and null for its numbers.
nlohmann::ordered_json HeldShearJson(const vehicle::Simulation& simulation, const HeldShear& shear);

}  // namespace phs::analysis
