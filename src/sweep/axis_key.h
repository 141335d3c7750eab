// Keys that a study may vary: "scenario.speed_m_s", "model.friction.scale".
#pragma once

#include <string>

#include "base/result.h"

namespace phs::sweep {

/// Whether `key` begins as an axis must (study.h).
Status CheckAxisKey(const std::string& key);

}  // namespace phs::sweep
