#include "identify/fit/search_fit.h"

#include <algorithm>
#include <cmath>

#include "identify/fit/acceptance.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

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

/// A difference between runs, weighted, on the rows of a residual.
Eigen::VectorXd OnResidual(const SampleWeights& weight, const Channels& difference) {
  std::vector<double> rows;
  for (size_t b = 0; b < weight.size(); ++b) {
    for (size_t k = 0; k < weight[b].size(); ++k) rows.push_back(weight[b][k] * difference[b][k]);
  }
  return Eigen::Map<const Eigen::VectorXd>(rows.data(), static_cast<Eigen::Index>(rows.size()));
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

Result<FitProblem> FitProblem::Create(std::shared_ptr<const ForwardModel> forward,
                                      const PhsParams& declared, const SearchRule& rule) {
  FitProblem problem;
  problem.rule_ = rule;
  problem.forward_ = std::move(forward);
  Result<Weighting> weighting = problem.CalcWeights(declared);
  if (!weighting.ok()) return weighting.error();
  problem.SetWeights(std::move(weighting.value()));
  return problem;
}

void FitProblem::SetWeights(Weighting weighting) {
  if (weighting.about != nullptr) forward_ = std::move(weighting.about);
  weight_ = std::move(weighting.sample);
  std::vector<Block> blocks;
  num_rows_ = 0;
  for (const std::vector<double>& w : weight_) {
    const auto there = std::count_if(w.begin(), w.end(), [](double x) { return x > 0; });
    const auto rows = static_cast<int>(w.size());
    blocks.push_back({num_rows_, rows, static_cast<double>(there) / std::max(rows, 1)});
    num_rows_ += rows;
  }
  likelihood_ = std::make_shared<const Likelihood>(std::move(blocks), rule_.accept.noise_known,
                                                   weighting.theories, weighting.inputs);
}

Result<FitProblem> FitProblem::Coarse(const PhsParams& declared, double step_s) const {
  return Create(forward_->Coarse(step_s), declared, rule_);
}

void FitProblem::ForEach(int n, const std::function<void(int)>& work) const {
  if (threads_ != nullptr) return threads_->ForEach(n, work);
  for (int i = 0; i < n; ++i) work(i);
}

Result<Weighting> FitProblem::CalcWeights(const PhsParams& params) const {
  Channels uncertain;
  const Status done = forward_->Uncertainty(params, ForwardModel::Span::kEstimation, &uncertain);
  if (!done.ok()) return done.error();
  Weighting out;
  for (size_t b = 0; b < uncertain.size(); ++b) {
    const MeasuredBlock& block = forward_->Measured()[b];
    std::vector<double>& row = out.sample.emplace_back(block.values.size(), 0.0);
    for (size_t k = 0; k < row.size(); ++k) {
      if (std::isfinite(block.values[k])) row[k] = 1 / std::hypot(block.noise, uncertain[b][k]);
    }
  }
  std::vector<Channels> differences;
  const Status known =
      forward_->TheoryDifferences(params, ForwardModel::Span::kEstimation, &differences);
  if (!known.ok()) return known.error();
  for (const Channels& difference : differences) {
    out.theories.push_back(OnResidual(out.sample, difference));
  }
  const Status drawn = forward_->InputErrors(params, ForwardModel::Span::kEstimation, &differences);
  if (!drawn.ok()) return drawn.error();
  for (const Channels& error : differences) out.inputs.push_back(OnResidual(out.sample, error));
  out.about = forward_->About(params);
  return out;
}

int FitProblem::FindOutput(const std::string& name) const {
  for (size_t b = 0; b < forward_->Measured().size(); ++b) {
    if (block_name(b) == name) return static_cast<int>(b);
  }
  return -1;
}

Eigen::VectorXd FitProblem::WeightOfRows() const {
  Eigen::VectorXd out(num_rows_);
  for (size_t b = 0; b < weight_.size(); ++b) {
    out.segment(block(b).begin, block(b).count) =
        Eigen::Map<const Eigen::VectorXd>(weight_[b].data(), block(b).count);
  }
  return out;
}

Eigen::VectorXd FitProblem::Weighted(const std::string& channel, const Channels& on_rows) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(num_rows_);
  size_t next = 0;
  for (size_t b = 0; b < weight_.size() && next < on_rows.size(); ++b) {
    if (block_name(b) != channel) continue;
    const std::vector<double>& values = on_rows[next++];
    for (size_t k = 0; k < values.size(); ++k) {
      out[block(b).begin + static_cast<int>(k)] = weight_[b][k] * values[k];
    }
  }
  return out;
}

PhsParams ParamsOf(const FreeModel& model, const std::vector<double>& values) {
  PhsParams params = model.params;
  for (size_t i = 0; i < model.free.size(); ++i) {
    PHS_CHECK(phs_model::SetParameter(&params, model.free[i].name, values[i]).ok());
  }
  return params;
}

FreeModel WithHeld(const FreeModel& model, size_t held, double value) {
  FreeModel out = model;
  out.params = ParamsOf({model.params, {model.free[held]}}, {value});
  out.free.erase(out.free.begin() + static_cast<long>(held));
  return out;
}

Eigen::VectorXd FitProblem::Residual(const FreeModel& model,
                                     const std::vector<double>& values) const {
  if (go_on_ && !go_on_()) return {};
  Channels predicted;
  if (!forward_->Run(Params(model, values), ForwardModel::Span::kEstimation, &predicted).ok()) {
    return {};
  }
  Eigen::VectorXd out(num_rows_);
  for (size_t b = 0; b < weight_.size(); ++b) {
    const std::vector<double>& measured = forward_->Measured()[b].values;
    for (size_t k = 0; k < measured.size(); ++k) {
      const double w = weight_[b][k];
      out[block(b).begin + static_cast<int>(k)] = w > 0 ? w * (measured[k] - predicted[b][k]) : 0.0;
    }
  }
  if (!out.allFinite()) return {};
  return out;
}

bool FitProblem::Linearise(const FreeModel& model, const std::vector<double>& values, int first,
                           Eigen::VectorXd* residual, Eigen::MatrixXd* jacobian) const {
  *residual = Residual(model, values);
  return residual->size() > 0 && CalcSlopes(model, values, first, *residual, jacobian);
}

bool FitProblem::CalcSlopes(const FreeModel& model, const std::vector<double>& values, int first,
                            const Eigen::VectorXd& residual, Eigen::MatrixXd* jacobian) const {
  const int count = static_cast<int>(model.free.size());
  jacobian->resize(residual.size(), count - first);
  ForEach(count - first, [&](int column) {
    const size_t j = static_cast<size_t>(first) + static_cast<size_t>(column);
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
      jacobian->col(column) = (r - residual) / really;
    }
  });
  return !go_on_ || go_on_();
}

}  // namespace phs::identify::search
