// The files of one run: the base of its case with the axes' values set.
#pragma once

#include <string>

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Writes the files of a run as its subject lays them out into `folder`, which exists: `phs simulate
/// FOLDER/scenario.yaml`, `phs rig FOLDER/rig.yaml` then repeat it. Returns the path of that file.
/// Errors name the axis.
Result<std::string> WriteCaseFiles(const Study& study, int run, const std::string& folder);

/// The same in `folder`, for files that will be moved to `final_folder`: they name each other
/// there.
Status LayOutRun(const Study& study, int run, const std::string& folder,
                 const std::string& final_folder);

/// Lays out the first run of each case and reads its file: finds wrong keys before anything
/// runs.
Status CheckCases(const Study& study);

}  // namespace phs::sweep
