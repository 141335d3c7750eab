// Reports of the analyses: axle modes of one or more bogies, and stability over speed.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::report {

/// Side by side from one modes.json per bogie.
Status WriteModesReport(const std::vector<std::string>& modes_files, const std::string& path);

/// From stability.json: critical speeds, root locus, growth, frequency and least damping over
/// speed, mode at the limit, limit cycle.
Status WriteStabilityReport(const std::string& stability_file, const std::string& path);

/// From curving.json: angle of attack, guiding forces and wear over radius, one curve per bogie.
Status WriteSteadyCurvingReport(const std::string& curving_file, const std::string& path);

}  // namespace phs::report
