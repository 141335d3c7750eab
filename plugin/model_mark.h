// The mark by which an attached model and its copies are known.
//
// mj_copyModel copies a model byte by byte, so the mark stands inside the model: in `prm` of the
// first element of its first tuple "wheelset:…", "phs:…" or of an element, a field that nobody
// reads. A mark is a positive number near 1e-271, in effect zero, whose digits are unique to the
// attachment. It goes with mj_saveModel too; mj_saveLastXML rounds it, which makes it one that
// nobody knows.
#pragma once

#include <mujoco/mujoco.h>

namespace phs::plugin {

/// Index into tuple_objprm where the model carries its mark, or -1 if it names nothing of ours.
int MarkSlot(const mjModel* m) noexcept;
/// True for what NewMark can give, also if it was rounded.
bool IsMark(double value) noexcept;
/// A mark that no other attachment of this or any other process has.
double NewMark();

}  // namespace phs::plugin
