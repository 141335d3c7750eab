#include "identify/search_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

#include "identify/fit_intervals.h"
#include "identify/rig_forward.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

using measurement::FitData;
using measurement::MeasuredChannel;

using hydraulics::PhsParams;

double FreeParameter::ToCoordinate(double value) const {
  const double inside = std::clamp(value, low, high);
  return logarithmic ? std::log(inside) : inside / scale;
}

double FreeParameter::FromCoordinate(double coordinate) const {
  const double value = logarithmic ? std::exp(coordinate) : coordinate * scale;
  return std::clamp(value, low, high);
}

namespace {

std::vector<std::string> UsuallyFree(const PhsParams& declared) {
  std::vector<std::string> names;
  for (const auto& line : declared.lines) {
    names.push_back(line.name + ".oil_volume_m3");
    if (line.gas_volume_m3 > 0) names.push_back(line.name + ".gas_volume_m3");
    if (line.free_air_m3 > 0) names.push_back(line.name + ".free_air_m3");
  }
  if (declared.friction.model != hydraulics::FrictionModel::kNone) {
    names.emplace_back("friction.scale");
  }
  return names;
}

}  // namespace

FreeModel DeclaredModel(const PhsParams& declared, std::vector<std::string> names) {
  if (names.empty()) names = UsuallyFree(declared);
  FreeModel model{declared, {}};
  for (const std::string& name : names) {
    const double value = phs_model::GetParameter(declared, name).value();
    model.free.push_back({name, value, 0.4 * value, 2.5 * value, true, 1});
  }
  return model;
}

Status CheckFree(const PhsParams& declared, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (auto value = phs_model::GetParameter(declared, name); !value.ok()) {
      Error e = value.error();
      return Error{"free: " + name, e.what, e.allowed, e.mend};
    } else if (!(value.value() > 0)) {
      return Error{"free: " + name, "is not positive in the declared model", "numbers > 0", ""};
    }
  }
  return {};
}

Result<FitProblem> FitProblem::Create(const FitData& data, const PhsParams& declared, int stride) {
  auto rig = RigForward::Create(data, declared, stride);
  if (!rig.ok()) return rig.error();
  return Create(data, rig.value(), declared, stride);
}

Result<FitProblem> FitProblem::Create(const FitData& data,
                                      std::shared_ptr<const ForwardModel> forward,
                                      const PhsParams& declared, int stride) {
  FitProblem problem;
  problem.data_ = &data;
  problem.stride_ = stride;
  problem.forward_ = std::move(forward);
  for (size_t k = 0; k * stride < data.time_s.size(); ++k) {
    const double t = data.time_s[k * stride];
    if (t >= data.estimation[1]) break;
    if (t >= data.estimation[0]) problem.rows_.push_back(static_cast<int>(k));
  }
  Result<SampleWeights> weights = problem.CalcWeights(declared);
  if (!weights.ok()) return weights.error();
  problem.weight_ = std::move(weights.value());
  return problem;
}

Result<FitProblem> FitProblem::Thinned(const PhsParams& declared, int stride) const {
  return Create(*data_, forward_->Thinned(stride), declared, stride);
}

void FitProblem::ForEach(int n, const std::function<void(int)>& work) const {
  if (threads_ != nullptr) return threads_->ForEach(n, work);
  for (int i = 0; i < n; ++i) work(i);
}

Result<SampleWeights> FitProblem::CalcWeights(const PhsParams& params) const {
  Channels uncertain;
  if (Status s = forward_->Uncertainty(params, ForwardModel::Span::kEstimation, &uncertain);
      !s.ok()) {
    return s.error();
  }
  SampleWeights weight(data_->outputs.size(), std::vector<double>(rows_.size(), 0.0));
  for (size_t c = 0; c < weight.size(); ++c) {
    const MeasuredChannel& channel = data_->outputs[c];
    for (size_t k = 0; k < rows_.size(); ++k) {
      const auto i = static_cast<size_t>(rows_[k]);
      if (!std::isfinite(channel.values[i * stride_])) continue;
      weight[c][k] = 1 / std::hypot(channel.noise, uncertain[c][i]);
    }
  }
  return weight;
}

Result<std::vector<double>> FitProblem::OverNoise(const PhsParams& params,
                                                  const Channels& predicted,
                                                  const std::array<double, 2>& window) const {
  Channels uncertain;
  const Status s = forward_->Uncertainty(params, ForwardModel::Span::kWhole, &uncertain);
  if (!s.ok()) return s.error();
  std::vector<double> out;
  for (size_t c = 0; c < data_->outputs.size(); ++c) {
    const MeasuredChannel& channel = data_->outputs[c];
    double sum = 0, count = 0;
    for (size_t i = 0; i < data_->time_s.size(); ++i) {
      const double t = data_->time_s[i], r = channel.values[i] - predicted[c][i];
      if (t < window[0] || t >= window[1] || !std::isfinite(r)) continue;
      sum += std::pow(r / std::hypot(channel.noise, uncertain[c][i]), 2), ++count;
    }
    out.push_back(std::sqrt(sum / std::max(count, 1.0)));
  }
  return out;
}

int FitProblem::FindOutput(const std::string& name) const {
  for (size_t c = 0; c < data_->outputs.size(); ++c) {
    if (data_->outputs[c].name == name) return static_cast<int>(c);
  }
  return -1;
}

