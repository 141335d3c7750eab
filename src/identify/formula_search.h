// What the catalogue does not hold: on which variables a residual force depends, and a compact
// formula for it, by sparse regression over dimensionally sound terms.
//
// Terms are products of plain numbers: x/L, v/V, p/P, q/P, t/T0, dT/K and their powers, the
// direction s of friction (with its memory of reversals), s³ (the shape of a reversal), and waves
// sin and cos of 2 pi x/lambda, alone and times s, with lambda from a scan. Each coefficient is a
// force. The terms that the model's own free numbers can imitate are taken out first
// (Frisch–Waugh–Lovell), then terms are added one by one while
//   n_eff ln(SSE_before/SSE_after) - k ln n_eff - 2 ln(number of terms tried) > threshold
// with n_eff independent samples in the coloured residual (the last part pays for having looked at
// many terms: extended BIC, Chen and Chen 2008, Biometrika 95, 759), and dropped again when later
// ones make them superfluous. A formula must also predict blocks left out.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "hydraulics/extension.h"

namespace phs::identify {

/// Places of the model on its own clock, run by run.
using FormulaPlaces = std::vector<std::vector<hydraulics::ForcePlace>>;

struct FormulaData {
  /// Weighted residual (measured - model) and its derivative over what is free in the model.
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
  FormulaPlaces places;
  /// A force given at all places -> its weighted column on the rows of `residual`.
  std::function<Eigen::VectorXd(const std::vector<std::vector<double>>&)> column;
  /// Independent samples in a residual on these rows.
  std::function<double(const Eigen::VectorXd&)> independent;
  bool has_pressure = false, has_rod_pressure = false, has_temperature = false;
};

struct FormulaLimits {
  int max_terms = 3;
  double threshold = 12;   ///< of the evidence of each term
  double min_gain = 0.03;  ///< share of the residual's rms that each term must remove
};

/// One accepted term: one coefficient, or two (a wave).
struct FormulaTerm {
  std::string text;  ///< "s*(p/5e5[Pa])"; a wave: both parts, first with sin
  std::string second;
  double evidence = 0;
  double gain = 0;  ///< share of the residual's rms removed
};

struct FoundFormula {
  std::vector<FormulaTerm> terms;
  std::string text;                  ///< "c1*s*(p/5e5[Pa]) + …" as the effect `unlisted` takes it
  std::vector<double> coefficients;  ///< c1 … [N], linear estimate
  double gain = 0;                   ///< share of the residual's rms removed
  double cross_validation_gain = 0;
  bool empty() const { return terms.empty(); }
};

FoundFormula SearchFormula(const FormulaData& data, const FormulaLimits& limits);

/// Dependence of a residual on one variable: share of its variance explained by the means over 16
/// equally filled bins, less what chance gives, and the probability of as much by chance (F test
/// with n_eff samples).
struct VariableShare {
  std::string variable;  ///< "x_m", "speed_m_s", "reversal", "p_Pa", "t_s", "temperature_K"
  double share = 0;
  double p_value = 1;
};
/// Of a residual on the rows, variables given on the rows too; largest share first.
std::vector<VariableShare> ShareByVariable(
    const std::vector<double>& residual, double independent,
    const std::vector<std::pair<std::string, std::vector<double>>>& variables);

}  // namespace phs::identify
