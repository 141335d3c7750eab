// Files of a data set: FOLDER/run.csv, FOLDER/MANIFEST.yaml, and the truth in a file elsewhere, so
// that nothing beside the data gives it away.
#pragma once

#include <string>

#include "rig_set.h"

namespace rigdata {

// Throws std::runtime_error with the path when a file cannot be written.
void WriteSet(const RigSet& set, const std::string& folder, const std::string& truth_path);
std::string TruthJson(const RigSet& set);

}  // namespace rigdata
