// Which model is bound to which physics, and the engine callbacks that ask.
//
// MuJoCo's callbacks are process-global pointers without user data. They are installed when the
// first model is attached, chained with those of others (callback_chain.h), and look the model up
// here by the mark that it carries (model_mark.h). A copy made with mj_copyModel carries the same
// mark: it shares the physics of the original, from its first engine call on (or from the copying
// on, where preload.cc stands in front of it), and keeps it when the original goes.
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
/// Forgets `m` and undoes the changes to it; the key "test" keeps the running start. Copies of `m`
/// that are served go on. No thread may be stepping `m`. Unknown models: no-op.
void Detach(mjModel* m);
/// Forgets `m` without touching it (its memory may be gone already).
void Forget(const mjModel* m);
/// The binding of a model or of the model it is a copy of, or null.
const Binding* Find(const mjModel* m) noexcept;
/// True if `m` was attached, or is a copy of such a model or was saved from one, and is no more.
bool WasAttached(const mjModel* m) noexcept;

/// Which of the callbacks that `m` needs were taken by others who do not call ours, with what that
/// does; "" if none. Where it is not known yet whether they call ours, one mj_forward on data of
/// its own finds out.
std::string Bypassed(const mjModel* m);
/// Puts the callbacks back in front, before those that others installed since; they are called by
/// ours from then on. For an attached `m` only. Takes no lock while nothing has changed.
void StandInFront(const mjModel* m) noexcept;

}  // namespace phs::plugin
