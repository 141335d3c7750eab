// Which of the numbers that a step table can tell are needed: greedy, judged on steps left out.
// Then, run by run, whether the pressures just after a step ask for gas that warms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "measurement/manifest.h"
#include "measurement/step_case.h"
#include "rigs/step_fit.h"

namespace phs::identify {

/// A fit of one set of numbers, judged.
struct StepCandidate {
  std::string name;                 ///< accumulator_precharge, diaphragm_stop, filling
  std::vector<std::string> beside;  ///< accepted before it
  std::optional<double> error_left_out, error_in_sample;
  std::string why;
};

/// Pressures just after the step of one run, each step left out of every fit.
struct StepThermal {
  bool accepted = false;
  double thermal_time_s = 0, low_s = 0, high_s = 0;  ///< range: over the steps left out
  std::vector<double> isothermal_Pa, thermal_Pa;     ///< left out, gauge, by row
  double error_isothermal = 0, error_thermal = 0;    ///< relative, gauge
  std::string why;
};

struct StepSearch {
  rigs::StepProblem before_problem, problem;
  rigs::StepComparison before, after;
  std::vector<std::string> accepted;
  std::vector<StepCandidate> candidates;
  std::vector<StepThermal> thermal;  ///< by run
};

/// The runs of a manifest, with the numbers that are free from the beginning: those of `free:`, or
/// the oil and the gas of each line.
Result<rigs::StepProblem> MakeStepProblem(const measurement::Manifest& manifest,
                                          const std::vector<measurement::StepCase>& cases);
/// `effect` with the numbers it frees; a number named in `shared` has one value for all runs.
rigs::StepProblem WithEffect(const rigs::StepProblem& problem, const std::string& effect,
                             const std::vector<std::string>& shared);

Result<StepSearch> SearchSteps(const rigs::StepProblem& problem,
                               const std::vector<std::string>& shared);

}  // namespace phs::identify
