// Sparse regression: which few of many terms explain a residual.
//
// The terms that the model's own free numbers can imitate are taken out first
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

namespace phs::identify {

struct SelectionData {
  /// Weighted residual (measured - model) and its derivative over what is free in the model.
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
  /// Independent samples in a residual on these rows.
  std::function<double(const Eigen::VectorXd&)> independent;
};

struct FormulaLimits {
  int max_terms = 3;
  double threshold = 12;   ///< of the evidence of each term
  double min_gain = 0.03;  ///< share of the residual's rms that each term must remove
  bool readings = true;    ///< what a sensor says beyond the truth, too
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
  std::string unit = "N";            ///< of the coefficients, as in c1_N
  std::vector<std::string> targets;  ///< where it acts; empty = the piston
  std::vector<double> coefficients;  ///< c1 …, linear estimate
  double gain = 0;                   ///< share of the residual's rms removed
  double cross_validation_gain = 0;
  bool empty() const { return terms.empty(); }
};

/// A term on trial: one or two columns.
struct TermTrial {
  std::string text, second;
  int factors = 1;          ///< for preferring the simpler of two
  double looked_at = 0;     ///< ln of how many were looked at to find this one (waves)
  Eigen::MatrixXd columns;  ///< weighted, what the model can imitate taken out
};

/// Where terms come from.
class TermLibrary {
 public:
  /// `model_space`: orthonormal basis of what the model's numbers can imitate.
  explicit TermLibrary(const Eigen::MatrixXd& model_space) : model_space_(model_space) {}
  virtual ~TermLibrary() = default;
  std::vector<TermTrial>& trials() { return trials_; }
  /// Adds terms that depend on what is still left; they are taken off again after the round.
  virtual void AddForResidual(const Eigen::VectorXd& /*residual*/) {}

 protected:
  /// Takes a term with its weighted columns (coefficient 1) unless the model can imitate it.
  void AddColumns(const std::string& text, const std::string& second, int factors, double looked_at,
                  const Eigen::MatrixXd& columns);
  /// Columns with what the model can imitate taken out.
  Eigen::MatrixXd Own(const Eigen::MatrixXd& columns) const;

 private:
  const Eigen::MatrixXd& model_space_;
  std::vector<TermTrial> trials_;
};

/// `value` rounded to one digit 1, 2 or 5: scales that read well. 1 if it is no positive number.
double RoundScale(double value);

/// Orthonormal basis of what the model's free numbers can imitate.
Eigen::MatrixXd ModelSpace(const Eigen::MatrixXd& jacobian, Eigen::Index rows);

/// `space`: that of the data's Jacobian.
FoundFormula SelectTerms(const SelectionData& data, const Eigen::MatrixXd& space,
                         const FormulaLimits& limits, TermLibrary* library);

}  // namespace phs::identify
