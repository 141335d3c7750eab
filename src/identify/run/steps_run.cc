#include "identify/run/steps_run.h"

#include <fmt/format.h>

#include "measurement/step_case.h"

namespace phs::identify {

using measurement::ScoreSteps;
using measurement::StepCase;
using measurement::WriteStepTable;
namespace {

using json = nlohmann::ordered_json;
using rigs::StepPrediction;
using rigs::StepRow;

/// Measured values by row.
struct Measured {
  std::vector<double> begin, end, tau;
  explicit Measured(const std::vector<StepRow>& rows) {
    for (const StepRow& row : rows) {
      begin.push_back(row.begin_Pa), end.push_back(row.end_Pa), tau.push_back(row.tau_s);
    }
  }
};

}  // namespace

Result<RigOutcome> RunSteps(const measurement::Manifest& manifest, const ResultDir& dir) {
  Result<std::vector<StepCase>> loaded = measurement::ReadStepCases(manifest);
  if (!loaded.ok()) return loaded.error();
  std::vector<double> begin, end, tau;
  std::vector<double> m_begin, m_end, p_begin, p_end;  // rows that hold a measurement
  json rows = json::array();
  RigOutcome out;
  out.summary =
      "row  chamber  step mm   MPa gauge: just after    settled          tau, s\n"
      "                        meas.   model    meas.   model    meas.  model\n";
  std::vector<StepRow> all;
  std::vector<const hydraulics::PhsParams*> model;
  for (const StepCase& c : loaded.value()) {
    all.insert(all.end(), c.rows.begin(), c.rows.end());
    model.resize(all.size(), &c.declared);
  }
  for (size_t i = 0; i < all.size(); ++i) {
    const StepRow& row = all[i];
    Result<StepPrediction> predicted = rigs::PredictStep(*model[i], row);
    if (!predicted.ok()) return predicted.error();
    const StepPrediction& p = predicted.value();
    begin.push_back(p.begin_Pa), end.push_back(p.end_Pa), tau.push_back(p.tau_s);
    const bool measured = row.end_Pa > 0;
    if (measured) {
      m_begin.push_back(row.begin_Pa), p_begin.push_back(p.begin_Pa);
      m_end.push_back(row.end_Pa), p_end.push_back(p.end_Pa);
    }
    rows.push_back({{"row", row.row},
                    {"chamber", row.bore ? "bore" : "rod"},
                    {"piston_step_m", row.piston_step_m},
                    {"measured", measured},
                    {"p_begin_Pa", {{"measured", row.begin_Pa}, {"predicted", p.begin_Pa}}},
                    {"p_end_Pa", {{"measured", row.end_Pa}, {"predicted", p.end_Pa}}},
                    {"tau_s", {{"measured", row.tau_s}, {"predicted", p.tau_s}}}});
    out.summary += fmt::format(
        "{:>3}  {:7}  {:>7.2f}  {:>6.2f}  {:>6.2f}   {:>6.2f}  {:>6.2f}   {:>6.2f} {:>6.2f}{}\n",
        row.row, row.bore ? "bore" : "rod", row.piston_step_m * 1e3, row.begin_Pa * 1e-6,
        p.begin_Pa * 1e-6, row.end_Pa * 1e-6, p.end_Pa * 1e-6, row.tau_s, p.tau_s,
        measured ? "" : "  (not recorded)");
  }
  out.result = {{"rig", "steps"},
                {"declared", manifest.model},
                {"data", loaded.value().front().source},
                {"setup", loaded.value().front().setup},
                {"channels",
                 {{"p_begin_Pa", ToJson(ScoreSteps(m_begin, p_begin))},
                  {"p_end_Pa", ToJson(ScoreSteps(m_end, p_end))}}},
                {"rows", rows}};
  out.summary += fmt::format(
      "mean relative error, capped at 100 %: just after {:.1f} %, settled {:.1f} %\n",
      100 * rigs::MeanRelativeError(p_begin, m_begin), 100 * rigs::MeanRelativeError(p_end, m_end));
  const Measured m(all);
  for (const Status& s :
       {WriteStepTable(dir.File("predicted.csv"), all, begin, end, tau),
        WriteStepTable(dir.File("measured.csv"), all, m.begin, m.end, m.tau),
        WriteFileAtomically(dir.File("result.json"), out.result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  return out;
}

}  // namespace phs::identify
