#include "rigs/step_problem.h"

#include <algorithm>
#include <cmath>

#include "phs_model/phs_model.h"

namespace phs::rigs {

using hydraulics::PhsParams;

int StepProblem::num_rows() const {
  size_t sum = 0;
  for (const StepRun& run : runs) sum += run.rows.size();
  return static_cast<int>(sum);
}

int StepProblem::num_free() const {
  int sum = 0;
  for (const StepNumber& n : numbers) sum += n.shared ? 1 : static_cast<int>(runs.size());
  return sum;
}

int StepProblem::Place(size_t k, size_t r) const {
  int place = 0;
  for (size_t i = 0; i < k; ++i) place += numbers[i].shared ? 1 : static_cast<int>(runs.size());
  return place + (numbers[k].shared ? 0 : static_cast<int>(r));
}

std::vector<StepRow> SettledRows(const std::vector<StepRow>& rows) {
  std::vector<StepRow> out;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(out),
               [](const StepRow& row) { return row.end_Pa > 0; });
  return out;
}

namespace {

/// Value of a number in a declared model; of a diaphragm's stop that is not declared, its start.
Result<double> Declared(const PhsParams& params, const StepNumber& number) {
  Result<double> value = phs_model::GetParameter(params, number.name);
  if (!value.ok() || value.value() > 0) return value;
  const std::string line = number.name.substr(0, number.name.find('.'));
  const int at = line == "lines" ? 0 : params.FindLine(line);
  if (number.start > 0 && at >= 0) return number.start * params.lines[at].gas_volume_m3;
  return Error{params.name + ": " + number.name, "is 0 in the declared model", "above 0",
               "a number is fitted by its logarithm; leave it out of free:"};
}

}  // namespace

Result<Eigen::VectorXd> DeclaredLogs(const StepProblem& problem) {
  Eigen::VectorXd logs = Eigen::VectorXd::Zero(problem.num_free());
  const double runs = static_cast<double>(problem.runs.size());
  for (size_t k = 0; k < problem.numbers.size(); ++k) {
    for (size_t r = 0; r < problem.runs.size(); ++r) {
      Result<double> value = Declared(problem.runs[r].declared, problem.numbers[k]);
      if (!value.ok()) return value.error();
      logs[problem.Place(k, r)] +=
          std::log(value.value()) / (problem.numbers[k].shared ? runs : 1.0);
    }
  }
  return logs;
}

Result<PhsParams> ModelOf(const StepProblem& problem, const Eigen::VectorXd& logs, size_t r) {
  PhsParams out = problem.runs[r].declared;
  for (size_t k = 0; k < problem.numbers.size(); ++k) {
    const double value = std::exp(logs[problem.Place(k, r)]);
    Status s = phs_model::SetParameter(&out, problem.numbers[k].name, value);
    if (!s.ok()) return s.error();
  }
  // A diaphragm cannot rest on its stop with more gas than there is.
  for (hydraulics::LineParams& l : out.lines) {
    l.reservoir.min_gas_volume_m3 =
        std::min(l.reservoir.min_gas_volume_m3, 0.999 * l.gas_volume_m3);
  }
  return out;
}

StepProblem WithoutStep(const StepProblem& problem, size_t r, double actuator_step_m) {
  StepProblem out = problem;
  std::erase_if(out.runs[r].rows,
                [=](const StepRow& row) { return row.actuator_step_m == actuator_step_m; });
  return out;
}

}  // namespace phs::rigs
