// The four patterns in which the axles of a bogie move against its frame, and the joints that carry
// them.
#pragma once

#include <string>

#include "base/result.h"
#include "plugin/binding.h"

namespace phs::analysis {

struct AxlePattern {
  const char* name;
  bool rotation;
  const char* joint;  ///< "_x" or "_yaw"
  double sign[2];     ///< lead, trail
};
inline constexpr AxlePattern kAxlePatterns[] = {{"bending", true, "_yaw", {1, -1}},
                                                {"shear", true, "_yaw", {1, 1}},
                                                {"traction", false, "_x", {1, 1}},
                                                {"antiphase", false, "_x", {1, -1}}};

/// Ids and addresses of the two joints of a pattern, lead and trail.
struct PatternJoints {
  int joint[2];
  int qpos[2];
  int dof[2];
};

/// Half the distance of the axle boxes: <numeric name="phs_box_lever_m"/> of the bogie, or 0.9 [m].
double BoxLever(const mjModel* m);

/// Error: the bogie has no joint "lead_yaw" or the like (with its prefix).
Result<PatternJoints> FindPatternJoints(const mjModel* m, const std::string& prefix,
                                        const AxlePattern& pattern);

}  // namespace phs::analysis
