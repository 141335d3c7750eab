// Fit of settled pressures, and each step predicted from the others.
//
// Residual of a row: r = ln(p_model/p_measured), absolute pressures. It is the sum of a reading
// error of the pressure, standard deviation s_p [Pa], and of what the model lacks, a share s_m of
// the pressure: variance s_m² + (s_p/p)². A row at atmospheric pressure thus says less of the oil
// than one at 10 MPa. Both sizes are estimated with the fit by restricted maximum likelihood
// (Patterson, Thompson, Biometrika 58 (1971) 545):
//   2 L = Σ r²/σ² + Σ ln σ² + Σ ((q − q0)/w)² + ln det(JᵀΣ⁻¹J + I/w²)
// q: logarithms of the numbers, q0: declared, J = dr/dq. Prior width w = ln 3: a declared number
// may well be wrong by a factor of three; what no row determines stays where it was.
// The likelihood of q is minimised by Levenberg-Marquardt, that of the sizes by a pattern search in
// their logarithms. Deterministic.
#pragma once

#include <vector>

#include "rigs/step_problem.h"

namespace phs::rigs {

/// Sizes of the errors of a settled pressure.
struct StepErrors {
  double model = 0.02;       ///< s_m, 1e-3 … 1
  double reading_Pa = 20e3;  ///< s_p, 1e3 … 1e6
};

struct StepFit {
  Eigen::VectorXd logs;  ///< by StepProblem::Place
  Eigen::VectorXd sd;    ///< standard deviations of `logs`
  StepErrors errors;
  double criterion = 0;  ///< 2 L
};
/// Error: fewer settled pressures than numbers.
/// `near`: the fit of all but the same rows, to begin at.
Result<StepFit> FitSteps(const StepProblem& problem, const StepFit* near = nullptr);

/// Settled pressures (gauge) of the rows of run `r`.
Result<std::vector<double>> SettledOf(const StepProblem& problem, const Eigen::VectorXd& logs,
                                      size_t r);

/// A step left out of the fit.
struct StepLeftOut {
  size_t run = 0;
  double actuator_step_m = 0;
  StepFit fit;
};
/// Settled pressures (gauge) by run and row: declared, fitted, and each step from the others.
struct StepComparison {
  std::vector<std::vector<double>> declared_Pa, fitted_Pa, left_out_Pa;
  StepFit fit;
  std::vector<StepLeftOut> without;
};
/// Error: fewer settled pressures than numbers, in any of the fits.
Result<StepComparison> CompareSteps(const StepProblem& problem);

/// Mean over all rows of all runs.
double MeanRelativeError(const StepProblem& problem,
                         const std::vector<std::vector<double>>& predicted_Pa);
/// Mean of |predicted - measured| over the measured absolute pressure; all gauge.
double MeanAbsolutePressureError(const std::vector<double>& predicted_Pa,
                                 const std::vector<double>& measured_Pa);
/// Settled pressures (gauge) as measured.
std::vector<double> MeasuredSettled(const StepRun& run);

}  // namespace phs::rigs
