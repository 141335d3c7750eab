// Which of the effects that a step table can show are needed: greedy, judged on steps left out.
// `filling` is no effect of the catalogue but a declared number that may be wrong: the static
// pressures to which the lines were filled.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identify/steps_run.h"
#include "measurement/step_case.h"
#include "phs_model/phs_model.h"

namespace phs::identify {

using measurement::ReadStepCase;
using measurement::ScoreSteps;
using measurement::StepCase;
using measurement::WriteStepTable;
namespace {

using json = nlohmann::ordered_json;
using rigs::StepComparison;
using rigs::StepFit;
using rigs::StepFreedom;
using rigs::StepRow;

constexpr double kNeededGain = 0.10;  // share by which the error of the left-out steps must fall

struct Candidate {
  const char* effect;
  bool StepFreedom::*free;
};
constexpr Candidate kCandidates[] = {{"accumulator_precharge", &StepFreedom::precharge},
                                     {"diaphragm_stop", &StepFreedom::stop},
                                     {"filling", &StepFreedom::filling}};

/// A fitted value with the range it takes when single steps are left out.
json Value(const StepComparison& c, double StepFit::*member) {
  double low = c.fit.*member, high = low;
  for (const StepFit& fit : c.without) {
    low = std::min(low, fit.*member);
    high = std::max(high, fit.*member);
  }
  return {{"value", c.fit.*member}, {"low", low}, {"high", high}};
}

json Parameters(const std::string& effect, const StepComparison& c) {
  if (effect == "accumulator_precharge")
    return {{"precharge_Pa", Value(c, &StepFit::precharge_Pa)}};
  if (effect == "filling") {
    return {{"static_pressure_bore_Pa", Value(c, &StepFit::static_bore_Pa)},
            {"static_pressure_rod_Pa", Value(c, &StepFit::static_rod_Pa)}};
  }
  return {{"min_gas_volume_bore_m3", Value(c, &StepFit::min_gas_bore_m3)},
          {"min_gas_volume_rod_m3", Value(c, &StepFit::min_gas_rod_m3)}};
}

struct Search {
  StepFreedom freedom;
  StepComparison before, after;
  std::vector<std::string> accepted;
  json candidates = json::array();
};

Result<Search> SearchEffects(const StepCase& c) {
  Search out;
  Result<StepComparison> start = rigs::CompareSteps(c.declared, c.rows, out.freedom);
  if (!start.ok()) return start.error();
  out.before = out.after = std::move(start.value());
  for (;;) {
    const Candidate* best = nullptr;
    StepComparison best_fit;
    for (const Candidate& candidate : kCandidates) {
      if (out.freedom.*candidate.free) continue;
      StepFreedom freedom = out.freedom;
      freedom.*candidate.free = true;
      Result<StepComparison> tried = rigs::CompareSteps(c.declared, c.rows, freedom);
      if (!tried.ok()) return tried.error();
      const double error = tried.value().error_left_out;
      const bool gains = error < (1 - kNeededGain) * out.after.error_left_out;
      out.candidates.push_back(
          {{"name", candidate.effect},
           {"beside", out.accepted},
           {"error_left_out", error},
           {"error_in_sample", tried.value().error_fitted},
           {"why", gains ? "lowers the error of the steps left out"
                         : "does not lower the error of the steps left out by 10 %"}});
      if (gains && (best == nullptr || error < best_fit.error_left_out)) {
        best = &candidate;
        best_fit = std::move(tried.value());
      }
    }
    if (best == nullptr) return out;
    out.freedom.*(best->free) = true;
    out.accepted.emplace_back(best->effect);
    out.after = std::move(best_fit);
  }
}

json Channels(const Search& s, const std::vector<double>& measured) {
  return {{"p_end_Pa",
           {{"declared", ScoreSteps(measured, s.before.declared_Pa)},
            {"before", ScoreSteps(measured, s.before.left_out_Pa)},
            {"after", ScoreSteps(measured, s.after.left_out_Pa)},
            {"after_in_sample", ScoreSteps(measured, s.after.fitted_Pa)}}}};
}

json Effects(const Search& s) {
  json out = json::array();
  for (const std::string& effect : s.accepted) {
    out.push_back({{"name", effect},
                   {"parameters", Parameters(effect, s.after)},
                   {"evidence",
                    {{"error_left_out_before", s.before.error_left_out},
                     {"error_left_out_after", s.after.error_left_out}}},
                   {"confusable_with", json::array()}});
  }
  return out;
}

std::string Summary(const Search& s, const StepCase& c) {
  std::string out = fmt::format("setup {}, {} settled pressures, mean relative error:\n", c.setup,
                                s.before.rows.size());
  out += fmt::format("  as declared                          {:6.1f} %\n",
                     100 * s.before.error_declared);
  out += fmt::format("  oil and gas fitted                   {:6.1f} %, left-out steps {:.1f} %\n",
                     100 * s.before.error_fitted, 100 * s.before.error_left_out);
  std::string with;
  for (const std::string& effect : s.accepted) with += (with.empty() ? "" : ", ") + effect;
  if (!with.empty()) {
    out += fmt::format("  with {:<31} {:6.1f} %, left-out steps {:.1f} %\n", with,
                       100 * s.after.error_fitted, 100 * s.after.error_left_out);
  } else {
    out += "  no effect of the catalogue lowers the error of the left-out steps\n";
  }
  const StepFit& f = s.after.fit;
  out += fmt::format("  oil compliance {:.3g} m3/Pa, gas bore {:.2f} ml, gas rod {:.2f} ml",
                     f.oil_compliance_m3_per_Pa, f.gas_bore_m3 * 1e6, f.gas_rod_m3 * 1e6);
  if (s.freedom.precharge) out += fmt::format(", blow-off at {:.2f} MPa", f.precharge_Pa * 1e-6);
  if (s.freedom.stop) {
    out += fmt::format(", stops at {:.2f} and {:.2f} ml", f.min_gas_bore_m3 * 1e6,
                       f.min_gas_rod_m3 * 1e6);
  }
  if (s.freedom.filling) {
    out += fmt::format(", filled to {:.2f} and {:.2f} MPa", f.static_bore_Pa * 1e-6,
                       f.static_rod_Pa * 1e-6);
  }
  return out + "\n";
}

}  // namespace

Result<RigOutcome> IdentifySteps(const measurement::Manifest& manifest, const ResultDir& dir) {
  Result<StepCase> loaded = ReadStepCase(manifest);
  if (!loaded.ok()) return loaded.error();
  const StepCase& c = loaded.value();
  if (c.setup == 0) {
    return Error{manifest.path + ": setup", "rows of several setups cannot share one model",
                 "setup: one number of the table's column", "one manifest per setup"};
  }
  Result<Search> searched = SearchEffects(c);
  if (!searched.ok()) return searched.error();
  const Search& s = searched.value();
  std::vector<double> measured, tau;
  for (const StepRow& row : s.before.rows) {
    measured.push_back(row.end_Pa);
    tau.push_back(0);
  }
  RigOutcome out;
  out.result = {{"rig", "steps"},
                {"declared", manifest.model},
                {"data", c.source},
                {"setup", c.setup},
                {"noise", json::object()},
                {"channels", Channels(s, measured)},
                {"effects", Effects(s)},
                {"fitted",
                 {{"oil_compliance_m3_per_Pa", Value(s.after, &StepFit::oil_compliance_m3_per_Pa)},
                  {"gas_volume_bore_m3", Value(s.after, &StepFit::gas_bore_m3)},
                  {"gas_volume_rod_m3", Value(s.after, &StepFit::gas_rod_m3)}}},
                {"candidates", s.candidates},
                {"localised", {{"channel", "p_end_Pa"}, {"depends_on", {"piston_step_m"}}}},
                {"unexplained",
                 {{"nrmse", ScoreSteps(measured, s.after.left_out_Pa)["nrmse"]},
                  {"whiteness_p", nullptr},
                  {"depends_on", json::array()},
                  {"formula", nullptr}}},
                {"model", "model.yaml"}};
  hydraulics::PhsParams corrected = rigs::WithStepFit(c.declared, s.after.fit, s.freedom);
  corrected.name += "_identified";
  corrected.description = "Fitted to the settled pressures of " + c.source;
  for (const Status& status :
       {WriteStepTable(dir.File("measured.csv"), s.before.rows, measured, measured, tau),
        WriteStepTable(dir.File("baseline.csv"), s.before.rows, s.before.left_out_Pa,
                       s.before.left_out_Pa, tau),
        WriteStepTable(dir.File("predicted.csv"), s.after.rows, s.after.left_out_Pa,
                       s.after.left_out_Pa, tau),
        WriteFileAtomically(dir.File("model.yaml"), phs_model::ToYaml(corrected)),
        WriteFileAtomically(dir.File("result.json"), out.result.dump(1) + "\n")}) {
    if (!status.ok()) return status.error();
  }
  out.summary = Summary(s, c);
  return out;
}

}  // namespace phs::identify
