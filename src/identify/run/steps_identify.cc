// `phs identify` of steps: the search as result.json, tables and corrected models.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "effects/gas_thermal.h"
#include "identify/run/steps_run.h"
#include "identify/run/steps_search.h"
#include "phs_model/phs_model.h"
#include "rigs/step_relaxation.h"

namespace phs::identify {

using measurement::ScoreSteps;
using measurement::StepCase;
using measurement::WriteStepTable;
namespace {

using json = nlohmann::ordered_json;
using rigs::StepComparison;
using rigs::StepNumber;
using rigs::StepProblem;
using rigs::StepRow;
using rigs::StepRun;

/// A quantity by run and row, one run after the other.
std::vector<double> Pooled(const std::vector<std::vector<double>>& by_run) {
  std::vector<double> out;
  for (const auto& run : by_run) out.insert(out.end(), run.begin(), run.end());
  return out;
}

std::vector<double> Of(const std::vector<StepRun>& runs, double StepRow::*member) {
  std::vector<double> out;
  for (const StepRun& run : runs) {
    for (const StepRow& row : run.rows) out.push_back(row.*member);
  }
  return out;
}

std::vector<StepRow> Rows(const std::vector<StepRun>& runs) {
  std::vector<StepRow> out;
  for (const StepRun& run : runs) out.insert(out.end(), run.rows.begin(), run.rows.end());
  return out;
}

/// Number `k` of run `r`: value with its 95 % interval, and the range over the fits without a step.
json Value(const StepSearch& s, size_t k, size_t r) {
  const int place = s.problem.Place(k, r);
  const double q = s.after.fit.logs[place], sd = s.after.fit.sd[place];
  double low = q, high = q;
  for (const rigs::StepLeftOut& left : s.after.without) {
    low = std::min(low, left.fit.logs[place]);
    high = std::max(high, left.fit.logs[place]);
  }
  constexpr double kTwoSided95 = 1.96;
  return {{"value", std::exp(q)},
          {"low", std::exp(q - kTwoSided95 * sd)},
          {"high", std::exp(q + kTwoSided95 * sd)},
          {"left_out_low", std::exp(low)},
          {"left_out_high", std::exp(high)}};
}

/// Name of a number in the result: of an own one among several runs, behind its model.
std::string NameOf(const StepProblem& problem, size_t k, size_t r) {
  const StepNumber& n = problem.numbers[k];
  return n.shared || problem.runs.size() == 1 ? n.name : problem.runs[r].model + ": " + n.name;
}

/// Numbers from `first` to `end`.
json Values(const StepSearch& s, size_t first, size_t end) {
  json out = json::object();
  for (size_t k = first; k < end; ++k) {
    for (size_t r = 0; r < s.problem.runs.size(); ++r) {
      out[NameOf(s.problem, k, r)] = Value(s, k, r);
      if (s.problem.numbers[k].shared) break;
    }
  }
  return out;
}

json Effects(const StepSearch& s) {
  json out = json::array();
  const double before = rigs::MeanRelativeError(s.before_problem, s.before.left_out_Pa);
  const double after = rigs::MeanRelativeError(s.problem, s.after.left_out_Pa);
  StepProblem grown = s.before_problem;
  for (const std::string& effect : s.accepted) {
    const size_t first = grown.numbers.size();
    grown = WithEffect(grown, effect, {});
    out.push_back(
        {{"name", effect},
         {"parameters", Values(s, first, grown.numbers.size())},
         {"evidence", {{"error_left_out_before", before}, {"error_left_out_after", after}}},
         {"confusable_with", json::array()}});
  }
  for (size_t r = 0; r < s.thermal.size(); ++r) {
    const StepThermal& t = s.thermal[r];
    if (!t.accepted) continue;
    out.push_back(
        {{"name", effects::GasThermalInfo().name},
         {"run", s.problem.runs[r].model},
         {"parameters",
          {{"thermal_time_s",
            {{"value", t.thermal_time_s}, {"low", t.low_s}, {"high", t.high_s}}}}},
         {"evidence",
          {{"error_begin_before", t.error_isothermal}, {"error_begin_after", t.error_thermal}}},
         {"confusable_with", json::array()}});
  }
  return out;
}

json Candidates(const StepSearch& s) {
  const auto number = [](const std::optional<double>& x) { return x ? json(*x) : json(nullptr); };
  json out = json::array();
  for (const StepCandidate& c : s.candidates) {
    out.push_back({{"name", c.name},
                   {"beside", c.beside},
                   {"error_left_out", number(c.error_left_out)},
                   {"error_in_sample", number(c.error_in_sample)},
                   {"why", c.why}});
  }
  for (size_t r = 0; r < s.thermal.size(); ++r) {
    out.push_back({{"name", effects::GasThermalInfo().name},
                   {"run", s.problem.runs[r].model},
                   {"error_begin_isothermal", s.thermal[r].error_isothermal},
                   {"error_begin_thermal", s.thermal[r].error_thermal},
                   {"why", s.thermal[r].why}});
  }
  return out;
}

std::vector<double> Begin(const StepThermal& t) {
  return t.accepted ? t.thermal_Pa : t.isothermal_Pa;
}

/// Errors of one run, relative to gauge and to absolute pressure.
json RunErrors(const StepSearch& s, size_t r) {
  const StepRun& run = s.problem.runs[r];
  const std::vector<double> measured = rigs::MeasuredSettled(run);
  std::vector<double> begin;
  for (const StepRow& row : run.rows) begin.push_back(row.begin_Pa);
  const auto both = [](const std::vector<double>& p, const std::vector<double>& m) -> json {
    return {{"of_gauge", rigs::MeanRelativeError(p, m)},
            {"of_absolute", rigs::MeanAbsolutePressureError(p, m)}};
  };
  return {{"model", run.model},
          {"setup", run.setup},
          {"pressures", run.rows.size()},
          {"errors",
           {{"settled_declared", both(s.after.declared_Pa[r], measured)},
            {"settled_before_left_out", both(s.before.left_out_Pa[r], measured)},
            {"settled_in_sample", both(s.after.fitted_Pa[r], measured)},
            {"settled_left_out", both(s.after.left_out_Pa[r], measured)},
            {"begin_left_out_isothermal", both(s.thermal[r].isothermal_Pa, begin)},
            {"begin_left_out_thermal", both(s.thermal[r].thermal_Pa, begin)},
            {"begin_left_out", both(Begin(s.thermal[r]), begin)}}}};
}

json Channels(const StepSearch& s) {
  const std::vector<double> end = Of(s.problem.runs, &StepRow::end_Pa);
  const std::vector<double> begin = Of(s.problem.runs, &StepRow::begin_Pa);
  std::vector<std::vector<double>> cold, chosen;
  for (const StepThermal& t : s.thermal) {
    cold.push_back(t.isothermal_Pa), chosen.push_back(Begin(t));
  }
  return {{"p_end_Pa",
           {{"declared", ToJson(ScoreSteps(end, Pooled(s.before.declared_Pa)))},
            {"before", ToJson(ScoreSteps(end, Pooled(s.before.left_out_Pa)))},
            {"after", ToJson(ScoreSteps(end, Pooled(s.after.left_out_Pa)))},
            {"after_in_sample", ToJson(ScoreSteps(end, Pooled(s.after.fitted_Pa)))}}},
          {"p_begin_Pa",
           {{"before", ToJson(ScoreSteps(begin, Pooled(cold)))},
            {"after", ToJson(ScoreSteps(begin, Pooled(chosen)))}}}};
}

std::string NumbersText(const StepSearch& s) {
  std::string out;
  const json values = Values(s, 0, s.problem.numbers.size());
  for (const auto& [name, v] : values.items()) {
    out += fmt::format("  {:<44} {:>10.4g}  ({:.4g} … {:.4g})\n", name, v["value"].get<double>(),
                       v["low"].get<double>(), v["high"].get<double>());
  }
  return out;
}

std::string StepsSummary(const StepSearch& s) {
  std::string out =
      "mean relative error of gauge pressures, each step left out of the fit (in brackets: of the "
      "absolute pressure)\n"
      "setup  settled: declared   oil, gas   corrected        just after: isothermal  chosen\n";
  for (size_t r = 0; r < s.problem.runs.size(); ++r) {
    const json run = RunErrors(s, r);
    const json& e = run["errors"];
    const auto percent = [&](const char* name, const char* of = "of_gauge") {
      return 100 * e[name][of].get<double>();
    };
    out += fmt::format(
        "{:>5}  {:>15.1f} %  {:>7.1f} %  {:>8.1f} % ({:.1f} %)  {:>19.1f} %  {:>4.1f} %{}\n",
        run["setup"].get<int>(), percent("settled_declared"), percent("settled_before_left_out"),
        percent("settled_left_out"), percent("settled_left_out", "of_absolute"),
        percent("begin_left_out_isothermal"), percent("begin_left_out"),
        s.thermal[r].accepted ? fmt::format("  thermal gas, {:.1f} s", s.thermal[r].thermal_time_s)
                              : "");
  }
  std::string with;
  for (const std::string& effect : s.accepted) with += (with.empty() ? "" : ", ") + effect;
  out += with.empty() ? "no effect of the catalogue lowers the error of the left-out steps\n"
                      : "needed: " + with + "\n";
  out += fmt::format("error sizes: model {:.1f} %, reading {:.0f} kPa\n",
                     100 * s.after.fit.errors.model, s.after.fit.errors.reading_Pa * 1e-3);
  return out + NumbersText(s);
}

/// The corrected model of run `r`.
Result<hydraulics::PhsParams> Corrected(const StepSearch& s, size_t r, const std::string& source) {
  Result<hydraulics::PhsParams> model = rigs::ModelOf(s.problem, s.after.fit.logs, r);
  if (!model.ok()) return model;
  hydraulics::PhsParams out = s.thermal[r].accepted
                                  ? rigs::WithThermalGas(model.value(), s.thermal[r].thermal_time_s)
                                  : model.value();
  out.name += "_identified";
  out.description = "Fitted to the settled pressures of " + source;
  return out;
}

std::string ModelFile(const StepSearch& s, size_t r) {
  return r == 0 ? "model.yaml" : fmt::format("model_{}.yaml", s.problem.runs[r].setup);
}

Status WriteFiles(const StepSearch& s, const std::vector<StepCase>& cases, const json& result,
                  const ResultDir& dir) {
  const std::vector<StepRow> rows = Rows(s.problem.runs);
  const std::vector<double> begin = Of(s.problem.runs, &StepRow::begin_Pa);
  const std::vector<double> end = Of(s.problem.runs, &StepRow::end_Pa);
  const std::vector<double> tau(rows.size(), 0.0);
  std::vector<std::vector<double>> chosen, cold;
  for (const StepThermal& t : s.thermal) {
    chosen.push_back(Begin(t)), cold.push_back(t.isothermal_Pa);
  }
  for (size_t r = 0; r < cases.size(); ++r) {
    Result<hydraulics::PhsParams> model = Corrected(s, r, cases[r].source);
    if (!model.ok()) return model.error();
    const Status written =
        WriteFileAtomically(dir.File(ModelFile(s, r)), phs_model::ToYaml(model.value()));
    if (!written.ok()) return written;
  }
  for (const Status& status :
       {WriteStepTable(dir.File("measured.csv"), rows, begin, end, tau),
        WriteStepTable(dir.File("baseline.csv"), rows, Pooled(cold), Pooled(s.before.left_out_Pa),
                       tau),
        WriteStepTable(dir.File("predicted.csv"), rows, Pooled(chosen), Pooled(s.after.left_out_Pa),
                       tau),
        WriteFileAtomically(dir.File("result.json"), result.dump(1) + "\n")}) {
    if (!status.ok()) return status;
  }
  return {};
}

json ToJson(const StepSearch& s, const measurement::Manifest& manifest,
            const std::vector<StepCase>& cases) {
  json runs = json::array(), models = json::object();
  for (size_t r = 0; r < s.problem.runs.size(); ++r) {
    runs.push_back(RunErrors(s, r));
    models[s.problem.runs[r].model] = ModelFile(s, r);
  }
  json setup = json::array();
  for (const StepCase& c : cases) setup.push_back(c.setup);
  return {
      {"rig", "steps"},
      {"declared", manifest.model},
      {"data", cases.front().source},
      {"setup", cases.size() == 1 ? setup[0] : setup},
      {"shared", manifest.shared},
      {"noise",
       {{"model_share", s.after.fit.errors.model}, {"reading_Pa", s.after.fit.errors.reading_Pa}}},
      {"channels", Channels(s)},
      {"runs", runs},
      {"effects", Effects(s)},
      {"fitted", Values(s, 0, s.problem.numbers.size())},
      {"candidates", Candidates(s)},
      {"localised", {{"channel", "p_end_Pa"}, {"depends_on", {"piston_step_m"}}}},
      {"unexplained",
       {{"nrmse",
         ScoreSteps(Of(s.problem.runs, &StepRow::end_Pa), Pooled(s.after.left_out_Pa)).nrmse},
        {"whiteness_p", nullptr},
        {"depends_on", json::array()},
        {"formula", nullptr}}},
      {"model", "model.yaml"},
      {"models", models}};
}

}  // namespace

Result<RigOutcome> IdentifySteps(const measurement::Manifest& manifest, const ResultDir& dir,
                                 const std::function<bool()>& go_on) {
  Result<std::vector<StepCase>> cases = measurement::ReadStepCases(manifest);
  if (!cases.ok()) return cases.error();
  Result<StepProblem> problem = MakeStepProblem(manifest, cases.value());
  if (!problem.ok()) return problem.error();
  problem.value().go_on = go_on;
  Result<StepSearch> searched = SearchSteps(problem.value(), manifest.shared);
  if (!searched.ok()) return searched.error();
  RigOutcome out;
  out.result = ToJson(searched.value(), manifest, cases.value());
  Status written = WriteFiles(searched.value(), cases.value(), out.result, dir);
  if (!written.ok()) return written.error();
  out.summary = StepsSummary(searched.value());
  return out;
}

}  // namespace phs::identify
