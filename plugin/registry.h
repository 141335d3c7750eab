// Which model is bound to which physics, and the engine callbacks that ask.
//
// MuJoCo's callbacks are process-global pointers without user data. They are installed once (when
// the first model is attached), chain whatever was installed before, and look the model up here.
// Look-ups take no lock: a thread remembers the last model it saw until any binding changes.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "base/result.h"
#include "plugin/binding.h"

namespace phs::plugin {

/// Binds `m`, installs the callbacks if needed, settles the vehicle on its track and, if the model
/// has a key named "test", stores the running start there. A model already attached is bound anew.
Status Attach(mjModel* m, const AttachOptions& options);
/// Forgets `m` and undoes the changes to it. No thread may be stepping it. Unknown models: no-op.
void Detach(mjModel* m);
/// Forgets `m` without touching it (its memory may be gone already).
void Forget(const mjModel* m);
/// The binding of a model, or null.
const Binding* Find(const mjModel* m) noexcept;

}  // namespace phs::plugin
