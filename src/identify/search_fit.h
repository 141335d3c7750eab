// Fit of a rig model's numbers to measured channels.
//
// Minimised: sum over channels c and samples i of the estimation window of
//   w_ci² (y_ci - model_ci(theta))²,   1/w_ci² = noise_c² + u_ci²
// u is the model's own uncertainty (forward_model.h): of a rig, what the remaining uncertainty of
// the driving motion does to the output. Each number is fitted as its logarithm (wide
// positive range) or on a linear scale, inside bounds; Ceres, Levenberg–Marquardt, numeric
// derivatives.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "identify/forward_model.h"
#include "identify/thread_budget.h"
#include "measurement/fit_data.h"

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

struct FitResult {
  std::vector<double> values;      ///< of the free parameters
  std::vector<double> half_95;     ///< half width of the 95 % interval, in coordinates
  Eigen::VectorXd residual;        ///< weighted, channels one after the other
  Eigen::MatrixXd jacobian;        ///< of `residual` over coordinates
  std::vector<double> channel_ms;  ///< weighted mean square per channel
  int runs = 0;
  bool ok = false;
};

using SampleWeights = std::vector<std::vector<double>>;  ///< [channel][row], 0 = missing

/// Data, driving motion and weights: everything a fit needs. Thread-safe for reading.
class FitProblem {
 public:
  /// Sets weights with the declared model. `data` must outlive the problem. `stride` > 1: a coarse
  /// problem that steps over the record in strides of so many samples (for looking around).
  static Result<FitProblem> Create(const measurement::FitData& data,
                                   const hydraulics::PhsParams& declared, int stride = 1);
  /// The same with another model than a rig.
  static Result<FitProblem> Create(const measurement::FitData& data,
                                   std::shared_ptr<const ForwardModel> forward,
                                   const hydraulics::PhsParams& declared, int stride = 1);
  /// The coarse problem of this one.
  Result<FitProblem> Thinned(const hydraulics::PhsParams& declared, int stride) const;

  int num_channels() const { return static_cast<int>(data_->outputs.size()); }
  const ForwardModel& forward() const { return *forward_; }
  int samples() const { return static_cast<int>(rows_.size()); }
  const measurement::FitData& data() const { return *data_; }

  hydraulics::PhsParams Params(const FreeModel& model, const std::vector<double>& values) const;
  /// Weighted residual; empty if the model refuses the values.
  Eigen::VectorXd Residual(const FreeModel& model, const std::vector<double>& values) const;
  /// Residual and its derivative over the coordinates from `first` on.
  bool Linearise(const FreeModel& model, const std::vector<double>& values, int first,
                 Eigen::VectorXd* residual, Eigen::MatrixXd* jacobian) const;
  FitResult Fit(const FreeModel& model, const std::vector<double>& start, int max_steps) const;
  /// Measured channels as predicted on the whole time axis.
  Result<std::vector<std::vector<double>>> Predict(const hydraulics::PhsParams& params) const;
  /// Residual of whole-record predictions over noise and the model's own uncertainty, root mean
  /// square per channel over a window [s].
  Result<std::vector<double>> OverNoise(const hydraulics::PhsParams& params,
                                        const std::vector<std::vector<double>>& predicted,
                                        const std::array<double, 2>& window) const;
  /// Index of a measured output; -1 if it was not measured.
  int FindOutput(const std::string& name) const;
  /// What a force of the (first) cylinder may depend on, on the rows of the residual, as the model
  /// says it; direction by the ramp of the static law.
  Result<std::vector<hydraulics::ForcePlace>> Places(const hydraulics::PhsParams& params) const;
  /// A value of an output on the rows of the residual -> weighted; 0 where nothing was measured.
  Eigen::VectorXd Weighted(int output, const std::vector<double>& on_rows) const;
  /// Asked before every run of the model: false = stop; every residual is empty from then on.
  void SetGoOn(std::function<bool()> go_on) { go_on_ = std::move(go_on); }
  /// Threads for ForEach and for the columns of Linearise; null: the calling one alone. Must
  /// outlive what is done with them.
  void SetThreads(ThreadBudget* threads) { threads_ = threads; }
  void ForEach(int n, const std::function<void(int)>& work) const;
  /// Weights with this model's sensitivity to what is uncertain of its motion.
  Result<SampleWeights> CalcWeights(const hydraulics::PhsParams& params) const;
  const SampleWeights& weights() const { return weight_; }
  void SetWeights(SampleWeights weights) { weight_ = std::move(weights); }

 private:
  const measurement::FitData* data_ = nullptr;
  int stride_ = 1;
  std::shared_ptr<const ForwardModel> forward_;
  std::vector<int> rows_;  ///< rows of the estimation span in its window
  SampleWeights weight_;
  std::function<bool()> go_on_;
  ThreadBudget* threads_ = nullptr;
};

}  // namespace phs::identify::search
