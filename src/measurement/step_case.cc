#include "measurement/step_case.h"

#include <cstdlib>
#include <set>

#include "base/data_path.h"
#include "base/table.h"
#include "base/words.h"
#include "phs_model/phs_model.h"

namespace phs::measurement {
namespace {

int TrailingNumber(const std::string& name) {
  const size_t stem = name.find_last_not_of("0123456789");
  const std::string digits = name.substr(stem == std::string::npos ? 0 : stem + 1);
  return digits.empty() || digits.size() > 6 ? 0 : std::atoi(digits.c_str());
}

Result<StepCase> ReadStepCase(const Manifest& manifest, const RunSpec& run) {
  StepCase out;
  out.model = run.model.empty() ? manifest.model : run.model;
  Result<hydraulics::PhsParams> params = DeclaredModel(manifest, out.model);
  if (!params.ok()) return params.error();
  out.declared = std::move(params.value());
  out.source = run.data;
  Result<std::vector<rigs::StepRow>> rows = rigs::ReadStepTable(out.source);
  if (!rows.ok()) {
    Result<std::string> known = FindData("step table", "models/rigs", out.source, {".csv"});
    if (known.ok()) rows = rigs::ReadStepTable(known.value());
    if (!rows.ok()) return rows.error();
  }
  std::set<int> setups;
  for (const rigs::StepRow& row : rows.value()) setups.insert(row.setup);
  out.setup = run.setup != 0 ? run.setup : manifest.setup;
  if (out.setup == 0 && setups.count(TrailingNumber(out.declared.name)) > 0) {
    out.setup = TrailingNumber(out.declared.name);
  }
  for (const rigs::StepRow& row : rows.value()) {
    if (out.setup == 0 || row.setup == out.setup) out.rows.push_back(row);
  }
  if (!out.rows.empty()) return out;
  std::vector<std::string> known;
  known.reserve(setups.size());
  for (const int setup : setups) known.push_back(std::to_string(setup));
  return Error{manifest.path + ": setup", "no row of " + out.source + " has this setup",
               JoinWords(known)};
}

}  // namespace

Result<std::vector<StepCase>> ReadStepCases(const Manifest& manifest) {
  std::vector<StepCase> out;
  for (const RunSpec& run : manifest.runs) {
    Result<StepCase> one = ReadStepCase(manifest, run);
    if (!one.ok()) return one.error();
    out.push_back(std::move(one.value()));
  }
  return out;
}

ChannelScore ScoreSteps(const std::vector<double>& measured, const std::vector<double>& predicted) {
  std::vector<double> place;
  for (size_t i = 0; i < measured.size(); ++i) place.push_back(static_cast<double>(i));
  return Score(place, measured, predicted, {0, static_cast<double>(measured.size())});
}

Status WriteStepTable(const std::string& path, const std::vector<rigs::StepRow>& rows,
                      const std::vector<double>& begin_Pa, const std::vector<double>& end_Pa,
                      const std::vector<double>& tau_s) {
  std::vector<std::vector<double>> c(8);
  for (size_t i = 0; i < rows.size(); ++i) {
    const rigs::StepRow& row = rows[i];
    const double values[] = {static_cast<double>(row.row),
                             row.bore ? 1.0 : 2.0,
                             static_cast<double>(row.setup),
                             row.actuator_step_m * 1e3,
                             row.piston_step_m * 1e3,
                             begin_Pa[i] * 1e-6,
                             end_Pa[i] * 1e-6,
                             tau_s[i]};
    for (size_t k = 0; k < c.size(); ++k) c[k].push_back(values[k]);
  }
  return WriteCsv(path,
                  {"row", "chamber", "setup", "step_actuator_mm", "step_piston_mm", "p_begin_MPa",
                   "p_end_MPa", "tau_s"},
                  c);
}

}  // namespace phs::measurement
