#include "rigs/step_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace phs::rigs {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using hydraulics::kAtmosphere;

constexpr double kPriorWidth = 1.0986122886681098;  // ln 3
constexpr double kConverged = 1e-6;                 // step of the logarithms
constexpr double kPriorWeight = 1 / (kPriorWidth * kPriorWidth);

/// ln(p_model/p_measured) of the rows of run `r`.
Result<Vector> RunResiduals(const StepProblem& problem, const Vector& q, size_t r) {
  const std::vector<StepRow>& rows = problem.runs[r].rows;
  Result<hydraulics::PhsParams> model = ModelOf(problem, q, r);
  if (!model.ok()) return model.error();
  Result<std::vector<double>> p = PredictSettled(model.value(), rows);
  if (!p.ok()) return p.error();
  Vector out(static_cast<int>(rows.size()));
  for (size_t i = 0; i < rows.size(); ++i) {
    out[static_cast<int>(i)] =
        std::log((p.value()[i] + kAtmosphere) / (rows[i].end_Pa + kAtmosphere));
  }
  return out;
}

Result<Vector> Residuals(const StepProblem& problem, const Vector& q) {
  Vector out(problem.num_rows());
  int at = 0;
  for (size_t r = 0; r < problem.runs.size(); ++r) {
    Result<Vector> part = RunResiduals(problem, q, r);
    if (!part.ok()) return part.error();
    out.segment(at, part.value().size()) = part.value();
    at += static_cast<int>(part.value().size());
  }
  return out;
}

/// dr/dq by differences; a number moves only the rows of its own runs.
Result<Matrix> Jacobian(const StepProblem& problem, const Vector& q, const Vector& residuals) {
  constexpr double kNudge = 1e-5;
  Matrix J = Matrix::Zero(residuals.size(), q.size());
  int at = 0;
  for (size_t r = 0; r < problem.runs.size(); ++r) {
    const int n = static_cast<int>(problem.runs[r].rows.size());
    for (size_t k = 0; k < problem.numbers.size(); ++k) {
      const int place = problem.Place(k, r);
      Vector nudged = q;
      nudged[place] += kNudge;
      Result<Vector> moved = RunResiduals(problem, nudged, r);
      if (!moved.ok()) return moved.error();
      J.block(at, place, n, 1) = (moved.value() - residuals.segment(at, n)) / kNudge;
    }
    at += n;
  }
  return J;
}

/// 1/variance of every row.
Vector Weights(const StepProblem& problem, const StepErrors& errors) {
  Vector out(problem.num_rows());
  int at = 0;
  for (const StepRun& run : problem.runs) {
    for (const StepRow& row : run.rows) {
      const double reading = errors.reading_Pa / (row.end_Pa + kAtmosphere);
      out[at++] = 1 / (errors.model * errors.model + reading * reading);
    }
  }
  return out;
}

/// The fit at given sizes of the errors.
class NumbersFit {
 public:
  NumbersFit(const StepProblem& problem, const Vector& declared, const StepErrors& errors)
      : problem_(problem), declared_(declared), weights_(Weights(problem, errors)) {}

  /// Levenberg-Marquardt from `fit->logs`.
  Status Run(StepFit* fit) const {
    Result<Vector> start = Residuals(problem_, fit->logs);
    if (!start.ok()) return start.error();
    Vector r = std::move(start.value());
    Matrix normal;
    double damping = 1e-3;
    for (int iteration = 0; iteration < 60; ++iteration) {
      Result<Matrix> J = Jacobian(problem_, fit->logs, r);
      if (!J.ok()) return J.error();
      const Matrix WJ = weights_.asDiagonal() * J.value();
      normal = J.value().transpose() * WJ;
      normal.diagonal().array() += kPriorWeight;
      const Vector slope = WJ.transpose() * r + kPriorWeight * (fit->logs - declared_);
      if (Move(normal, slope, &damping, &fit->logs, &r) < kConverged) break;
    }
    const Eigen::LDLT<Matrix> inverse(normal);
    fit->sd = inverse.solve(Matrix::Identity(normal.rows(), normal.cols())).diagonal().cwiseSqrt();
    fit->criterion =
        Cost(r, fit->logs) - weights_.array().log().sum() + inverse.vectorD().array().log().sum();
    return {};
  }

