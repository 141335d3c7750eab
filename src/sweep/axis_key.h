// Keys that a study may vary: "scenario.speed_m_s", "model.friction.scale".
#pragma once

#include <string>

#include "base/result.h"
#include "sweep/subject_row.h"

namespace phs::sweep {

/// Whether `key` begins as an axis over that subject must (study.h).
Status CheckAxisKey(const Subject& subject, const std::string& key);

}  // namespace phs::sweep
