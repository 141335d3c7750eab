// What other programs' viewers are given to see: track and forces as shapes in the engine's scene.
// The preload library adds them behind mjv_updateScene (preload.cc). Needs no OpenGL.
#pragma once

#include <mujoco/mujoco.h>

#include "plugin/binding.h"

namespace phs::plugin {

/// Scales of arrows [m/N].
inline constexpr double kLoadScale = 4e-6;       ///< wheel load Q
inline constexpr double kGuidingScale = 20e-6;   ///< guiding force Y, longitudinal force X
inline constexpr double kCylinderScale = 50e-6;  ///< cylinders

/// Rails and sleepers about the vehicle, and per wheel the forces of the rail on it: blue upwards
/// the load, orange the guiding force, green the longitudinal force; on the second end of every
/// cylinder its force, red where it pushes, violet where it pulls. As far as the scene has room.
void AddSceneMarks(const mjModel* m, const mjData* d, const Binding& binding, mjvScene* scene);

}  // namespace phs::plugin
