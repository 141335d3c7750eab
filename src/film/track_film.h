// The track, the cameras and the scales of a replay.
#pragma once

#include "report/replay.h"
#include "view/mesh.h"
#include "view/stage.h"

namespace phs::film {

report::ReplayMesh PlainMesh(const view::Mesh& mesh);

/// Stations along the alignment from before `begin_s` to behind `end_s`, and what stands on them.
void AddTrack(const view::Stage& stage, double begin_s, double end_s, report::Replay* replay);

/// The cameras of view/camera.h that look at the whole vehicle or a wheel, against L.
void AddViews(const view::Stage& stage, report::Replay* replay);

/// What the arrows stand for.
std::string ArrowsText(bool cylinders);

}  // namespace phs::film
