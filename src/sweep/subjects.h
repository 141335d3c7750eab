// What a study can vary: the keys `scenario:` and `rig:`, a row each.
#pragma once

#include <span>

#include "base/yaml.h"
#include "sweep/subject_row.h"

namespace phs::sweep {

std::span<const Subject> Subjects();

/// The one whose key the map has; the first where it has none. Two are an error of the map.
const Subject* ReadSubject(YamlMap* map);

}  // namespace phs::sweep
