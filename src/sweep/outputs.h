// Which numbers of a run's summary go into the table of a sweep.
//
// An output is a path in summary.json (base/json_path.h, docs/results.md):
//   steady_curve.wheelsets.lead.angle_of_attack_rad, run.T_gamma_total_J
// Its column is the path without its first part and without list names: lead_angle_of_attack_rad,
// T_gamma_total_J.

// Where two outputs would share a column, they have their whole paths:
// bending_stiffness_Nm_per_rad, shear_stiffness_Nm_per_rad.
#pragma once

#include <string>
#include <vector>

namespace phs::sweep {

std::string OutputColumn(const std::string& path);
/// The columns of several outputs, each its own.
std::vector<std::string> OutputColumns(const std::vector<std::string>& paths);

}  // namespace phs::sweep
