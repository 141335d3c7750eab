// The wheel-rail contact alone: `phs contact`, phs.contact in Python.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "base/result.h"
#include "base/table.h"
#include "rail/contact_functions.h"
#include "rail/wheelset_cases.h"

namespace phs::jobs {

/// What the user gave of wheel, rail and steel; what he left out comes from CONTACT's input file or
/// from the Manchester contact benchmark's wheelset on its track (Iwnicki 1998), no damping.
struct ContactPair {
  std::string wheel, rail;  ///< name, path, cone:LAMBDA, arc:RADIUS_M
  std::optional<double> gauge_m, gauge_height_m, cant_rad, flange_back_distance_m,
      flange_back_position_m, radius_m, mu, shear_modulus_Pa, poisson_ratio;
};

/// A table, or the name of one: an example of models/contact, a file (for wheelsets also .inp).
using Cases = std::variant<Table, std::string>;

/// Patches with creepages in, forces out. `method` empty: kalker_table.
Result<Table> CalcPatches(const Cases& cases, const std::string& method);

struct WheelsetPatches {
  rail::WheelsetCases cases;
  Table patches;
};
/// Positions of a wheelset in, contact patches out. `method` empty: fastsim; `side` of the wheel
/// where the table names none, left or right, empty: left.
Result<WheelsetPatches> CalcWheelset(const Cases& cases, const ContactPair& pair,
                                     const std::string& side, const std::string& method);

struct FunctionsRequest {
  ContactPair pair;
  double reach_m = 10e-3;  ///< largest lateral position
  double step_m = 0.1e-3;  ///< between lateral positions
  double load_N = 0;       ///< on each wheel; 0 = rigid bodies
};
struct Functions {
  rail::WheelRailParams pair;
  rail::ContactFunctions functions;
};
/// Radius difference, contact angles and equivalent conicity of a pair.
Result<Functions> CalcFunctions(const FunctionsRequest& request);
/// One row per lateral position.
Table FunctionsTable(const rail::ContactFunctions& functions);

}  // namespace phs::jobs
