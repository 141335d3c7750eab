// What one run of a study calculates: which analysis, of which scenario, with which keys set.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sweep/analyses.h"

namespace phs::sweep {

struct StudyCase {
  std::string name = {};  ///< empty: the only one
  const Analysis* analysis = &Analyses().front();
  std::string scenario = {};                                  ///< path
  std::vector<std::pair<std::string, std::string>> set = {};  ///< key of an axis (study.h), value
  std::vector<std::string> outputs = {};  ///< those of the study's that it has; empty = all
};

}  // namespace phs::sweep
