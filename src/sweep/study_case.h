// What one run of a study calculates: which analysis, of which file, with which keys set.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sweep/analyses.h"
#include "sweep/subject_row.h"

namespace phs::sweep {

struct StudyCase {
  std::string name = {};  ///< empty: the only one
  const Analysis* analysis = &Analyses().front();
  const Subject* subject = nullptr;                           ///< what `base` is
  std::string base = {};                                      ///< path of the scenario or manifest
  std::vector<std::pair<std::string, std::string>> set = {};  ///< key of an axis (study.h), value
  std::vector<std::string> outputs = {};  ///< those of the study's that it has; empty = all
};

/// An output that is no number of the result, at `where`.
inline Error AtOutput(const std::string& where, Error error, const StudyCase& of) {
  error.where = where;
  error.allowed = std::string("paths of numbers in ") + of.subject->result;
  return error;
}

}  // namespace phs::sweep
