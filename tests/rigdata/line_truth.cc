#include "line_truth.h"

#include <algorithm>
#include <cmath>

namespace rigdata {
namespace {

constexpr double kAtmosphere = 1.0e5;  // Pa
constexpr double kLowest = 1.0e3;      // Pa, the solver's floor

}  // namespace

double LeakPath::Flow(double d) const {
  if (conductance == 0) return 0;
  switch (form) {
    case LeakForm::kLaminar:
      return conductance * d;
    case LeakForm::kOrifice:
      return conductance * d / std::sqrt(std::sqrt(d * d + 4.0e6));
    case LeakForm::kWidening:
      return conductance * d * (1.0 + std::abs(d) / 1.0e7);
  }
  return 0;
}

LineTruth::LineTruth(const LineParams& params) : params_(params) {
  has_segment_ = params_.laminar[0] > 0 || params_.laminar[1] > 0 || params_.turbulent[0] > 0 ||
                 params_.turbulent[1] > 0 || params_.inertance > 0;
}

double LineTruth::GasVolume(double p, double temperature, double* softness) const {
  const double free = params_.gas_volume0 * (params_.p0 / p) * (temperature / kT0);
  if (softness != nullptr) *softness = free / p;
  if (params_.gas_stop <= 0) return free;
  // Smooth maximum of the free volume and the stop (a hyperbola), less its offset at p0.
  const double width = params_.gas_stop_softness * params_.gas_stop;
  const double above = free - params_.gas_stop;
  const double root = std::sqrt(above * above + 4.0 * width * width);
  if (softness != nullptr) *softness *= 0.5 * (1.0 + above / root);
  return params_.gas_stop + 0.5 * (above + root);
}

LineState LineTruth::Initial() const {
  LineState state;
  state.p_chamber = state.p_remote = params_.p0;
  state.gas_volume = GasVolume(params_.p0, kT0, nullptr);
  if (params_.air_form == AirForm::kLaggingDissolution) {
    state.air_free = std::max(0.0, 1.0 - params_.p0 / params_.air_saturation);
  }
  return state;
}

double LineTruth::Volume(double p, const LineState& state, double h, const Surroundings& s,
                         double* derivative) const {
  const LineParams& q = params_;
  const double d = p - q.p0;
  double compliance = q.oil_compliance * (1.0 + s.compliance_growth);
  if (has_segment_) compliance *= 1.0 - q.chamber_share;
  const double softening = 1.0 + 0.5 * q.oil_stiffening * d;
  double volume = compliance * d / softening;
  double slope = compliance / (softening * softening);

  double gas_slope = 0;
  volume += GasVolume(q.p0, kT0, nullptr) - GasVolume(p, state.gas_temperature, &gas_slope);
  slope += gas_slope;

  if (q.blow_off_volume > 0 && p > q.blow_off_precharge) {
    volume += q.blow_off_volume * (1.0 - q.blow_off_precharge / p);
    slope += q.blow_off_volume * q.blow_off_precharge / (p * p);
  }
  if (q.air_volume > 0) {
    const double n = q.air_form == AirForm::kPolytropicDissolving ? q.air_exponent : 1.0;
    const bool lagging = q.air_form == AirForm::kLaggingDissolution;
    const auto free_share = [&](double pressure) {
      return lagging ? state.air_free : std::max(0.0, 1.0 - pressure / q.air_saturation);
    };
    const double shape = std::pow(q.p0 / p, 1.0 / n);
    const double share = free_share(p);
    const double start = std::max(0.0, 1.0 - q.p0 / q.air_saturation);
    volume += q.air_volume * (start - shape * share);
    slope += q.air_volume * shape *
             (share / (n * p) + (!lagging && share > 0 ? 1.0 / q.air_saturation : 0.0));
  }
  if (q.hose_volume > 0) {
    if (q.hose_form == HoseForm::kStiffening) {
      const double e = std::exp(-p / q.hose_scale), e0 = std::exp(-q.p0 / q.hose_scale);
      volume += q.hose_volume * (e0 - e);
      slope += q.hose_volume * e / q.hose_scale;
    } else {
      // τ ẇ = c (p − p0) − w, implicit over the step.
      const double c = q.hose_volume / 1.0e7, a = h / (q.hose_tau + h);
      volume += state.hose_flow + a * (c * d - state.hose_flow);
      slope += a * c;
    }
  }
  if (q.vapour_volume > 0 && p < q.vapour_pressure) {
    if (q.vapour_form == VapourForm::kRelease) {
      volume -= q.vapour_volume * (q.vapour_pressure / p - 1.0);
      slope += q.vapour_volume * q.vapour_pressure / (p * p);
    } else {
      const double below = (q.vapour_pressure - p) / q.vapour_pressure;
      volume -= 20.0 * q.vapour_volume * below * below;
      slope += 40.0 * q.vapour_volume * below / q.vapour_pressure;
    }
  }
  if (derivative != nullptr) *derivative = slope;
  return volume;
}

double LineTruth::SolveRemote(double volume, double guess, const LineState& state, double h,
                              const Surroundings& s) const {
  double low = kLowest, high = 2.0e8, p = std::clamp(guess, low, high);
  for (int i = 0; i < 80; ++i) {
    double slope = 0;
    const double excess = Volume(p, state, h, s, &slope) - volume;
    (excess > 0 ? high : low) = p;
    double next = p - excess / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - p) <= 1e-12 * p) return next;
    p = next;
  }
  return p;
}

