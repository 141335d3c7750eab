#include "rigs/step_table.h"

#include <algorithm>
#include <cmath>

#include "base/table.h"
#include "phs_model/phs_model.h"

namespace phs::rigs {

using phs_model::CreatePhsSystem;

using hydraulics::PhsOutputs;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;

Result<std::vector<StepRow>> ReadStepTable(const std::string& path) {
  Result<Table> table = ReadCsv(path);
  if (!table.ok()) return table.error();
  const Table& t = table.value();
  const std::vector<std::vector<std::string>> names = {{"row"},
                                                       {"chamber"},
                                                       {"setup"},
                                                       {"step_actuator_mm", "step_schenck_mm"},
                                                       {"step_piston_mm", "step_laser_mm"},
                                                       {"p_begin_MPa", "P_begin_MPa"},
                                                       {"p_end_MPa", "P_end_MPa"},
                                                       {"tau_s"},
                                                       {"valid"}};
  std::vector<std::vector<double>> c;
  for (const auto& known : names) {
    size_t used = 0;
    while (used + 1 < known.size() && t.Find(known[used]) < 0) ++used;
    if (t.Find(known[used]) < 0) used = 0;
    Result<std::vector<double>> column = t.Column(known[used]);
    if (!column.ok()) return column.error();
    c.push_back(std::move(column.value()));
    for (int i = 0; i < t.num_rows(); ++i) {
      if (std::isfinite(c.back()[i])) continue;
      return Error{path + ":" + std::to_string(t.line[i]), known[used] + " is no number", "numbers",
                   "mend or remove the row"};
    }
  }
  std::vector<StepRow> rows;
  for (int i = 0; i < t.num_rows(); ++i) {
    StepRow r;
    r.row = static_cast<int>(c[0][i]);
    if (c[1][i] != 1 && c[1][i] != 2) {
      return Error{path + ":" + std::to_string(t.line[i]), "chamber is neither 1 nor 2",
                   "1 (bore) or 2 (rod)"};
    }
    r.bore = c[1][i] == 1;
    r.setup = static_cast<int>(c[2][i]);
    r.actuator_step_m = c[3][i] * 1e-3;
    r.piston_step_m = c[4][i] * 1e-3;
    r.compression = r.bore == (r.piston_step_m < 0);
    r.begin_Pa = c[5][i] * 1e6;
    r.end_Pa = c[6][i] * 1e6;
    r.tau_s = c[7][i];
    r.valid = c[8][i] != 0;
    rows.push_back(r);
  }
  return rows;
}

namespace {

// Advances the states over `duration` at constant piston speed.
void Advance(const PhsSystem& s, double duration, double h, double v, double* t, double* x,
             std::vector<double>* state) {
  std::vector<double> rate(state->size());
  const int n = std::max(1, static_cast<int>(std::lround(duration / h)));
  const double step = duration / n;
  for (int i = 0; i < n; ++i) {
    s.CalcStateRate(*t, step, x, &v, state->data(), rate.data());
    for (size_t k = 0; k < state->size(); ++k) (*state)[k] += step * rate[k];
    *t += step;
    *x += step * v;
  }
}

double GaugePressure(const PhsSystem& s, const StepRow& row, double t, double x,
                     const std::vector<double>& state) {
  double bore = 0, rod = 0;
  const double v = 0;
  PhsOutputs out;
  out.energy = false;
  out.p_bore = &bore;
  out.p_rod = &rod;
  s.Calc(t, &x, &v, state.data(), &out);
  return (row.bore ? bore : rod) - hydraulics::kAtmosphere;
}

}  // namespace

Result<StepPrediction> PredictStep(const PhsParams& params, const StepRow& row,
                                   const StepOptions& options) {
  if (params.cylinders.size() != 1) {
    return Error{params.name, "is no quarter rig", "a model with one cylinder"};
  }
  Result<PhsSystem> made = CreatePhsSystem(params);
  if (!made.ok()) return made.error();
  const PhsSystem& s = made.value();
  std::vector<double> state(s.num_states(), 0.0);
  StepPrediction out;
  double t = 0, x = 0;
  if (state.empty()) {
    out.begin_Pa = out.end_Pa = GaugePressure(s, row, 0, row.piston_step_m, state);
    return out;
  }
  Advance(s, options.rise_s, options.rise_s / 50, row.piston_step_m / options.rise_s, &t, &x,
          &state);
  out.begin_Pa = GaugePressure(s, row, t, x, state);
  std::vector<double> times = {0}, pressures = {out.begin_Pa};
  const double h = options.settle_s / 3000;
  for (int i = 1; i <= 3000; ++i) {
    Advance(s, h, h, 0, &t, &x, &state);
    times.push_back(i * h);
    pressures.push_back(GaugePressure(s, row, t, x, state));
  }
  out.end_Pa = pressures.back();
  const double fall = out.begin_Pa - out.end_Pa;
  for (size_t i = 1; i < times.size() && std::abs(fall) > 1; ++i) {
    const double done = (out.begin_Pa - pressures[i]) / fall;
    if (done < 0.632) continue;
    const double before = (out.begin_Pa - pressures[i - 1]) / fall;
    out.tau_s = times[i - 1] + h * (0.632 - before) / (done - before);
    break;
  }
  return out;
}

namespace {

// An isothermal copy without the effects that only matter in motion has no states, so one
// evaluation gives a settled pressure.
PhsParams Isothermal(const PhsParams& params) {
  PhsParams out = params;
  std::erase_if(out.effects, [](const hydraulics::EffectParams& effect) {
    for (const char* kept : {"accumulator_precharge", "diaphragm_stop", "entrained_air",
                             "hose_expansion", "cavitation"}) {
      if (effect.name == kept) return false;
    }
    return true;
  });
  out.friction.model = hydraulics::FrictionModel::kNone;
  for (hydraulics::LineParams& l : out.lines) {
    l.reservoir.law = l.accumulator.law = &hydraulics::kIsothermalGas;
  }
  return out;
}

/// The quickest of the model's gases [s].
double ThermalTime(const PhsParams& params) {
  double time = 1e9;
  for (const hydraulics::LineParams& l : params.lines) {
    for (const hydraulics::GasChargeParams* gas : {&l.reservoir, &l.accumulator}) {
      if (gas->law->capacity != nullptr) time = std::min(time, gas->thermal_time_s);
    }
  }
  return time;
}

Status CheckQuarter(const PhsParams& params) {
  if (params.cylinders.size() == 1) return {};
  return Error{params.name, "is no quarter rig", "a model with one cylinder"};
}

}  // namespace

Result<std::vector<double>> PredictSettled(const PhsParams& params,
                                           const std::vector<StepRow>& rows) {
  if (Status s = CheckQuarter(params); !s.ok()) return s.error();
  Result<PhsSystem> made = CreatePhsSystem(Isothermal(params));
  if (!made.ok()) return made.error();
  const std::vector<double> state(made.value().num_states(), 0.0);
  std::vector<double> out;
  out.reserve(rows.size());
  for (const StepRow& row : rows) {
    out.push_back(GaugePressure(made.value(), row, 0, row.piston_step_m, state));
  }
  return out;
}

Result<std::vector<StepRelaxation>> PredictRelaxations(const PhsParams& params,
                                                       const std::vector<StepRow>& rows,
                                                       const StepOptions& options) {
  Result<std::vector<double>> settled = PredictSettled(params, rows);
  if (!settled.ok()) return settled.error();
  PhsParams still = params;
  still.friction.model = hydraulics::FrictionModel::kNone;
  Result<PhsSystem> made = CreatePhsSystem(still);
  if (!made.ok()) return made.error();
  const PhsSystem& s = made.value();
  const double h = ThermalTime(params) / 50;
  std::vector<StepRelaxation> out;
  for (size_t i = 0; i < rows.size(); ++i) {
    const StepRow& row = rows[i];
    std::vector<double> state(s.num_states(), 0.0);
    double t = 0, x = 0;
    Advance(s, options.rise_s, options.rise_s / 50, row.piston_step_m / options.rise_s, &t, &x,
            &state);
    StepRelaxation& r = out.emplace_back();
    r.begin_Pa = GaugePressure(s, row, t, x, state);
    const double fall = r.begin_Pa - settled.value()[i];
    double before = 0;
    for (int k = 0; k < 2000 && std::abs(fall) > 1 && r.tau_37_s == 0; ++k) {
      Advance(s, h, h, 0, &t, &x, &state);
      const double done = (r.begin_Pa - GaugePressure(s, row, t, x, state)) / fall;
      if (done >= 0.37) r.tau_37_s = h * (k + (0.37 - before) / (done - before));
      before = done;
    }
  }
  return out;
}

double MeanRelativeError(const std::vector<double>& predicted,
                         const std::vector<double>& measured) {
  double sum = 0;
  for (size_t i = 0; i < measured.size(); ++i) {
    const double error = std::abs(predicted[i] - measured[i]) / std::abs(measured[i]);
    sum += std::isfinite(error) ? std::min(error, 1.0) : 1.0;
  }
  return measured.empty() ? 0 : sum / static_cast<double>(measured.size());
}

}  // namespace phs::rigs
