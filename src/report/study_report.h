// The report of a design study: its question, and of each part what it asked, its curves, how far
// its numbers lie apart, and a link to its own report.
#pragma once

#include <string>

#include "base/result.h"

namespace phs::report {

/// From study.json in `folder`.
Status WriteStudyReport(const std::string& folder, const std::string& path);

}  // namespace phs::report
