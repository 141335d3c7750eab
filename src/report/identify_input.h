// The files that a page of an identification is made from.
#pragma once

#include <string>

namespace phs::report {

struct IdentifyReportInput {
  std::string result = {};     ///< result.json
  std::string measured = {};   ///< the measured data (CSV or .mat)
  std::string predicted = {};  ///< predicted.csv: the corrected model (or the model of a rig run)
  std::string baseline = {};   ///< the same of the declared model fitted; empty = none saved
};

}  // namespace phs::report
