// A rig as a sweep runs it: driven over time, with generated motion or a record of its cylinders.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "measurement/manifest.h"

namespace phs::sweep {

Result<std::string> FindRig(const std::string& name);
Result<measurement::Manifest> ReadRig(const std::string& file);
/// It can be read with its model, and is one that a sweep runs.
Status CheckRig(const std::string& file);
/// The records that the manifest names, environment variables put in.
std::vector<std::string> RigRecords(const std::string& path);
/// The numbers of its result.json (measurement/rig_numbers.h).
Result<nlohmann::ordered_json> CalcRig(const std::string& file);

}  // namespace phs::sweep