Result<std::vector<hydraulics::ForcePlace>> FitProblem::Places(const PhsParams& params) const {
  return forward_->Places(params, rows_);
}

Eigen::VectorXd FitProblem::Weighted(int output, const std::vector<double>& on_rows) const {
  Eigen::VectorXd out(samples());
  for (int k = 0; k < samples(); ++k) {
    const auto i = static_cast<size_t>(k);
    out[k] = weight_[static_cast<size_t>(output)][i] * on_rows[i];
  }
  return out;
}

PhsParams FitProblem::Params(const FreeModel& model, const std::vector<double>& values) const {
  PhsParams params = model.params;
  for (size_t i = 0; i < model.free.size(); ++i) {
    PHS_CHECK(phs_model::SetParameter(&params, model.free[i].name, values[i]).ok());
  }
  return params;
}

Eigen::VectorXd FitProblem::Residual(const FreeModel& model,
                                     const std::vector<double>& values) const {
  if (go_on_ && !go_on_()) return {};
  Channels predicted;
  if (!forward_->Run(Params(model, values), ForwardModel::Span::kEstimation, &predicted).ok()) {
    return {};
  }
  const int n = samples();
  Eigen::VectorXd out(n * num_channels());
  for (int c = 0; c < num_channels(); ++c) {
    const std::vector<double>& measured = data_->outputs[c].values;
    for (int k = 0; k < n; ++k) {
      const double w = weight_[c][k];
      out[c * n + k] = w > 0 ? w * (measured[rows_[k] * stride_] - predicted[c][rows_[k]]) : 0.0;
    }
  }
  if (!out.allFinite()) return {};
  return out;
}

bool FitProblem::Linearise(const FreeModel& model, const std::vector<double>& values, int first,
                           Eigen::VectorXd* residual, Eigen::MatrixXd* jacobian) const {
  *residual = Residual(model, values);
  if (residual->size() == 0) return false;
  const int count = static_cast<int>(model.free.size());
  jacobian->resize(residual->size(), count - first);
  ForEach(count - first, [&](int column) {
    const auto j = static_cast<size_t>(first + column);
    const FreeParameter& p = model.free[j];
    const double at = p.ToCoordinate(values[j]);
    double step = 1e-2;
    if (p.FromCoordinate(at + step) >= p.high) step = -step;
    std::vector<double> moved = values;
    moved[j] = p.FromCoordinate(at + step);
    const double really = p.ToCoordinate(moved[j]) - at;
    const Eigen::VectorXd r = Residual(model, moved);
    if (r.size() == 0 || really == 0) {
      jacobian->col(column).setZero();
    } else {
      jacobian->col(column) = (r - *residual) / really;
    }
  });
  return true;
}

namespace {

/// The problem as Ceres sees it: one block of coordinates.
class RigCost final : public ceres::CostFunction {
 public:
  RigCost(const FitProblem& problem, const FreeModel& model, int* runs)
      : problem_(problem), model_(model), runs_(runs) {
    set_num_residuals(problem.samples() * problem.num_channels());
    mutable_parameter_block_sizes()->push_back(static_cast<int>(model.free.size()));
  }
  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override {
    const size_t n = model_.free.size();
    std::vector<double> values(n);
    for (size_t i = 0; i < n; ++i) values[i] = model_.free[i].FromCoordinate(x[0][i]);
    Eigen::VectorXd r;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::MatrixXd j;
      *runs_ += static_cast<int>(n) + 1;
      if (!problem_.Linearise(model_, values, 0, &r, &j)) return false;
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobians[0], j.rows(), j.cols()) = j;
    } else {
      ++*runs_;
      r = problem_.Residual(model_, values);
      if (r.size() == 0) return false;
    }
    std::copy(r.data(), r.data() + r.size(), residuals);
    return true;
  }

 private:
  const FitProblem& problem_;
  const FreeModel& model_;
  int* runs_;
};

}  // namespace

FitResult FitProblem::Fit(const FreeModel& model, const std::vector<double>& start,
                          int max_steps) const {
  FitResult result;
  const int count = static_cast<int>(model.free.size());
  std::vector<double> x(model.free.size());
  ceres::Problem problem;
  problem.AddParameterBlock(x.data(), count);
  for (int i = 0; i < count; ++i) {
    const FreeParameter& p = model.free[i];
    x[i] = p.ToCoordinate(start[i]);
    problem.SetParameterLowerBound(x.data(), i, p.ToCoordinate(p.low));
    problem.SetParameterUpperBound(x.data(), i, p.ToCoordinate(p.high));
  }
  problem.AddResidualBlock(new RigCost(*this, model, &result.runs), nullptr, x.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = max_steps;
  options.function_tolerance = 1e-4;
  options.initial_trust_region_radius = 10;
  options.max_num_consecutive_invalid_steps = 8;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) return result;
  for (int i = 0; i < count; ++i) result.values.push_back(model.free[i].FromCoordinate(x[i]));
  result.ok = Linearise(model, result.values, 0, &result.residual, &result.jacobian);
  result.runs += count + 1;
  if (result.ok) SetIntervals(*this, &result);
  return result;
}

Result<Channels> FitProblem::Predict(const PhsParams& params) const {
  Channels out;
  if (Status s = forward_->Run(params, ForwardModel::Span::kWhole, &out); !s.ok()) return s.error();
  return out;
}

}  // namespace phs::identify::search
