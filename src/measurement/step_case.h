// The rows of a step table that a manifest asks for, and scores of settled pressures.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "measurement/channel_scores.h"
#include "measurement/manifest.h"
#include "rigs/step_table.h"

namespace phs::measurement {

struct StepCase {
  std::string model;  ///< as the manifest names it
  hydraulics::PhsParams declared;
  std::string source;
  int setup = 0;  ///< 0: the rows of all setups
  std::vector<rigs::StepRow> rows;
};

/// One case for each run. The setup: as in the run or the manifest; else the number at the end of
/// the model's name if the table has it; else all rows.
Result<std::vector<StepCase>> ReadStepCases(const Manifest& manifest);

/// Over the rows.
ChannelScore ScoreSteps(const std::vector<double>& measured, const std::vector<double>& predicted);

/// A table with the columns of Table B-1; pressures in gauge Pa by row.
Status WriteStepTable(const std::string& path, const std::vector<rigs::StepRow>& rows,
                      const std::vector<double>& begin_Pa, const std::vector<double>& end_Pa,
                      const std::vector<double>& tau_s);

}  // namespace phs::measurement
