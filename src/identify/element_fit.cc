#include "identify/element_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "identify/fit_intervals.h"
#include "identify/least_squares.h"
#include "measurement/series.h"
#include "phs_model/phs_model.h"

namespace phs::identify::element {

using hydraulics::PhsParams;
using rigs::RigKind;
using rigs::RigModel;
using rigs::RigPrediction;

namespace {

constexpr double kOutlier = 4;  // levels of the residual beyond which rows count less

Result<std::vector<double>> RunMotion(const RigModel& model, const rigs::RigMotion& motion) {
  RigPrediction prediction;
  if (Status s = model.Run(motion, &prediction); !s.ok()) return s.error();
  return std::move(prediction.channels[0]);
}

/// The motion up to the last fitted row and as far beyond as the band's filter looks.
rigs::RigMotion FittedPart(const ElementRecord& record) {
  rigs::RigMotion motion = record.motion;
  size_t rows = record.fitted.size();
  while (rows > 0 && !record.fitted[rows - 1]) --rows;
  if (rows == 0) return motion;
  const size_t need =
      static_cast<size_t>(record.row_sample[rows - 1] + 1 + 12 * record.band.spread());
  const size_t keep = std::clamp(need, size_t{2}, motion.position_m[0].size());
  for (auto* signal :
       {&motion.position_m[0], &motion.speed_m_s[0], &motion.pressure_Pa, &motion.temperature_K}) {
    if (signal->size() > keep) signal->resize(keep);
  }
  return motion;
}

}  // namespace

Result<ElementProblem> ElementProblem::Create(const ElementData& data, const PhsParams& declared) {
  ElementProblem problem;
  problem.data_ = &data;
  for (const ElementRecord& r : data.records) {
    problem.fitted_motion_.push_back(FittedPart(r));
    problem.first_row_.push_back(problem.num_rows_);
    problem.num_rows_ += static_cast<int>(std::count(r.fitted.begin(), r.fitted.end(), 1));
  }
  problem.first_row_.push_back(problem.num_rows_);
  if (Status s = problem.SetWeights(declared, std::max(data.noise_N, 1e-9)); !s.ok()) {
    return s.error();
  }
  return problem;
}

PhsParams ElementProblem::Params(const FreeModel& model, const std::vector<double>& values) const {
  PhsParams params = model.params;
  for (size_t i = 0; i < model.free.size(); ++i) {
    PHS_CHECK(phs_model::SetParameter(&params, model.free[i].name, values[i]).ok());
  }
  return params;
}

Status ElementProblem::SetWeights(const PhsParams& params, double scale_N) {
  Result<RigModel> model = RigModel::Create(RigKind::kElement, params);
  if (!model.ok()) return model.status();
  weight_.assign(static_cast<size_t>(num_rows_), 0.0);
  size_t row = 0;
  for (const ElementRecord& record : data_->records) {
    std::vector<double> speed[2] = {record.motion.speed_m_s[0], record.motion.speed_m_s[0]};
    for (size_t i = 0; i < speed[0].size(); ++i) {
      speed[0][i] += record.speed_deviation[i], speed[1][i] -= record.speed_deviation[i];
    }
    rigs::RigMotion moved = record.motion;
    moved.speed_m_s[0] = speed[0];
    Result<std::vector<double>> fast = RunMotion(model.value(), moved);
    moved.speed_m_s[0] = speed[1];
    Result<std::vector<double>> slow = RunMotion(model.value(), moved);
    if (!fast.ok()) return fast.status();
    if (!slow.ok()) return slow.status();
    for (size_t i = 0; i < fast.value().size(); ++i) {
      fast.value()[i] = 0.5 * (fast.value()[i] - slow.value()[i]);
    }
    const std::vector<double> input = record.band.Apply(fast.value());
    for (size_t k = 0; k < record.row_sample.size(); ++k) {
      if (record.fitted[k]) weight_[row++] = 1 / std::hypot(scale_N, input[k]);
    }
  }
  return {};
}

Result<std::vector<double>> ElementProblem::PredictRecord(const PhsParams& params,
                                                          size_t record) const {
  Result<RigModel> model = RigModel::Create(RigKind::kElement, params);
  if (!model.ok()) return model.error();
  return RunMotion(model.value(), data_->records[record].motion);
}

Result<std::vector<std::vector<double>>> ElementProblem::Predict(const PhsParams& params) const {
  std::vector<std::vector<double>> out;
  for (size_t r = 0; r < data_->records.size(); ++r) {
    Result<std::vector<double>> full = PredictRecord(params, r);
    if (!full.ok()) return full.error();
    out.push_back(data_->records[r].band.Apply(full.value()));
  }
  return out;
}

Eigen::VectorXd ElementProblem::Column(const std::vector<std::vector<double>>& full) const {
  Eigen::VectorXd out(num_rows_);
  Eigen::Index row = 0;
  for (size_t r = 0; r < full.size(); ++r) {
    const ElementRecord& record = data_->records[r];
    if (first_row_[r] == first_row_[r + 1]) continue;
    const std::vector<double> rows = record.band.Apply(full[r]);
    for (size_t k = 0; k < rows.size(); ++k) {
      if (!record.fitted[k]) continue;
      out[row] = rows[k] * weight_[static_cast<size_t>(row)];
      ++row;
    }
  }
  return out;
}

bool ElementProblem::Evaluate(const FreeModel& model, const std::vector<double>& values,
                              Eigen::VectorXd* residual, Eigen::MatrixXd* jacobian,
                              int first) const {
  const auto predicted = [&](const std::vector<double>& at, Eigen::VectorXd* out) {
    Result<RigModel> rig = RigModel::Create(RigKind::kElement, Params(model, at));
    if (!rig.ok()) return false;
    out->resize(num_rows_);
    Eigen::Index row = 0;
    for (size_t r = 0; r < data_->records.size(); ++r) {
      if (first_row_[r] == first_row_[r + 1]) continue;
      const ElementRecord& record = data_->records[r];
      Result<std::vector<double>> full = RunMotion(rig.value(), fitted_motion_[r]);
      if (!full.ok()) return false;
      const std::vector<double> rows = record.band.Apply(full.value());
      for (size_t k = 0; k < rows.size(); ++k) {
        if (!record.fitted[k]) continue;
        (*out)[row] = weight_[static_cast<size_t>(row)] * (record.row_force_N[k] - rows[k]);
        ++row;
      }
    }
    return out->allFinite();
  };
  if (!predicted(values, residual)) return false;
  if (jacobian == nullptr) return true;
  const int count = static_cast<int>(model.free.size());
  jacobian->resize(num_rows_, count - first);
  for (int j = first; j < count; ++j) {
    const FreeParameter& p = model.free[static_cast<size_t>(j)];
    const double at = p.ToCoordinate(values[static_cast<size_t>(j)]);
    double step = 3e-3;
    if (p.FromCoordinate(at + step) >= p.high) step = -step;
    std::vector<double> moved = values;
    moved[static_cast<size_t>(j)] = p.FromCoordinate(at + step);
    const double really = p.ToCoordinate(moved[static_cast<size_t>(j)]) - at;
    Eigen::VectorXd r;
    if (really == 0 || !predicted(moved, &r)) {
      jacobian->col(j - first).setZero();
    } else {
      jacobian->col(j - first) = (r - *residual) / really;
    }
  }
  return true;
}

double ElementProblem::Independent(const Eigen::VectorXd& residual) const {
  double sum = 0;
  for (size_t r = 0; r + 1 < first_row_.size(); ++r) {
    const int count = first_row_[r + 1] - first_row_[r];
    if (count > 0) sum += search::EffectiveSamples(residual, first_row_[r], count);
  }
  return sum;
}

/// Rows in blocks that disagree with each other as records do: whole records where there are many,
/// else stretches of them.
std::vector<int> ElementProblem::Blocks(int* count) const {
  const int records = static_cast<int>(first_row_.size()) - 1;
  const int parts = std::max(1, (30 + records - 1) / std::max(1, records));
  std::vector<int> out(static_cast<size_t>(num_rows_), 0);
  *count = 0;
  for (int r = 0; r < records; ++r) {
    const long begin = first_row_[static_cast<size_t>(r)];
    const long rows = first_row_[static_cast<size_t>(r) + 1] - begin;
    if (rows == 0) continue;
    for (long k = 0; k < rows; ++k) {
      out[static_cast<size_t>(begin + k)] = *count + static_cast<int>(k * parts / rows);
    }
    *count += parts;
  }
  return out;
}

ElementFit ElementProblem::Fit(const FreeModel& model, const std::vector<double>& start,
                               int max_steps) const {
  ElementFit fit;
  LeastSquaresProblem problem;
  problem.num_residuals = num_rows_;
  problem.max_steps = max_steps;
  problem.loss_width = kOutlier;
  std::vector<double> x;
  for (size_t i = 0; i < model.free.size(); ++i) {
    const FreeParameter& p = model.free[i];
    x.push_back(p.ToCoordinate(start[i]));
    problem.low.push_back(p.ToCoordinate(p.low));
    problem.high.push_back(p.ToCoordinate(p.high));
  }
  const auto values = [&](const std::vector<double>& at) {
    std::vector<double> out;
    for (size_t i = 0; i < at.size(); ++i) out.push_back(model.free[i].FromCoordinate(at[i]));
    return out;
  };
  problem.evaluate = [&](const std::vector<double>& at, Eigen::VectorXd* r, Eigen::MatrixXd* j) {
    return Evaluate(model, values(at), r, j);
  };
  if (!SolveLeastSquares(problem, &x)) return fit;
  fit.values = values(x);
  if (!Evaluate(model, fit.values, &fit.residual, &fit.jacobian)) return fit;
  fit.mean_square = fit.residual.squaredNorm() / num_rows_;
  fit.independent = Independent(fit.residual);
  const auto count = fit.jacobian.cols();
  Eigen::MatrixXd normal = fit.jacobian.transpose() * fit.jacobian;
  normal.diagonal().array() += 1e-12 * (normal.trace() + 1e-300);
  const Eigen::MatrixXd inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  const double inflate = fit.mean_square * num_rows_ / std::max(1.0, fit.independent);
  double quantile = 0;
  int blocks = 0;
  const std::vector<int> block = Blocks(&blocks);
  const Eigen::VectorXd clustered =
      search::ClusteredDeviation(fit.jacobian, fit.residual, block, blocks, &quantile);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double even = 1.96 * std::sqrt(std::max(0.0, inverse(i, i) * inflate));
    fit.half_95.push_back(clustered.size() > 0 ? std::max(even, quantile * clustered[i]) : even);
  }
  fit.ok = true;
  return fit;
}

}  // namespace phs::identify::element
