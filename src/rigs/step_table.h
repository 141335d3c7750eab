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

/// Mean of |predicted - measured|/measured, each capped at 1, as the thesis's relative errors are.
double MeanRelativeError(const std::vector<double>& predicted, const std::vector<double>& measured);

/// What a fit may move beside the oil compliance and the two gas volumes.
struct StepFreedom {
  bool precharge = false;  ///< effect accumulator_precharge
  bool stop = false;       ///< effect diaphragm_stop, of each line
  bool filling = false;    ///< static pressure of each line: filled to another one than declared
};

/// Free parameters of a setup, fitted to settled pressures in ln(absolute pressure).
struct StepFit {
  double oil_compliance_m3_per_Pa = 0;  ///< V_oil/beta of each line
  double gas_bore_m3 = 0, gas_rod_m3 = 0;
  double min_gas_bore_m3 = 0, min_gas_rod_m3 = 0;  ///< diaphragm on its stop
  double precharge_Pa = 0;                         ///< blow-off, absolute
  double static_bore_Pa = 0, static_rod_Pa = 0;    ///< before the step, absolute
  double error_in_sample = 0;  ///< mean relative error of the rows it was fitted to
};
/// Deterministic (Levenberg-Marquardt).
Result<StepFit> FitSteps(const hydraulics::PhsParams& declared, const std::vector<StepRow>& rows,
                         const StepFreedom& freedom);
hydraulics::PhsParams WithStepFit(const hydraulics::PhsParams& declared, const StepFit& fit,
                                  const StepFreedom& freedom);
/// Settled pressures (gauge) of `rows`: every gas at the temperature of its surroundings.
Result<std::vector<double>> PredictSettled(const hydraulics::PhsParams& params,
                                           const std::vector<StepRow>& rows);

/// Settled pressures of one setup: declared, fitted, and each step predicted from the others.
struct StepComparison {
  std::vector<StepRow> rows;                                ///< those with a settled pressure
  std::vector<double> declared_Pa, fitted_Pa, left_out_Pa;  ///< of the rows, gauge
  double error_declared = 0, error_fitted = 0, error_left_out = 0;
  StepFit fit;                   ///< to all rows
  std::vector<StepFit> without;  ///< to the rows of all steps but one
};
Result<StepComparison> CompareSteps(const hydraulics::PhsParams& declared,
                                    const std::vector<StepRow>& rows, const StepFreedom& freedom);

}  // namespace phs::rigs
