// modes.json (docs/results.md) of axle modes that were measured.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/axle_modes.h"

namespace phs::analysis {

nlohmann::ordered_json AxleModesJson(const std::string& bogie, const AxleModes& modes,
                                     const AxleModeOptions& options);

}  // namespace phs::analysis
