// The replay of a result directory for its report: the scene that src/view makes of recorded
// channels, at instants along the track, as parts with their places. No picture is drawn and no
// model is run.
//
//   report::Replay replay = film::FilmOrReason("results/r550");
//   report::WriteCurvingReport("results/r550", "results/r550/report.html", &replay);
#pragma once

#include <string>

#include "base/result.h"
#include "report/replay.h"

namespace phs::film {

struct FilmOptions {
  double spacing_m = 1;       ///< of the instants where the page has room for them
  int most_instants = 400;    ///< at most
  double most_bytes = 2.6e6;  ///< of all bogies together in the page, about; fewer instants then
};

/// Errors: no result with time series, a run that does not move, a model that is not there any more.
Result<report::Replay> MakeFilm(const std::string& dir, const FilmOptions& options = {});

/// The same; a replay that says why it is missing instead of an error.
report::Replay FilmOrReason(const std::string& dir);

}  // namespace phs::film
