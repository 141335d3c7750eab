// phs view: a run in a window, replayed as it was recorded.
#pragma once

#include "base/result.h"
#include "vehicle/simulation.h"
#include "view/request.h"

namespace phs::screen {

/// Returns when the window is closed. Without a display: an error that names phs video.
Status ShowWindow(const view::Request& request, const vehicle::Progress& progress);

}  // namespace phs::screen
