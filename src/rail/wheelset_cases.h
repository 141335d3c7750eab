// A wheelset placed on track, case by case: `phs contact --wheelset`.
//
// Columns read (one position per row; CONTACT's track axes: x forward, y to the right, z down;
// roll, yaw, pitch right-handed about them; pitch speed negative when rolling forward). Each may
// also carry CONTACT's own name, in CONTACT's units (mm, N, rad, mm/s), in any case of letters:
//   y_mm            Y,  Y_WS           lateral position of the wheelset's centre
//   Fz_N            FZ                 vertical force on the rail: the height is solved; or else
//   z_mm            Z,  Z_WS           height below that of a tape circle at rail-top level
//   roll_rad        ROLL,   ROLL_WS    optional, 0
//   yaw_rad         YAW,    YAW_WS     optional, 0
//   vs_mm_s         VS,     VX_WS      forward speed
//   vpitch_rad_s    VPITCH, VPITCH_WS  about the axle
//   vy_mm_s, vz_mm_s, vroll_rad_s, vyaw_rad_s (VY, VZ, VROLL, VYAW)   optional, 0
//   side                               optional: a text with left or right, else the side asked for
// Lengths and speeds are also taken as y_m, z_m, vs_m_s, vy_m_s, vz_m_s. All other columns are
// passed through. One row of result per patch; a lifted wheel gives one row with patch 0. Added, in
// mm, N, rad unless named, forces on the rail, CONTACT's signs (positive creepage, negative force):
//   case, patch, patches, z_solved_mm, FX_N, FY_N, FZ_N (whole wheel, track axes), weight
//   (below 1 while two patches grow into one: forces are that share), ycp_rail_mm,
//   zcp_rail_mm, ycp_wheel_mm, zcp_wheel_mm (profile axes: y to the right), contact_angle_rad, xi,
//   eta, phi_rad_per_mm, FN_N, Fx_N, Fs_N, Mn_Nmm, a_mm, b_mm, approach_mm, pmax_MPa,
//   rolling_radius_mm, friction
#pragma once

#include <string>

#include "base/result.h"
#include "base/table.h"
#include "rail/wheel_rail.h"

namespace phs::rail {

/// A table of positions with the pair it belongs to.
struct WheelsetCases {
  WheelRailParams wheel_rail;
  Side side = Side::kLeft;
  Table table;
};

/// Evaluates every row. A wrong cell gives an error with its line, as does a load that no height
/// carries.
Result<Table> CalcWheelsetCases(const Table& table, const WheelRail& wheel_rail, Side side);
/// The same from parameters.
Result<Table> CalcWheelsetCases(const WheelsetCases& cases);

/// Reads an input file of CONTACT for wheel-rail cases (module 1) as far as its keys concern
/// position, speeds, load, profiles and material. Lines are known by the labels behind their
/// numbers; what a later case leaves out stays as it was. Profiles are looked up beside the file.
Result<WheelsetCases> ReadContactInput(const std::string& path);

}  // namespace phs::rail
