#include "identify/run/steps_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/words.h"
#include "effects/catalogue.h"
#include "rigs/step_relaxation.h"

namespace phs::identify {

using measurement::StepCase;
using rigs::StepComparison;
using rigs::StepNumber;
using rigs::StepProblem;
using rigs::StepRow;
using rigs::StepRun;

namespace {

constexpr double kNeededGain = 0.10;  // share by which the error of the left-out steps must fall

/// Beside the effects of the catalogue: the pressure to which a line was filled.
constexpr const char* kFilling = "filling";

std::vector<std::string> EffectNames() {
  std::vector<std::string> out;
  for (const hydraulics::EffectInfo& info : effects::Catalogue().effects()) {
    if (!info.search.steps.empty()) out.push_back(info.name);
  }
  out.emplace_back(kFilling);
  return out;
}

/// Lines of a quarter rig: {bore, rod}.
std::vector<std::string> Lines(const StepProblem& problem) {
  const auto& c = problem.runs.front().declared.cylinders.front();
  return {c.bore_line, c.rod_line};
}

std::vector<StepNumber> NumbersOf(const StepProblem& problem, const std::string& effect) {
  const std::vector<std::string> lines = Lines(problem);
  const hydraulics::EffectInfo* info = effects::Catalogue().Find(effect);
  std::vector<StepNumber> out;
  for (const std::string& line : lines) {
    if (info == nullptr) out.push_back({line + ".static_pressure_Pa"});
    for (size_t k = 0; info != nullptr && k < info->search.steps.size(); ++k) {
      const hydraulics::SettledNumber& number = info->search.steps[k];
      if (number.of_rod_line && line != lines[1]) continue;
      out.push_back({line + "." + number.key, false, number.of_gas_volume});
    }
  }
  return out;
}

/// The oil, and the gas of the lines that have some in every run.
std::vector<StepNumber> UsualNumbers(const StepProblem& problem) {
  std::vector<StepNumber> out = {{"lines.oil_volume_m3"}};
  for (const std::string& line : Lines(problem)) {
    const bool gas = std::all_of(problem.runs.begin(), problem.runs.end(), [&](const StepRun& run) {
      const int at = run.declared.FindLine(line);
      return at >= 0 && run.declared.lines[static_cast<size_t>(at)].gas_volume_m3 > 0;
    });
    if (gas) out.push_back({line + ".gas_volume_m3"});
  }
  return out;
}

void MarkShared(const std::vector<std::string>& shared, StepProblem* problem) {
  for (StepNumber& n : problem->numbers) {
    n.shared = std::find(shared.begin(), shared.end(), n.name) != shared.end();
  }
}

/// Every name under `shared:` is a number that may become free.
Status CheckShared(const measurement::Manifest& manifest, const StepProblem& problem) {
  std::vector<std::string> known;
  for (const StepNumber& n : problem.numbers) known.push_back(n.name);
  for (const std::string& effect : EffectNames()) {
    for (const StepNumber& n : NumbersOf(problem, effect)) known.push_back(n.name);
  }
  for (const std::string& name : manifest.shared) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string nearest = NearestWord(name, known);
    return Error{manifest.path + ": shared", "\"" + name + "\" is no number that is fitted",
                 JoinWords(known), nearest.empty() ? "" : "did you mean " + nearest + "?"};
  }
  return {};
}

}  // namespace

Result<StepProblem> MakeStepProblem(const measurement::Manifest& manifest,
                                    const std::vector<StepCase>& cases) {
  StepProblem out;
  for (const StepCase& c : cases) {
    if (c.setup == 0) {
      return Error{manifest.path + ": setup", "rows of several setups cannot share one model",
                   "setup: one number of the table's column", "runs: with a model for each setup"};
    }
    if (c.declared.cylinders.size() != 1) {
      return Error{c.declared.name, "is no quarter rig", "one cylinder with a bore and a rod line"};
    }
    out.runs.push_back({c.model, c.declared, c.setup, rigs::SettledRows(c.rows)});
  }
  if (out.num_rows() == 0) {
    return Error{manifest.path, "no row has a settled pressure", "at least one"};
  }
  for (const std::string& name : manifest.free) out.numbers.push_back({name});
  if (manifest.free.empty()) out.numbers = UsualNumbers(out);
  if (Status s = CheckShared(manifest, out); !s.ok()) return s.error();
  MarkShared(manifest.shared, &out);
  return out;
}

StepProblem WithEffect(const StepProblem& problem, const std::string& effect,
                       const std::vector<std::string>& shared) {
  StepProblem out = problem;
  for (const StepNumber& added : NumbersOf(problem, effect)) {
    const bool present = std::any_of(out.numbers.begin(), out.numbers.end(),
                                     [&](const StepNumber& n) { return n.name == added.name; });
    if (!present) out.numbers.push_back(added);
  }
  MarkShared(shared, &out);
  return out;
}

