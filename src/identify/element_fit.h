// Fit of a bench part's model to measured forces of one or several runs.
//
// Minimised: sum over the rows k of the estimation windows of rho(w_k (y_k - model_k(theta))),
//   1/w_k² = scale² + (dF/dv sigma_v,k)²:
// where the force is steep over the speed and the speed is uncertain a row says little. `scale` is
// the level of the residual itself, so intervals and evidence do not trust the sensor noise alone.
// rho: Huber beyond 4 levels. The model runs at the full rate; model and measurement pass the same
// band limit.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "identify/element_data.h"
#include "identify/search_fit.h"

namespace phs::identify::element {

using search::FreeModel;
using search::FreeParameter;

struct ElementFit {
  std::vector<double> values;   ///< of the free parameters
  std::vector<double> half_95;  ///< half width of the 95 % interval, in coordinates
  Eigen::VectorXd residual;     ///< weighted: measured - model
  Eigen::MatrixXd jacobian;     ///< d residual / d coordinate
  double mean_square = 0;       ///< of the weighted residual
  double independent = 0;       ///< samples worth as much as the correlated ones
  bool ok = false;
};

class ElementProblem {
 public:
  /// `data` must outlive the problem.
  static Result<ElementProblem> Create(const ElementData& data,
                                       const hydraulics::PhsParams& declared);

  const ElementData& data() const { return *data_; }
  int num_rows() const { return num_rows_; }
  const std::vector<double>& weights() const { return weight_; }

  hydraulics::PhsParams Params(const FreeModel& model, const std::vector<double>& values) const;
  /// Weighted residual and, if not null, its derivative over the coordinates from `first` on.
  bool Evaluate(const FreeModel& model, const std::vector<double>& values,
                Eigen::VectorXd* residual, Eigen::MatrixXd* jacobian, int first = 0) const;
  ElementFit Fit(const FreeModel& model, const std::vector<double>& start, int max_steps) const;
  /// Force on the rows of every record, in the band.
  Result<std::vector<std::vector<double>>> Predict(const hydraulics::PhsParams& params) const;
  /// Force at the full rate.
  Result<std::vector<double>> PredictRecord(const hydraulics::PhsParams& params,
                                            size_t record) const;
  /// Band limit and weights applied to a signal given at the full rate of every record.
  Eigen::VectorXd Column(const std::vector<std::vector<double>>& full) const;
  /// New weights: level `scale_N` and this model's sensitivity to speed.
  Status SetWeights(const hydraulics::PhsParams& params, double scale_N);
  /// Samples worth as much as the rows of this residual, run by run.
  double Independent(const Eigen::VectorXd& residual) const;
  std::vector<int> Blocks(int* count) const;

 private:
  const ElementData* data_ = nullptr;
  std::vector<rigs::RigMotion> fitted_motion_;  ///< of each record, to its last fitted row
  int num_rows_ = 0;
  std::vector<int> first_row_;  ///< of each record in the residual; one more at the end
  std::vector<double> weight_;
};

}  // namespace phs::identify::element
