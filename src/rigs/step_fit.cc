// Fit of the settled pressures of Table B-1 by Levenberg-Marquardt in the logarithms of the
// parameters; leave one step out (a step loads both chambers: both of its rows are left out
// together).
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "rigs/step_table.h"

namespace phs::rigs {

using hydraulics::PhsParams;

// An isothermal copy without the effects that only matter in motion has no states, so one
// evaluation gives them.
Result<std::vector<double>> PredictSettled(const PhsParams& params,
                                           const std::vector<StepRow>& rows) {
  PhsParams isothermal = params;
  std::erase_if(isothermal.effects, [](const hydraulics::EffectParams& effect) {
    for (const char* kept : {"accumulator_precharge", "diaphragm_stop", "entrained_air",
                             "hose_expansion", "cavitation"}) {
      if (effect.name == kept) return false;
    }
    return true;
  });
  isothermal.friction.model = hydraulics::FrictionModel::kNone;
  for (hydraulics::LineParams& l : isothermal.lines) {
    l.reservoir.law = l.accumulator.law = &hydraulics::kIsothermalGas;
  }
  std::vector<double> out;
  for (const StepRow& row : rows) {
    Result<StepPrediction> p = PredictStep(isothermal, row);
    if (!p.ok()) return p.error();
    out.push_back(p.value().end_Pa);
  }
  return out;
}

namespace {

constexpr int kParameters = 8;
using Vector = Eigen::VectorXd;

// [compliance, gas bore, gas rod, precharge, stop bore, stop rod, static bore, static rod], logs.
StepFit FromLogs(const Vector& q, const StepFreedom& freedom) {
  StepFit fit;
  fit.oil_compliance_m3_per_Pa = std::exp(q[0]);
  fit.gas_bore_m3 = std::exp(q[1]);
  fit.gas_rod_m3 = std::exp(q[2]);
  fit.precharge_Pa = std::exp(q[3]);
  fit.static_bore_Pa = std::exp(q[6]);
  fit.static_rod_Pa = std::exp(q[7]);
  if (freedom.stop) {
    fit.min_gas_bore_m3 = std::min(std::exp(q[4]), 0.999 * fit.gas_bore_m3);
    fit.min_gas_rod_m3 = std::min(std::exp(q[5]), 0.999 * fit.gas_rod_m3);
  }
  return fit;
}

std::vector<double> Measured(const std::vector<StepRow>& rows) {
  std::vector<double> out;
  for (const StepRow& row : rows) out.push_back(row.end_Pa);
  return out;
}

// Residuals in ln p, with a weak pull (factor 3 = 1 sigma of 0.05) to the start, so that what no
// row determines stays where it was.
Result<Vector> Residuals(const PhsParams& declared, const std::vector<StepRow>& rows,
                         const Vector& q, const Vector& start, const StepFreedom& freedom) {
  Result<std::vector<double>> p =
      PredictSettled(WithStepFit(declared, FromLogs(q, freedom), freedom), rows);
  if (!p.ok()) return p.error();
  Vector r(static_cast<int>(rows.size()) + q.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    r[static_cast<int>(i)] = std::log((p.value()[i] + hydraulics::kAtmosphere) /
                                      (rows[i].end_Pa + hydraulics::kAtmosphere));
  }
  r.tail(q.size()) = 0.05 * (q - start);
  return r;
}

// What is not free stays where it is.
void Pin(const StepFreedom& freedom, Eigen::MatrixXd* normal, Vector* slope) {
  for (int k = 0; k < kParameters; ++k) {
    const bool free = k < 3    ? true
                      : k == 3 ? freedom.precharge
                      : k < 6  ? freedom.stop
                               : freedom.filling;
    if (free) continue;
    normal->row(k).setZero();
    normal->col(k).setZero();
    (*normal)(k, k) = 1;
    (*slope)[k] = 0;
  }
}

Vector StartLogs(const PhsParams& declared) {
  const auto& c = declared.cylinders[0];
  const auto& bore = declared.lines[declared.FindLine(c.bore_line)];
  const auto& rod = declared.lines[declared.FindLine(c.rod_line)];
  auto gas = [](const hydraulics::LineParams& l) { return std::max(l.gas_volume_m3, 1e-7); };
  Vector q(kParameters);
  q << std::log(bore.oil_volume_m3 / bore.bulk_modulus_Pa), std::log(gas(bore)), std::log(gas(rod)),
      std::log(rod.accumulator_precharge_Pa), std::log(0.03 * gas(bore)), std::log(0.03 * gas(rod)),
      std::log(bore.static_pressure_Pa), std::log(rod.static_pressure_Pa);
  return q;
}

}  // namespace

PhsParams WithStepFit(const PhsParams& declared, const StepFit& fit, const StepFreedom& freedom) {
  PhsParams out = declared;
  const auto& c = out.cylinders[0];
  auto& bore = out.lines[out.FindLine(c.bore_line)];
  auto& rod = out.lines[out.FindLine(c.rod_line)];
  for (auto* line : {&bore, &rod}) {
    line->oil_volume_m3 = fit.oil_compliance_m3_per_Pa * line->bulk_modulus_Pa;
  }
  bore.gas_volume_m3 = fit.gas_bore_m3;
  rod.gas_volume_m3 = fit.gas_rod_m3;
  if (freedom.stop) {
    bore.reservoir.min_gas_volume_m3 = fit.min_gas_bore_m3;
    rod.reservoir.min_gas_volume_m3 = fit.min_gas_rod_m3;
  }
  if (freedom.filling) {
    bore.static_pressure_Pa = fit.static_bore_Pa;
    rod.static_pressure_Pa = fit.static_rod_Pa;
  }
  if (freedom.precharge) rod.accumulator_precharge_Pa = fit.precharge_Pa;
  return out;
}

Result<StepFit> FitSteps(const PhsParams& declared, const std::vector<StepRow>& rows,
                         const StepFreedom& freedom) {
  if (rows.empty()) return Error{"steps", "no row to fit to", "at least one valid row"};
  if (declared.cylinders.size() != 1 || declared.FindLine(declared.cylinders[0].bore_line) < 0 ||
      declared.FindLine(declared.cylinders[0].rod_line) < 0) {
    return Error{declared.name, "is no quarter rig", "one cylinder with a bore and a rod line"};
  }
  const Vector start = StartLogs(declared);
  Vector q = start;
  Result<Vector> r = Residuals(declared, rows, q, start, freedom);
  if (!r.ok()) return r.error();
  double damping = 1e-2;
  for (int iteration = 0; iteration < 60; ++iteration) {
    Eigen::MatrixXd J(r.value().size(), kParameters);
    for (int k = 0; k < kParameters; ++k) {
      Vector nudged = q;
      nudged[k] += 1e-5;
      Result<Vector> rk = Residuals(declared, rows, nudged, start, freedom);
      if (!rk.ok()) return rk.error();
      J.col(k) = (rk.value() - r.value()) / 1e-5;
    }
    Eigen::MatrixXd normal = J.transpose() * J;
    Vector slope = J.transpose() * r.value();
    Pin(freedom, &normal, &slope);
    bool better = false;
    double move = 0;
    for (int attempt = 0; attempt < 12 && !better; ++attempt) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() *= 1 + damping;
      Vector step = -damped.ldlt().solve(slope);
      for (int k = 0; k < kParameters; ++k) step[k] = std::clamp(step[k], -0.5, 0.5);
      Result<Vector> next = Residuals(declared, rows, q + step, start, freedom);
      better = next.ok() && next.value().squaredNorm() < r.value().squaredNorm();
      damping = better ? std::max(damping / 4, 1e-9) : damping * 4;
      if (!better) continue;
      q += step;
      move = step.norm();
      r = std::move(next);
    }
    if (!better || move < 1e-7) break;
  }
  StepFit fit = FromLogs(q, freedom);
  Result<std::vector<double>> p = PredictSettled(WithStepFit(declared, fit, freedom), rows);
  if (!p.ok()) return p.error();
  fit.error_in_sample = MeanRelativeError(p.value(), Measured(rows));
  return fit;
}