namespace {

/// What is not free yet.
std::vector<std::string> Open(const StepSearch& s) {
  std::vector<std::string> out;
  for (const std::string& effect : EffectNames()) {
    if (WithEffect(s.problem, effect, {}).num_free() > s.problem.num_free()) {
      out.emplace_back(effect);
    }
  }
  return out;
}

/// Tries every open effect beside the accepted ones and takes the best. False: none gains.
Result<bool> AcceptOne(const std::vector<std::string>& shared, StepSearch* s) {
  const double now = rigs::MeanRelativeError(s->problem, s->after.left_out_Pa);
  double best = (1 - kNeededGain) * now;
  std::optional<StepProblem> best_problem;
  StepComparison best_fit;
  std::string best_name;
  for (const std::string& effect : Open(*s)) {
    StepCandidate& tried = s->candidates.emplace_back();
    tried.name = effect, tried.beside = s->accepted;
    StepProblem problem = WithEffect(s->problem, effect, shared);
    Result<StepComparison> fit = rigs::CompareSteps(problem);
    if (!fit.ok()) {
      tried.why = "cannot be judged: " + fit.error().what;
      continue;
    }
    const double error = rigs::MeanRelativeError(problem, fit.value().left_out_Pa);
    tried.error_left_out = error;
    tried.error_in_sample = rigs::MeanRelativeError(problem, fit.value().fitted_Pa);
    tried.why = error < (1 - kNeededGain) * now
                    ? "lowers the error of the steps left out"
                    : "does not lower the error of the steps left out by 10 %";
    if (error >= best) continue;
    best = error, best_name = effect;
    best_problem = std::move(problem), best_fit = std::move(fit.value());
  }
  if (!best_problem) return false;
  s->problem = std::move(*best_problem), s->after = std::move(best_fit);
  s->accepted.push_back(best_name);
  return true;
}

/// Thermal time of run `r` and its pressures just after the step of `step`, from a fit.
Status PredictBegin(const StepProblem& problem, const Eigen::VectorXd& logs, size_t r, double step,
                    StepThermal* out) {
  Result<hydraulics::PhsParams> model = rigs::ModelOf(problem, logs, r);
  if (!model.ok()) return model.error();
  const std::vector<StepRow>& rows = problem.runs[r].rows;
  std::vector<StepRow> kept = rows;
  std::erase_if(kept, [=](const StepRow& row) { return row.actuator_step_m == step; });
  Result<double> time = rigs::FitThermalTime(model.value(), kept);
  if (!time.ok()) return time.error();
  out->low_s = std::min(out->low_s, time.value());
  out->high_s = std::max(out->high_s, time.value());
  Result<std::vector<double>> cold = rigs::PredictSettled(model.value(), rows);
  if (!cold.ok()) return cold.error();
  const auto warm =
      rigs::PredictRelaxations(rigs::WithThermalGas(model.value(), time.value()), rows);
  if (!warm.ok()) return warm.error();
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].actuator_step_m != step) continue;
    out->isothermal_Pa[i] = cold.value()[i];
    out->thermal_Pa[i] = warm.value()[i].begin_Pa;
  }
  return {};
}

StepThermal JudgeThermal(const StepSearch& s, size_t r) {
  StepThermal out;
  const StepRun& run = s.problem.runs[r];
  out.isothermal_Pa = out.thermal_Pa = s.after.left_out_Pa[r];
  std::vector<double> measured;
  for (const StepRow& row : run.rows) measured.push_back(row.begin_Pa);
  const auto fail = [&](const Error& error) {
    out.why = "cannot be judged: " + error.what;
    out.error_isothermal = out.error_thermal =
        rigs::MeanRelativeError(s.after.left_out_Pa[r], measured);
    return out;
  };
  Result<hydraulics::PhsParams> model = rigs::ModelOf(s.problem, s.after.fit.logs, r);
  if (!model.ok()) return fail(model.error());
  Result<double> time = rigs::FitThermalTime(model.value(), run.rows);
  if (!time.ok()) return fail(time.error());
  out.thermal_time_s = out.low_s = out.high_s = time.value();
  for (const rigs::StepLeftOut& left : s.after.without) {
    if (left.run != r) continue;
    if (s.problem.go_on && !s.problem.go_on()) return fail({"", "was stopped", "", ""});
    Status done = PredictBegin(s.problem, left.fit.logs, r, left.actuator_step_m, &out);
    if (!done.ok()) return fail(done.error());
  }
  out.error_isothermal = rigs::MeanRelativeError(out.isothermal_Pa, measured);
  out.error_thermal = rigs::MeanRelativeError(out.thermal_Pa, measured);
  out.accepted = out.error_thermal < (1 - kNeededGain) * out.error_isothermal;
  out.why = out.accepted ? "lowers the error of the pressures just after the steps left out"
                         : "does not lower the error of the pressures just after the steps left "
                           "out by 10 %";
  return out;
}

}  // namespace

Result<StepSearch> SearchSteps(const StepProblem& problem, const std::vector<std::string>& shared) {
  StepSearch out;
  out.before_problem = out.problem = problem;
  Result<StepComparison> start = rigs::CompareSteps(problem);
  if (!start.ok()) return start.error();
  out.before = out.after = std::move(start.value());
  for (;;) {
    Result<bool> accepted = AcceptOne(shared, &out);
    if (!accepted.ok()) return accepted.error();
    if (!accepted.value()) break;
  }
  for (size_t r = 0; r < out.problem.runs.size(); ++r) {
    out.thermal.push_back(JudgeThermal(out, r));
  }
  return out;
}

}  // namespace phs::identify
