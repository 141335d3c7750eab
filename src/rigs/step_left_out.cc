// Each step predicted from the others, and the errors of what is predicted.
#include <algorithm>
#include <cmath>
#include <set>

#include "rigs/step_fit.h"

namespace phs::rigs {

using hydraulics::kAtmosphere;

Result<std::vector<double>> SettledOf(const StepProblem& problem, const Eigen::VectorXd& logs,
                                      size_t r) {
  Result<hydraulics::PhsParams> model = ModelOf(problem, logs, r);
  if (!model.ok()) return model.error();
  return PredictSettled(model.value(), problem.runs[r].rows);
}

Result<StepComparison> CompareSteps(const StepProblem& problem) {
  StepComparison out;
  Result<StepFit> fit = FitSteps(problem);
  if (!fit.ok()) return fit.error();
  out.fit = std::move(fit.value());
  for (size_t r = 0; r < problem.runs.size(); ++r) {
    Result<std::vector<double>> declared =
        PredictSettled(problem.runs[r].declared, problem.runs[r].rows);
    if (!declared.ok()) return declared.error();
    Result<std::vector<double>> fitted = SettledOf(problem, out.fit.logs, r);
    if (!fitted.ok()) return fitted.error();
    out.declared_Pa.push_back(std::move(declared.value()));
    out.fitted_Pa.push_back(std::move(fitted.value()));
  }
  out.left_out_Pa = out.fitted_Pa;
  for (size_t r = 0; r < problem.runs.size(); ++r) {
    const std::vector<StepRow>& rows = problem.runs[r].rows;
    std::set<double> steps;
    for (const StepRow& row : rows) steps.insert(row.actuator_step_m);
    for (const double step : steps) {
      Result<StepFit> kept = FitSteps(WithoutStep(problem, r, step), &out.fit);
      if (!kept.ok()) return kept.error();
      Result<std::vector<double>> p = SettledOf(problem, kept.value().logs, r);
      if (!p.ok()) return p.error();
      for (size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].actuator_step_m == step) out.left_out_Pa[r][i] = p.value()[i];
      }
      out.without.push_back({r, step, std::move(kept.value())});
    }
  }
  return out;
}

std::vector<double> MeasuredSettled(const StepRun& run) {
  std::vector<double> out;
  for (const StepRow& row : run.rows) out.push_back(row.end_Pa);
  return out;
}

double MeanRelativeError(const StepProblem& problem,
                         const std::vector<std::vector<double>>& predicted_Pa) {
  double sum = 0;
  for (size_t r = 0; r < problem.runs.size(); ++r) {
    sum += MeanRelativeError(predicted_Pa[r], MeasuredSettled(problem.runs[r])) *
           static_cast<double>(problem.runs[r].rows.size());
  }
  return sum / std::max(problem.num_rows(), 1);
}

double MeanAbsolutePressureError(const std::vector<double>& predicted_Pa,
                                 const std::vector<double>& measured_Pa) {
  double sum = 0;
  for (size_t i = 0; i < measured_Pa.size(); ++i) {
    sum += std::abs(predicted_Pa[i] - measured_Pa[i]) / (measured_Pa[i] + kAtmosphere);
  }
  return measured_Pa.empty() ? 0 : sum / static_cast<double>(measured_Pa.size());
}

}  // namespace phs::rigs
