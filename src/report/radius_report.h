// The report of `phs compare --radii`: bogies over the radius of the curve.
#pragma once

#include <string>

#include "base/result.h"

namespace phs::report {

/// Reads bogies.json, writes one self-contained HTML page.
Status WriteRadiusReport(const std::string& bogies_file, const std::string& path);

}  // namespace phs::report