Result<StepComparison> CompareSteps(const PhsParams& declared, const std::vector<StepRow>& rows,
                                    const StepFreedom& freedom) {
  StepComparison out;
  std::vector<double> steps;
  for (const StepRow& row : rows) {
    // Rows 5 and 6 of Table B-1 hold no relaxation, but their settled pressures are measured.
    if (row.end_Pa <= 0) continue;
    out.rows.push_back(row);
    if (std::find(steps.begin(), steps.end(), row.actuator_step_m) == steps.end()) {
      steps.push_back(row.actuator_step_m);
    }
  }
  Result<std::vector<double>> before = PredictSettled(declared, out.rows);
  if (!before.ok()) return before.error();
  Result<StepFit> fit = FitSteps(declared, out.rows, freedom);
  if (!fit.ok()) return fit.error();
  out.fit = fit.value();
  Result<std::vector<double>> fitted =
      PredictSettled(WithStepFit(declared, out.fit, freedom), out.rows);
  if (!fitted.ok()) return fitted.error();
  out.declared_Pa = std::move(before.value());
  out.fitted_Pa = std::move(fitted.value());
  out.left_out_Pa.assign(out.rows.size(), 0.0);
  for (const double step : steps) {
    std::vector<StepRow> kept, left;
    for (const StepRow& row : out.rows) (row.actuator_step_m == step ? left : kept).push_back(row);
    Result<StepFit> other = FitSteps(declared, kept, freedom);
    if (!other.ok()) return other.error();
    Result<std::vector<double>> p =
        PredictSettled(WithStepFit(declared, other.value(), freedom), left);
    if (!p.ok()) return p.error();
    for (size_t i = 0, k = 0; i < out.rows.size(); ++i) {
      if (out.rows[i].actuator_step_m == step) out.left_out_Pa[i] = p.value()[k++];
    }
    out.without.push_back(other.value());
  }
  const std::vector<double> measured = Measured(out.rows);
  out.error_declared = MeanRelativeError(out.declared_Pa, measured);
  out.error_fitted = MeanRelativeError(out.fitted_Pa, measured);
  out.error_left_out = MeanRelativeError(out.left_out_Pa, measured);
  return out;
}

}  // namespace phs::rigs
