// How the values of axes come into the files of a run.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "sweep/study.h"

namespace phs::sweep {

/// The axes of a run with its values, then what its case sets.
using SetValues = std::vector<std::pair<std::string, std::string>>;
SetValues ValuesOf(const Study& study, int run);
/// Some key begins with `prefix` ("track.").
bool Varies(const SetValues& values, const std::string& prefix);

/// An error of a value, at its axis.
Error AtAxis(const Study& study, const std::string& key, const Error& inner);

/// Puts the values whose keys begin with `prefix` into the tree below it: "segments.*.radius_m". A
/// last key that does not exist is made, for the reader of the file to judge.
Status SetKeys(const Study& study, const SetValues& values, const std::string& prefix,
               const YAML::Node& root);

/// One number of the model, as an axis "model.KEY" means it.
struct ModelNumber {
  std::string name;
  double value;
};
/// "*.gas_volume_m3" is that of every line. Error: no such number (the nearest), no number.
Result<std::vector<ModelNumber>> ModelNumbers(const std::string& key, const std::string& value,
                                              const hydraulics::PhsParams& params);

Result<YAML::Node> LoadFile(const std::string& path);

}  // namespace phs::sweep
