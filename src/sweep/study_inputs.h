// The files that decide the runs of a study: the scenarios or manifests, and whatever these name
// (track, profiles, bogie with its includes, PHS models, records …), and what the product takes when
// nothing is named.
//
// Every text in those files that names a file is followed: beside the file it stands in, from the
// current directory, or in the product's folders. So a file may be listed that no run reads; none
// that is read is missing.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Absolute paths, sorted, each once.
std::vector<std::string> InputFiles(const Study& study);

/// Everything that decides the runs, as text: a line "input SHA256 PATH" for every input file, the
/// study, the laid-out values. Other results would follow from another text.
std::string PlanText(const Study& study);

/// Success if every input file of that plan is as it was. The error names the one that is not.
Status CheckInputs(const std::string& plan_text);

}  // namespace phs::sweep