double LineTruth::ChamberPressure(double volume) const {
  return params_.p0 + volume / (params_.oil_compliance * params_.chamber_share);
}

LineState LineTruth::Solve(const LineState& state, double x, double h,
                           const Surroundings& s) const {
  LineState next = state;
  const double displaced = params_.area * x + params_.oil_volume * s.oil_expansion - state.lost;
  if (!has_segment_) {
    next.p_remote = next.p_chamber = SolveRemote(displaced, state.p_remote, state, h, s);
    return next;
  }
  // One unknown, the flow at the end of the step; the balance falls monotonically with it.
  double low = -1.0, high = 1.0, flow = state.flow;
  const double chamber_slope = h / (params_.oil_compliance * params_.chamber_share);
  for (int i = 0; i < 80; ++i) {
    next.transferred = state.transferred + h * flow;
    next.p_chamber = ChamberPressure(displaced - next.transferred);
    next.p_remote = SolveRemote(next.transferred, next.p_remote, state, h, s);
    double remote_slope = 0;
    Volume(next.p_remote, state, h, s, &remote_slope);
    const int side = flow >= 0 ? 0 : 1;
    const double r = params_.laminar[side], t = params_.turbulent[side];
    const double inertia = params_.inertance / h;
    const double excess = next.p_chamber - next.p_remote - inertia * (flow - state.flow) -
                          r * flow - t * flow * std::abs(flow);
    const double slope =
        -(chamber_slope + h / remote_slope + inertia + r + 2.0 * t * std::abs(flow));
    (excess > 0 ? low : high) = flow;
    double step = flow - excess / slope;
    if (!(step > low && step < high)) step = 0.5 * (low + high);
    if (std::abs(step - flow) <= 1e-13 + 1e-10 * std::abs(flow)) break;
    flow = step;
  }
  next.flow = flow;
  return next;
}

double LineTruth::ReliefFlow(double p) const {
  if (params_.relief_pressure <= 0) return 0;
  return params_.relief_conductance * std::max(0.0, p - params_.relief_pressure);
}

void LineTruth::Advance(LineState& solved, const LineState& before, double h, double cross_flow,
                        const Surroundings& s) const {
  const LineParams& q = params_;
  const double p = solved.p_remote;
  solved.gas_volume = GasVolume(p, solved.gas_temperature, nullptr);
  solved.lost += h * (cross_flow + q.leak.Flow(solved.p_chamber - kAtmosphere) + ReliefFlow(p));

  if (q.gas_tau > 0) {
    // m c_v Ṫ = −p V̇ + heat; the adiabatic part in closed form, T ∝ V^(−R/c_v), then the wall.
    double t =
        solved.gas_temperature * std::pow(before.gas_volume / solved.gas_volume, q.gas_coupling);
    const double exchanged = (solved.wall_temperature - t) * h / (q.gas_tau + h);
    t += exchanged;
    solved.gas_temperature = t;
    if (q.wall_tau > 0) {
      solved.wall_temperature -= q.wall_ratio * exchanged;
      solved.wall_temperature +=
          (s.reservoir_temperature - solved.wall_temperature) * h / (q.wall_tau + h);
    } else {
      solved.wall_temperature = s.reservoir_temperature;
    }
  } else {
    solved.gas_temperature = s.reservoir_temperature;
  }
  if (q.air_form == AirForm::kLaggingDissolution && q.air_volume > 0) {
    const double target = std::max(0.0, 1.0 - p / q.air_saturation);
    solved.air_free += (target - solved.air_free) * h / (q.air_lag + h);
  }
  if (q.hose_form == HoseForm::kViscoelastic && q.hose_volume > 0) {
    const double c = q.hose_volume / 1.0e7;
    solved.hose_flow += (c * (p - q.p0) - solved.hose_flow) * h / (q.hose_tau + h);
  }
}

}  // namespace rigdata
