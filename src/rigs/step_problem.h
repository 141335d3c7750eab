// Settled pressures of one or several setups of a step table as one problem of fitting: which
// numbers of the models are free, which of them the setups share, and what the models predict.
//
// A number is named as phs_model::SetParameter names it: "L1.gas_volume_m3", "lines.oil_volume_m3"
// (every line at once). It is fitted by its logarithm; a shared one has one value for all setups.
// Pressures of rows are gauge, those of the models absolute.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "rigs/step_table.h"

namespace phs::rigs {

/// One setup: its declared model and the rows that hold a settled pressure.
struct StepRun {
  std::string model;  ///< as the manifest names it
  hydraulics::PhsParams declared;
  int setup = 0;
  std::vector<StepRow> rows;
};

struct StepNumber {
  std::string name;
  bool shared = false;
  double start = 0;  ///< where a model declares 0: the share of the gas volume to begin at
};

struct StepProblem {
  std::vector<StepRun> runs;
  std::vector<StepNumber> numbers;
  std::function<bool()> go_on = {};  ///< asked before every fit: false = stop, with an error

  int num_rows() const;
  /// Places in the vector of logarithms: one of a shared number, one per run of an own one.
  int num_free() const;
  /// Place of number `k` of run `r`.
  int Place(size_t k, size_t r) const;
};

/// Rows with a settled pressure (rows 5 and 6 of Table B-1 hold no relaxation, but their settled
/// pressures are measured), in the order of the table.
std::vector<StepRow> SettledRows(const std::vector<StepRow>& rows);

/// Logarithms of the declared numbers; of a shared one, the mean over the runs. Errors: a name that
/// a model does not know, or a number that is 0 there.
Result<Eigen::VectorXd> DeclaredLogs(const StepProblem& problem);
/// The model of run `r` with the numbers of `logs`.
Result<hydraulics::PhsParams> ModelOf(const StepProblem& problem, const Eigen::VectorXd& logs,
                                      size_t r);
/// The problem without the rows of one step (it loads both chambers: both of its rows) of run `r`.
StepProblem WithoutStep(const StepProblem& problem, size_t r, double actuator_step_m);

}  // namespace phs::rigs
