// What is wrong with a model although MuJoCo accepts it: said in one line before anything is bound.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "base/result.h"
#include "plugin/attach_options.h"

namespace phs::plugin {

/// Errors name the MJCF element:
///   - a custom field or tuple that begins like ours and is none (`phs_tracks`, `wheelst:lead`), a
///     text where a number belongs or the other way round, a PHS model for a PHS that is not there;
///   - the same body in two wheelsets, the same actuator twice among the cylinders and states;
///   - a negative speed, in the model or in `options`;
///   - a failure in a PHS that the model does not have;
///   - wheelsets without a key named "test", where the settled start is kept.
Status CheckModel(const mjModel* m, const AttachOptions& options);

/// True if an actuator can be a cylinder: `biastype="user"` on a tendon or on a slide joint, whose
/// length is the distance of the pins and whose force acts along it.
bool IsCylinder(const mjModel* m, int actuator);

}  // namespace phs::plugin
