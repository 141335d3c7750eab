#include "friction_truth.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace rigdata {
namespace {

struct TablePoint {
  double v, force;
};
constexpr TablePoint kTable[] = {{-0.05, -1900},   {-0.01, -1700}, {-0.001, -1600},
                                 {-0.0002, -1500}, {0, 0},         {0.0002, 1700},
                                 {0.001, 1850},    {0.01, 1950},   {0.05, 2150}};
constexpr double kSoftSpeed = 0.0002;  // m/s

// Shares of the sliding level and of the breakaway distance of the Maxwell-slip elements.
constexpr double kSlipShare[kMaxwellElements] = {0.10, 0.15, 0.20, 0.20, 0.20, 0.15};
constexpr double kSlipDistance[kMaxwellElements] = {0.15, 0.35, 0.7, 1.2, 1.9, 3.0};

}  // namespace

double FrictionTruth::Table(double v) {
  const int count = static_cast<int>(std::size(kTable));
  int i = 1;
  while (i < count - 1 && v > kTable[i].v) ++i;
  const TablePoint a = kTable[i - 1], b = kTable[i];
  return a.force + (b.force - a.force) * (v - a.v) / (b.v - a.v);
}

double FrictionTruth::SoftSign(double v) { return std::clamp(v / kSoftSpeed, -1.0, 1.0); }

double FrictionTruth::Level(double v) const {
  const double away = v >= 0 ? std::max(v, kSoftSpeed) : std::min(v, -kSoftSpeed);
  return params_.scale * std::abs(Table(away));
}

double FrictionTruth::Presliding(const FrictionState& before, double v, double h,
                                 FrictionState* after) const {
  const double level = Level(v);
  switch (params_.presliding) {
    case PreslidingForm::kNone:
      break;
    case PreslidingForm::kLuGre: {
      // ż = v − |v| z / z_ss, implicit; z_ss = level / stiffness.
      const double stiffness = params_.scale * 1700.0 / params_.presliding_distance;
      const double limit = level / stiffness;
      const double z = (before.strain[0] + h * v) / (1.0 + h * std::abs(v) / limit);
      after->strain[0] = z;
      const double rate = (z - before.strain[0]) / h;
      const double fade = std::exp(-(v / 2e-3) * (v / 2e-3));
      return stiffness * z + params_.presliding_damping * fade * rate;
    }
    case PreslidingForm::kMaxwellSlip: {
      double force = 0;
      for (int i = 0; i < kMaxwellElements; ++i) {
        const double most = kSlipDistance[i] * params_.presliding_distance;
        const double z = std::clamp(before.strain[i] + h * v, -most, most);
        after->strain[i] = z;
        force += kSlipShare[i] * level * z / most;
      }
      return force;
    }
    case PreslidingForm::kDahl: {
      // dF/dx = stiffness (1 − F sgn v / level)²; in closed form over the step at constant level.
      const double force = before.strain[0];
      const double sign = v >= 0 ? 1.0 : -1.0;
      const double gap = 1.0 - force * sign / level;
      const double travelled =
          std::abs(h * v) * params_.scale * 1700.0 / (params_.presliding_distance * level);
      const double left = gap > 0 ? gap / (1.0 + gap * travelled) : gap * std::exp(-travelled);
      after->strain[0] = sign * level * (1.0 - left);
      return after->strain[0];
    }
  }
  return 0;
}

double FrictionTruth::PositionFactor(double x) const {
  const double u = (x - params_.position_centre) / params_.position_length;
  switch (params_.position) {
    case PositionFrictionForm::kNone:
      return 1;
    case PositionFrictionForm::kLinear:
      return std::max(0.1, 1.0 + params_.position_share * u);
    case PositionFrictionForm::kTightSpot:
      return 1.0 + params_.position_share * std::exp(-4.0 * u * u);
    case PositionFrictionForm::kWave:
      return 1.0 + params_.position_share * std::sin(2.0 * std::numbers::pi * u);
  }
  return 1;
}

double FrictionTruth::Extras(const FrictionState& state, const FrictionInput& in) const {
  const double speed = std::abs(in.v), ratio = speed / params_.stribeck_speed;
  double force = 0;
  switch (params_.stribeck) {
    case StribeckForm::kNone:
      break;
    case StribeckForm::kGaussian:
      force += params_.stribeck_force * std::exp(-ratio * ratio);
      break;
    case StribeckForm::kExponential:
      force += params_.stribeck_force * std::exp(-ratio);
      break;
    case StribeckForm::kLorentz:
      force += params_.stribeck_force / (1.0 + ratio * ratio);
      break;
  }
  switch (params_.pressure) {
    case PressureFrictionForm::kNone:
      break;
    case PressureFrictionForm::kSum:
      force += params_.pressure_area * 0.5 * (in.p_bore + in.p_rod);
      break;
    case PressureFrictionForm::kDifference:
      force += params_.pressure_area * std::abs(in.p_bore - in.p_rod);
      break;
    case PressureFrictionForm::kRodSeal:
      force += params_.pressure_area * in.p_rod;
      break;
  }
  switch (params_.dwell) {
    case DwellForm::kNone:
      break;
    case DwellForm::kAgeing:
      force += params_.dwell_force * std::log1p(state.rest_age / params_.dwell_time);
      break;
    case DwellForm::kSaturating:
      force += params_.dwell_force * (1.0 - std::exp(-state.rest_age / params_.dwell_time));
      break;
  }
  force *= SoftSign(in.v);
  const double u = speed / 0.02;
  const double sign = in.v >= 0 ? 1.0 : -1.0;
  switch (params_.viscous) {
    case ViscousForm::kNone:
      break;
    case ViscousForm::kLinear:
      force += params_.viscous_force * in.v / 0.02;
      break;
    case ViscousForm::kRoot:
      force += params_.viscous_force * sign * std::pow(u, 0.7);
      break;
    case ViscousForm::kSquare:
      force += params_.viscous_force * sign * u * u;
      break;
  }
  return force;
}

double FrictionTruth::Force(const FrictionState& before, const FrictionInput& in, double h,
                            FrictionState* after) const {
  *after = before;
  after->time = before.time + h;
  // θ̇ = 1 − |v| θ / D (Dieterich's ageing law), implicit.
  after->rest_age = (before.rest_age + h) / (1.0 + h * std::abs(in.v) / params_.dwell_distance);
  double base = params_.scale * Table(in.v);
  if (params_.presliding != PreslidingForm::kNone) {
    base += params_.presliding_share * (Presliding(before, in.v, h, after) - base);
  }
  base *= PositionFactor(in.x);
  base *= 1.0 + params_.asymmetry * SoftSign(in.v);
  base *= std::max(0.2, 1.0 - params_.heating_share * before.heat / 100.0);
  base *= 1.0 + params_.swelling_share * (1.0 - std::exp(-after->time / params_.swelling_tau));
  if (params_.acceleration_share != 0) {
    const double along = in.acceleration * SoftSign(in.v) / 0.1;
    base *= 1.0 + params_.acceleration_share * std::tanh(along);
  }
  const double force = base + Extras(*after, in);
  after->heat = (before.heat + h * std::abs(force * in.v)) / (1.0 + h / params_.heating_tau);
  return force;
}

}  // namespace rigdata
