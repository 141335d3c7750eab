#include "analysis/mode_closed_form.h"

#include <complex>
#include <numbers>

#include "plugin/active_steering.h"

namespace phs::analysis {
namespace {

constexpr double kAtmosphere_Pa = 101325;
constexpr double kAdiabatic = 1.4;  ///< nitrogen

double CalcSprings(const plugin::Binding& binding, const mjModel* m, const mjData* d,
                   const AxlePattern& pattern, const PatternJoints& joints) {
  std::vector<double> along(static_cast<size_t>(m->nv), 0.0);
  for (int k = 0; k < 2; ++k) along[static_cast<size_t>(joints.dof[k])] += pattern.sign[k];
  double sum = 0;
  for (const auto& elements : binding.elements()) {
    elements->AddStiffness(m, d, along.data(), &sum);
  }
  plugin::ForEachSteering(m, [&](const plugin::ActiveSteering& servo) {  // told nothing: a spring
    const double moved = mju_dot(along.data(), d->actuator_moment + servo.actuator * m->nv, m->nv);
    sum -= m->actuator_biasprm[mjNBIAS * servo.actuator + 1] * moved * moved;
  });
  return sum;
}

/// n of p V^n = const about the static pressure.
std::complex<double> CalcGasExponent(const hydraulics::GasChargeParams& gas, double pressure,
                                     double omega) {
  if (gas.law->capacity == nullptr) {
    hydraulics::GasVolume unit{.law = gas.law,
                               .reference_volume = 1,
                               .reference_pressure = pressure,
                               .reference_temperature = 293.15,
                               .exponent = gas.polytropic_exponent,
                               .max_volume = 2};
    unit.SetMass();
    const hydraulics::GasState at = hydraulics::CalcGas(unit, pressure, unit.reference_temperature);
    return -at.volume / (pressure * at.dV_dp);
  }
  const std::complex<double> lag(0, omega * gas.thermal_time_s);
  return (1.0 + kAdiabatic * lag) / (1.0 + lag);
}

/// Re 1/C [Pa/m3].
double CalcLineStiffness(const hydraulics::LineParams& line, double omega) {
  const double p = line.static_pressure_Pa;
  std::complex<double> compliance = line.oil_volume_m3 / line.bulk_modulus_Pa;
  compliance += line.free_air_m3 * kAtmosphere_Pa / (p * p);
  compliance += line.gas_volume_m3 / (CalcGasExponent(line.reservoir, p, omega) * p);
  return (1.0 / compliance).real();
}

double CalcLines(const hydraulics::PhsParams& params, const std::vector<double>& strokes,
                 double omega) {
  double sum = 0;
  for (const hydraulics::LineParams& line : params.lines) {
    double lost = 0;
    for (size_t i = 0; i < params.cylinders.size(); ++i) {
      const hydraulics::CylinderParams& cylinder = params.cylinders[i];
      if (cylinder.bore_line == line.name) lost -= cylinder.BoreArea() * strokes[i];
      if (cylinder.rod_line == line.name) lost += cylinder.RodArea() * strokes[i];
    }
    sum += lost * lost * CalcLineStiffness(line, omega);
  }
  return sum;
}

}  // namespace

std::vector<double> CalcStrokes(const plugin::PhsBinding& phs, const mjModel* m, const mjData* d,
                                const AxlePattern& pattern, const PatternJoints& joints) {
  std::vector<double> strokes;
  for (const int actuator : phs.cylinder) {
    double stroke = 0;
    for (int k = 0; k < 2; ++k) {
      stroke += pattern.sign[k] * d->actuator_moment[actuator * m->nv + joints.dof[k]];
    }
    strokes.push_back(stroke);
  }
  return strokes;
}

ModeClosedForm CalcModeClosedForm(const plugin::Binding& binding, const mjModel* m, const mjData* d,
                                  const AxlePattern& pattern, const PatternJoints& joints,
                                  double frequency_Hz) {
  const double omega = 2 * std::numbers::pi * frequency_Hz;
  ModeClosedForm form;
  form.springs = CalcSprings(binding, m, d, pattern, joints);
  for (const plugin::PhsBinding& phs : binding.phs()) {
    const std::vector<double> strokes = CalcStrokes(phs, m, d, pattern, joints);
    const hydraulics::PhsParams& params = phs.system->params();
    form.lines += CalcLines(params, strokes, omega);
    if (params.friction.model != hydraulics::FrictionModel::kPresliding) continue;
    for (const double stroke : strokes) {
      form.seals += params.friction.stiffness_N_per_m * stroke * stroke;
    }
  }
  return form;
}

}  // namespace phs::analysis