 private:
  double Cost(const Vector& r, const Vector& q) const {
    return (r.array().square() * weights_.array()).sum() +
           kPriorWeight * (q - declared_).squaredNorm();
  }
  /// One step that lowers the cost; its length, 0 if none does.
  double Move(const Matrix& normal, const Vector& slope, double* damping, Vector* q,
              Vector* r) const {
    const double now = Cost(*r, *q);
    for (int attempt = 0; attempt < 12; ++attempt) {
      Matrix damped = normal;
      damped.diagonal() *= 1 + *damping;
      Vector step = -damped.ldlt().solve(slope);
      step = step.cwiseMax(-0.5).cwiseMin(0.5).eval();
      if (step.norm() < kConverged) return 0;
      Result<Vector> next = Residuals(problem_, *q + step);
      if (next.ok() && Cost(next.value(), *q + step) < now) {
        *damping = std::max(*damping / 4, 1e-9);
        *q += step;
        *r = std::move(next.value());
        return step.norm();
      }
      *damping *= 4;
    }
    return 0;
  }

  const StepProblem& problem_;
  const Vector& declared_;
  Vector weights_;
};

struct ErrorSize {
  double StepErrors::*of;
  double least, most;
};
constexpr ErrorSize kErrorSizes[] = {{&StepErrors::model, 1e-3, 1},
                                     {&StepErrors::reading_Pa, 1e3, 1e6}};

/// Pattern search for the sizes of the errors, from steps of `first` in their logarithms; the
/// numbers follow.
Status FitSizes(const StepProblem& problem, const Vector& declared, double first, StepFit* fit) {
  if (Status s = NumbersFit(problem, declared, fit->errors).Run(fit); !s.ok()) return s;
  for (double step = first; step > 0.05;) {
    bool moved = false;
    for (const ErrorSize& size : kErrorSizes) {
      for (const double factor : {std::exp(step), std::exp(-step)}) {
        StepFit tried = *fit;
        double& value = tried.errors.*size.of;
        value = std::clamp(value * factor, size.least, size.most);
        if (Status s = NumbersFit(problem, declared, tried.errors).Run(&tried); !s.ok()) return s;
        if (!(tried.criterion < fit->criterion - 1e-3)) continue;
        *fit = std::move(tried);
        moved = true;
        break;
      }
    }
    if (!moved) step /= 2;
  }
  return {};
}

Status CheckCounts(const StepProblem& problem) {
  if (problem.num_rows() >= problem.num_free()) return {};
  std::string names;
  for (const StepNumber& n : problem.numbers) names += (names.empty() ? "" : ", ") + n.name;
  return Error{"steps",
               std::to_string(problem.num_free()) + " numbers (" + names + ") for " +
                   std::to_string(problem.num_rows()) + " settled pressures",
               "at least as many pressures as numbers, also where one step is left out",
               "join the setup with others (runs:, shared:) or name fewer numbers (free:)"};
}

}  // namespace

Result<StepFit> FitSteps(const StepProblem& problem, const StepFit* near) {
  if (problem.go_on && !problem.go_on()) return Error{"fit of steps", "was stopped", "", ""};
  if (Status s = CheckCounts(problem); !s.ok()) return s.error();
  Result<Vector> declared = DeclaredLogs(problem);
  if (!declared.ok()) return declared.error();
  StepFit fit;
  fit.logs = declared.value();
  if (near != nullptr) fit = *near;
  const double first = near != nullptr ? std::log(2) / 4 : std::log(2);
  if (Status s = FitSizes(problem, declared.value(), first, &fit); !s.ok()) return s.error();
  return fit;
}

}  // namespace phs::rigs
