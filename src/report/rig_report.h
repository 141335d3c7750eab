// The report of a `phs rig` run without a clocked measurement: generated motion, or steps that are
// held. Made from saved files only.
#pragma once

#include <string>

#include "base/result.h"

namespace phs::report {

struct RigReportInput {
  std::string result = {};     ///< result.json
  std::string predicted = {};  ///< predicted.csv
  std::string measured = {};   ///< measured.csv of a step table; empty = none
};

Status WriteRigReport(const RigReportInput& input, const std::string& path);

}  // namespace phs::report
