#include "validate/table_b1_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/data_path.h"
#include "phs_model/phs_model.h"

namespace phs::validate {
namespace {

using hydraulics::PhsParams;
using identify::StepSearch;
using rigs::StepRow;

class Rows {
 public:
  Rows(const StepSearch& s, Checks* checks) : s_(s), checks_(checks) {}

  void Near(const std::string& what, const std::string& unit, double ours, double reference,
            double tolerance, const std::string& source) {
    checks_->push_back(
        {{}, what, unit, ours, reference, tolerance, Claim::kNear, kThesis + source, {}});
  }
  /// Errors of a setup: as declared, and of the steps left out.
  void Errors(size_t r, double settled, double begin) {
    const rigs::StepRun& run = s_.problem.runs[r];
    const std::string name = "Table B-1, setup " + std::to_string(run.setup);
    const std::string source =
        "Table B-1; mean relative error of gauge pressures, each capped at 1";
    const std::vector<double> end = rigs::MeasuredSettled(run);
    Near(name + ", settled: error as declared", "-",
         rigs::MeanRelativeError(s_.after.declared_Pa[r], end), 0, 0.10, source);
    Near(name + ", settled: error of steps left out of the joint fit", "-",
         rigs::MeanRelativeError(s_.after.left_out_Pa[r], end), 0, settled, source);
    if (!s_.thermal[r].accepted) return;
    Near(name + ", just after the step: error of steps left out, gas with energy equation", "-",
         s_.thermal[r].error_thermal, 0, begin, source);
  }
  /// Pressure of one row, its step left out of every fit.
  void Row(int row, bool settled, double share) {
    for (size_t r = 0; r < s_.problem.runs.size(); ++r) {
      const std::vector<StepRow>& rows = s_.problem.runs[r].rows;
      for (size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].row != row) continue;
        const double measured = settled ? rows[i].end_Pa : rows[i].begin_Pa;
        Near("row " + std::to_string(row) + (settled ? ", settled" : ", just after the step") +
                 ", its step left out (gauge)",
             "Pa", settled ? s_.after.left_out_Pa[r][i] : s_.thermal[r].thermal_Pa[i], measured,
             share * measured, "Table B-1");
      }
    }
  }

 private:
  const StepSearch& s_;
  Checks* checks_;
};

Status AddFrictionShares(const StepSearch& s, Rows* rows) {
  Result<PhsParams> fitted = rigs::ModelOf(s.problem, s.after.fit.logs, 0);
  if (!fitted.ok()) return fitted.error();
  struct Input {
    const char* name;
    double frequency_Hz;
    bool triangle;
    double measured, share;
  };
  for (const Input& in : {Input{"sine, 0.1 Hz", 0.1, false, 12.9148, 0.10},
                          Input{"triangle, 0.25 Hz", 0.25, true, 18.0356, 0.12}}) {
    using Model = std::pair<const char*, const PhsParams*>;
    for (const auto& [words, params] : {Model{"declared", &s.problem.runs[0].declared},
                                        Model{"fitted to Table B-1", &fitted.value()}}) {
      Result<double> ours = CalcFrictionShare(*params, 1.5e-3, in.frequency_Hz, in.triangle);
      if (!ours.ok()) return ours.error();
      rows->Near(std::string("Table 6-3, middle block, ") + in.name + ", 1.5 mm: " + words, "%",
                 ours.value(), in.measured, in.share * in.measured,
                 "Table 6-3, isothermal: hydraulic force against load cell, m%RE");
    }
  }
  return {};
}

}  // namespace

Result<StepSearch> SearchTableB1() {
  Result<std::string> path = FindData("rig", "models/rigs", "steps_joint", {".yaml"});
  if (!path.ok()) return path.error();
  Result<measurement::Manifest> manifest = measurement::LoadManifest(path.value());
  if (!manifest.ok()) return manifest.error();
  Result<std::vector<measurement::StepCase>> cases = measurement::ReadStepCases(manifest.value());
  if (!cases.ok()) return cases.error();
  Result<rigs::StepProblem> problem = identify::MakeStepProblem(manifest.value(), cases.value());
  if (!problem.ok()) return problem.error();
  return identify::SearchSteps(problem.value(), manifest.value().shared);
}

Result<double> CalcFrictionShare(const PhsParams& quarter, double amplitude_m, double frequency_Hz,
                                 bool triangle) {
  Result<hydraulics::PhsSystem> made = phs_model::CreatePhsSystem(quarter);
  if (!made.ok()) return made.error();
  if (made.value().num_states() > 0) {
    return Error{quarter.name, "has states: its force depends on what was before",
                 "isothermal gas and static friction"};
  }
  constexpr int kSamples = 2000;
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double phase = (i + 0.5) / kSamples, turn = 2 * M_PI * phase;
    const bool rising = phase < 0.25 || phase >= 0.75;
    const double saw = phase < 0.25 ? phase : (phase < 0.75 ? 0.5 - phase : phase - 1);
    const double x = amplitude_m * (triangle ? 4 * saw : std::sin(turn));
    const double v =
        amplitude_m * frequency_Hz * (triangle ? (rising ? 4.0 : -4.0) : 2 * M_PI * std::cos(turn));
    double force = 0, from_pressure = 0;
    hydraulics::PhsOutputs out;
    out.energy = false;
    out.force = &force;
    out.pressure_force = &from_pressure;
    made.value().Calc(0, &x, &v, nullptr, &out);
    sum += std::min(100.0, 100 * std::abs((from_pressure - force) / force));
  }
  return sum / kSamples;
}

Status AddTableB1Checks(Checks* checks) {
  Result<StepSearch> searched = SearchTableB1();
  if (!searched.ok()) return searched.error();
  const StepSearch& s = searched.value();
  Rows rows(s, checks);
  const double settled[] = {0.20, 0.046, 0.012}, begin[] = {0.09, 0.09, 0.03};
  for (size_t r = 0; r < s.problem.runs.size(); ++r) rows.Errors(r, settled[r], begin[r]);
  for (const int row : {11, 13, 23}) rows.Row(row, true, 0.03);
  for (const int row : {15, 23}) rows.Row(row, false, 0.09);
  for (const int row : {25, 31}) rows.Row(row, false, 0.03);
  return AddFrictionShares(s, &rows);
}

}  // namespace phs::validate
