// phs video: films and pictures without a display.
#pragma once

#include "base/result.h"
#include "vehicle/simulation.h"
#include "view/request.h"

namespace phs::screen {

/// What was written, for the line that says so.
struct Filmed {
  int pictures = 0;
  double seconds = 0;  ///< that drawing and writing took
};
/// `progress` is called while the run is simulated and drawn; it ends both by false.
Result<Filmed> MakeVideo(const view::Request& request, const vehicle::Progress& progress);

}  // namespace phs::screen
