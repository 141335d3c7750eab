// Fit of a rig model's numbers to measured channels.
//
// The residual of channel c, sample i of the estimation window is
//   w_ci (y_ci - model_ci(theta)),   1/w_ci² = noise_c² + u_ci²
// u is the model's own uncertainty (forward_model.h): of a rig, what the remaining uncertainty of
// the driving motion does to the output. What a fit minimises: likelihood.h, near_fit.h. Each number
// is fitted as its logarithm (wide positive range) or on a linear scale, inside bounds.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "identify/fit/acceptance.h"
#include "identify/fit/forward_model.h"
#include "identify/fit/likelihood.h"
#include "identify/fit/thread_budget.h"

namespace phs::identify::search {

/// One free number of a model.
struct FreeParameter {
  std::string name;  ///< as SetParameter takes it
  double start = 0;
  double low = 0, high = 0;  ///< bounds
  bool logarithmic = false;
  double scale = 1;  ///< linear only: size of one unit

  double ToCoordinate(double value) const;
  double FromCoordinate(double coordinate) const;
};

/// A declared structure (with effects switched on) and what is free in it.
struct FreeModel {
  hydraulics::PhsParams params;
  std::vector<FreeParameter> free;
};

/// The declared model with the numbers `names` free, each within factors 0.4 … 2.5 of the declared.
/// None named: V_oil, V_g0 and free air of every line and the friction scale, as far as it has
/// them.
FreeModel DeclaredModel(const hydraulics::PhsParams& declared, std::vector<std::string> names = {});
/// An error where one of `names` is not of the model, or not positive there.
Status CheckFree(const hydraulics::PhsParams& declared, const std::vector<std::string>& names);

/// The model with these values of its free numbers.
hydraulics::PhsParams ParamsOf(const FreeModel& model, const std::vector<double>& values);
/// The model with its free number `held` fixed at `value`.
FreeModel WithHeld(const FreeModel& model, size_t held, double value);

struct FitResult {
  std::vector<double> values;      ///< of the free parameters
  std::vector<double> half_95;     ///< half width of the 95 % interval, in coordinates
  Eigen::VectorXd residual;        ///< weighted, channels one after the other
  Eigen::MatrixXd slopes;          ///< of its coefficients (likelihood.h) over coordinates
  BandPowers powers;               ///< of `residual`
  double score = 0;                ///< -2 ln L
  std::vector<double> channel_ms;  ///< weighted mean square per channel
  int runs = 0;
  bool ok = false;
};

using SampleWeights = std::vector<std::vector<double>>;  ///< [block][row], 0 = missing

/// What a residual is measured by.
struct Weighting {
  SampleWeights sample;
  std::vector<Eigen::VectorXd> theories;      ///< differences, weighted (likelihood.h)
  std::vector<Eigen::VectorXd> inputs;        ///< ForwardModel::InputErrors, weighted
  std::shared_ptr<const ForwardModel> about;  ///< ForwardModel::About
};

/// Measured rows, their weights and the model: everything a fit needs. Thread-safe for reading.
class FitProblem {
 public:
  /// Sets weights with the declared model.
  static Result<FitProblem> Create(std::shared_ptr<const ForwardModel> forward,
                                   const hydraulics::PhsParams& declared,
                                   const SearchRule& rule = {});
  /// The same on a clock of about `step_s`, for looking around.
  Result<FitProblem> Coarse(const hydraulics::PhsParams& declared, double step_s) const;

  const SearchRule& rule() const { return rule_; }
  const ForwardModel& forward() const { return *forward_; }
  const Likelihood& likelihood() const { return *likelihood_; }
  int num_rows() const { return num_rows_; }
  int num_blocks() const { return static_cast<int>(weight_.size()); }
  /// Channel of a block of the residual.
  const std::string& block_name(size_t block) const { return forward_->Measured()[block].channel; }
  const Block& block(size_t block) const { return likelihood_->blocks()[block]; }
  /// First block of a measured channel; -1 if it was not measured.
  int FindOutput(const std::string& name) const;

  hydraulics::PhsParams Params(const FreeModel& model, const std::vector<double>& values) const {
    return ParamsOf(model, values);
  }
  /// Weighted residual; empty if the model refuses the values.
  Eigen::VectorXd Residual(const FreeModel& model, const std::vector<double>& values) const;
  /// Residual and its derivative over the coordinates from `first` on; false if the model refuses
  /// the values, or when stopped.
  bool Linearise(const FreeModel& model, const std::vector<double>& values, int first,
                 Eigen::VectorXd* residual, Eigen::MatrixXd* jacobian) const;
  /// That derivative alone, about the known residual of `values`.
  bool CalcSlopes(const FreeModel& model, const std::vector<double>& values, int first,
                  const Eigen::VectorXd& residual, Eigen::MatrixXd* jacobian) const;
  /// 1/sigma of each row of the residual, 0 = missing.
  Eigen::VectorXd WeightOfRows() const;
  /// Values on the rows of a channel's blocks -> weighted, on all rows of the residual.
  Eigen::VectorXd Weighted(const std::string& channel, const Channels& on_rows) const;
  /// Asked before every run of the model: false = stop; every residual is empty from then on.
  void SetGoOn(std::function<bool()> go_on) { go_on_ = std::move(go_on); }
  /// Threads for ForEach and for the columns of Linearise; null: the calling one alone. Must
  /// outlive what is done with them.
  void SetThreads(ThreadBudget* threads) { threads_ = threads; }
  void ForEach(int n, const std::function<void(int)>& work) const;
  /// Weights with this model's sensitivity to what is uncertain of its motion.
  Result<Weighting> CalcWeights(const hydraulics::PhsParams& params) const;
  const SampleWeights& weights() const { return weight_; }
  void SetWeights(Weighting weighting);

 private:
  SearchRule rule_;
  std::shared_ptr<const ForwardModel> forward_;
  SampleWeights weight_;
  std::shared_ptr<const Likelihood> likelihood_;
  int num_rows_ = 0;
  std::function<bool()> go_on_;
  ThreadBudget* threads_ = nullptr;
};

}  // namespace phs::identify::search
