// The files of one run: the base scenario, its track and its PHS model with the axes' values set.
#pragma once

#include <string>

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Writes scenario.yaml, and track.yaml and model.yaml where they differ from the base, into
/// `folder`, which exists. `phs simulate FOLDER/scenario.yaml` then repeats the run. Returns the
/// path of scenario.yaml. Errors name the axis.
Result<std::string> WriteCaseFiles(const Study& study, int run, const std::string& folder);

/// The same in `folder`, for files that will be moved to `final_folder`: they name each other
/// there.
Status LayOutRun(const Study& study, int run, const std::string& folder,
                 const std::string& final_folder);

/// Lays out the first run of each case and reads its scenario: finds wrong keys before anything
/// runs.
Status CheckCases(const Study& study);

}  // namespace phs::sweep
