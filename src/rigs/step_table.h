// Steps of the quarter rig (thesis Table B-1): piston moved quickly, then held while the gas gives
// off its heat; pressure just after the step, pressure when settled, time constant.
//
// Rows name a chamber (1 bore, 2 rod), a reservoir setup and the piston's step (laser) [m],
// extension > 0. Measured pressures are gauge [Pa]; the model's are absolute and are shown less
// 101325 Pa.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"

namespace phs::rigs {

struct StepRow {
  int row = 0;
  bool bore = false;
  bool compression = false;
  int setup = 0;
  double actuator_step_m = 0;
  double piston_step_m = 0;
  double begin_Pa = 0;  ///< gauge, just after the step
  double end_Pa = 0;    ///< gauge, settled
  double tau_s = 0;     ///< as printed (time to P_begin - 0.37 dP)
  bool valid = false;   ///< false: placeholder zeros in the thesis
};
/// Reads models/rigs/lowe_table_b1.csv or a table with the same columns (as there, or by the
/// thesis's names: step_schenck_mm, step_laser_mm, P_begin_MPa, P_end_MPa).
Result<std::vector<StepRow>> ReadStepTable(const std::string& path);

struct StepOptions {
  double rise_s = 0.2;   ///< duration of the step: assumed, the thesis does not give it
  double settle_s = 60;  ///< then held
};
struct StepPrediction {
  double begin_Pa = 0, end_Pa = 0;  ///< gauge
  double tau_s = 0;                 ///< time to 63.2 % of the relaxation; 0 where there is none
};
/// `params`: a quarter rig, one cylinder.
Result<StepPrediction> PredictStep(const hydraulics::PhsParams& params, const StepRow& row,
                                   const StepOptions& options = {});

/// What the heat of the gas does after a step, by row.
struct StepRelaxation {
  double begin_Pa = 0;  ///< gauge, just after the step
  double tau_37_s = 0;  ///< time to P_begin - 0.37 dP, the mark that the table's tau belongs to; 0
                        ///< where nothing relaxes
};
/// `rows` of one model; only gas with a temperature of its own relaxes.
Result<std::vector<StepRelaxation>> PredictRelaxations(const hydraulics::PhsParams& params,
                                                       const std::vector<StepRow>& rows,
                                                       const StepOptions& options = {});
/// Settled pressures (gauge) of `rows`: every gas at the temperature of its surroundings.
Result<std::vector<double>> PredictSettled(const hydraulics::PhsParams& params,
                                           const std::vector<StepRow>& rows);

/// Mean of |predicted - measured|/measured, each capped at 1, as the thesis's relative errors are.
double MeanRelativeError(const std::vector<double>& predicted, const std::vector<double>& measured);

}  // namespace phs::rigs
