#include "hydraulics/friction.h"

#include <algorithm>
#include <cmath>

namespace phs::hydraulics {

Friction::Friction(const FrictionParams& params, const FrictionTerms& terms)
    : model_(params.model), curve_(params.curve), terms_(terms), scale_(params.scale) {
  if (curve_ == FrictionCurve::kTable) {
    for (size_t i = 0; i < params.speed_m_s.size(); ++i) {
      const double v = params.speed_m_s[i];
      if (v > 0) {
        speed_[0].push_back(v);
        level_[0].push_back(params.force_N[i]);
      }
    }
    for (size_t i = params.speed_m_s.size(); i-- > 0;) {
      const double v = params.speed_m_s[i];
      if (v < 0) {
        speed_[1].push_back(-v);
        level_[1].push_back(-params.force_N[i]);
      }
    }
    for (int side : {0, 1}) ramp_[side] = speed_[side].empty() ? 1 : speed_[side][0];
  } else {
    coulomb_[0] = params.coulomb_extension_N;
    coulomb_[1] = params.coulomb_retraction_N;
    breakaway_[0] = params.breakaway_extension_N;
    breakaway_[1] = params.breakaway_retraction_N;
    viscous_[0] = params.viscous_extension_Ns_per_m;
    viscous_[1] = params.viscous_retraction_Ns_per_m;
    stribeck_speed_ = params.stribeck_speed_m_s;
    ramp_[0] = ramp_[1] = params.ramp_speed_m_s;
  }
  extra_[0] = terms.stribeck_extra_extension_N;
  extra_[1] = terms.stribeck_extra_retraction_N;
  extra_viscous_[0] = terms.viscous_extension_Ns_per_m;
  extra_viscous_[1] = terms.viscous_retraction_Ns_per_m;
  sigma1_ = params.damping_Ns_per_m;
  sigma0_ = params.stiffness_N_per_m;
  ratio_ = params.breakaway_ratio;
  if (terms.presliding && model_ != FrictionModel::kNone) {
    model_ = FrictionModel::kPresliding;
    sigma0_ = terms.presliding_stiffness_N_per_m;
    ratio_ = terms.presliding_breakaway_ratio;
    creeps_ = terms.presliding_creeps;
    exponent_ = terms.presliding_exponent;
    share_ = terms.presliding_share;
  }
  if (model_ != FrictionModel::kPresliding) sigma0_ = sigma1_ = 0;
}

double Friction::Curve(int side, double speed) const {
  if (curve_ == FrictionCurve::kCoulomb) {
    const double stribeck =
        (breakaway_[side] - coulomb_[side]) * std::exp(-speed / stribeck_speed_);
    return coulomb_[side] + stribeck + viscous_[side] * speed;
  }
  const std::vector<double>& v = speed_[side];
  const std::vector<double>& f = level_[side];
  if (speed <= v[0] || v.size() == 1) return f[0];
  size_t i = 1;
  while (i + 1 < v.size() && speed > v[i]) ++i;
  return f[i - 1] + (f[i] - f[i - 1]) * (speed - v[i - 1]) / (v[i] - v[i - 1]);
}

double Friction::PositionFactor(double piston) const {
  const FrictionTerms& t = terms_;
  double shape = 1 + (t.position_slope_1_per_m + t.position_curvature_1_per_m2 * piston) * piston;
  if (t.spot_share != 0) {
    const double away = (piston - t.spot_centre_m) / t.spot_width_m;
    shape += t.spot_share * std::exp(-away * away);
  }
  if (t.wave_sine != 0 || t.wave_cosine != 0) {
    const double phase = 2 * M_PI * piston / t.wave_length_m;
    shape += t.wave_sine * std::sin(phase) + t.wave_cosine * (std::cos(phase) - 1);
  }
  return std::max(shape, 0.0);
}

double Friction::Viscous(double v) const {
  constexpr double kReference = 1e-2, kSmooth = 1e-4;  // [m/s]
  double force = extra_viscous_[v > 0 ? 0 : 1] * v;
  if (force != 0 && terms_.viscous_exponent != 1) {
    force *= std::pow((v * v + kSmooth * kSmooth) / (kReference * kReference),
                      0.5 * (terms_.viscous_exponent - 1));
  }
  return force;
}

double Friction::Level(int sign, double speed, const FrictionPlace& place) const {
  const int side = sign > 0 ? 0 : 1;
  double level = scale_ * Curve(side, speed);
  level *= PositionFactor(place.piston);
  if (extra_[side] != 0) {
    const double ratio = speed / terms_.stribeck_speed_m_s, n = terms_.stribeck_exponent;
    level += extra_[side] * std::exp(-(n == 1 ? ratio : std::pow(ratio, n)));
  }
  level += sign > 0 ? terms_.level_shift_N : -terms_.level_shift_N;
  level += terms_.dwell_extra_N * place.rested;
  double grip = terms_.pressure_bore_N_per_Pa * place.bore_rise +
                terms_.pressure_rod_N_per_Pa * place.rod_rise;
  if (terms_.pressure_difference_N_per_Pa != 0) {
    const double rest = terms_.static_difference_Pa;
    grip += terms_.pressure_difference_N_per_Pa *
            (std::abs(rest + place.bore_rise - place.rod_rise) - std::abs(rest));
  }
  level += sign > 0 ? grip : terms_.pressure_retraction_ratio * grip;
  level *= std::max(1 - terms_.temperature_slope_1_per_K * place.warmer, 0.0);
  return std::max(level, 0.0);
}

namespace {

double SignedPower(double x, double n) { return std::copysign(std::pow(std::abs(x), n), x); }

/// Dahl's g after a travel x [z_s]: dg/dx = -sgn(g) |g|^i.
double GapAfter(double gap, double x, double exponent) {
  if (std::abs(exponent - 1) < 1e-9 || gap == 0) return gap * std::exp(-x);
  const double left = std::pow(std::abs(gap), 1 - exponent) + (exponent - 1) * x;
  return left > 0 ? std::copysign(std::pow(left, 1 / (1 - exponent)), gap) : 0;
}

}  // namespace

FrictionForce Friction::Calc(double v, double z, const FrictionPlace& place) const {
  FrictionForce out;
  const int sign = v > 0 ? 1 : -1;
  const int side = v > 0 ? 0 : 1;
  const double speed = std::abs(v);
  double viscous = Viscous(v);
  if (model_ == FrictionModel::kNone) {
    out.force = viscous;
  } else if (model_ == FrictionModel::kStatic) {
    out.force = sign * Level(sign, speed, place) * std::min(speed / ramp_[side], 1.0) + viscous;
  } else {
    const double level = Level(sign, speed, place);
    if (share_ < 1) viscous += sign * (1 - share_) * level * std::min(speed / ramp_[side], 1.0);
    const double z_s = share_ * level / sigma0_, z_b = ratio_ * z_s;
    const double along = sign * z;
    double yield = 0;  // alpha z/z_s
    if (z_s > 0 && creeps_) {
      yield = exponent_ == 1 ? along / z_s : 1 - SignedPower(1 - along / z_s, exponent_);
    } else if (z_s > 0 && along > z_b) {
      yield = (along - z_b) / (z_s - z_b) * along / z_s;
    }
    if (z_s <= 0 && along >= 0) yield = 1;
    out.bristle_speed = v * (1 - yield);
    const double damped = v * std::max(1 - yield, 0.0);
    out.force = sigma0_ * z + sigma1_ * damped + viscous;
    out.lost_power = sigma0_ * z * v * yield + (sigma1_ * damped + viscous) * v;
  }
  if (model_ != FrictionModel::kPresliding) out.lost_power = out.force * v;
  if (terms_.further != nullptr) {
    const double further = Further(v, z, place);
    out.force += further;
    out.lost_power += further * v;
  }
  return out;
}

double Friction::Damping(double v, double z, const FrictionPlace& place) const {
  const double faster = v + std::copysign(1e-7 + 1e-4 * std::abs(v), v);
  return std::max(0.0, (Calc(faster, z, place).force - Calc(v, z, place).force) / (faster - v));
}

double Friction::Direction(double v, double z, const FrictionPlace& place) const {
  constexpr double kRamp = 1e-4;  // [m/s] where there is no friction to tell
  if (model_ == FrictionModel::kNone) return v / std::hypot(v, kRamp);
  const int sign = v > 0 ? 1 : -1;
  if (model_ == FrictionModel::kStatic) {
    return sign * std::min(std::abs(v) / ramp_[v > 0 ? 0 : 1], 1.0);
  }
  const double level = share_ * Level(z > 0 ? 1 : -1, std::abs(v), place);
  return level > 0 ? std::clamp(sigma0_ * z / level, -1.0, 1.0) : 0;
}

double Friction::Further(double v, double z, const FrictionPlace& place) const {
  return terms_.further->Force({place.time, place.piston, v, Direction(v, z, place),
                                place.bore_rise, place.rod_rise, place.warmer});
}

double Friction::Advance(double h, double v, double z, const FrictionPlace& place) const {
  double left = std::abs(v) * h;
  if (left <= 0) return z;
  const int sign = v > 0 ? 1 : -1;
  double along = sign * z;
  const double z_s = share_ * Level(sign, std::abs(v), place) / sigma0_;
  if (!(z_s > 0)) return sign * std::min(along + left, 0.0);
  if (creeps_) return sign * z_s * (1 - GapAfter(1 - along / z_s, left / z_s, exponent_));
  const double z_b = ratio_ * z_s;
  if (along < z_b) {
    const double elastic = std::min(left, z_b - along);
    along += elastic;
    left -= elastic;
  }
  if (left > 0) {
    const double k = (2 * z_s - z_b) / (z_s * (z_s - z_b));
    const double q = (z_s - along) / (along + z_s - z_b) * std::exp(-k * left);
    along = (z_s - q * (z_s - z_b)) / (1 + q);
  }
  return sign * along;
}

double Friction::DwellRate(double v, double eta) const {
  return -eta / terms_.dwell_time_s + (1 - eta) * std::abs(v) / terms_.dwell_length_m;
}

double Friction::AdvanceDwell(double h, double v, double eta) const {
  const double moved = std::abs(v) / terms_.dwell_length_m;
  const double rate = 1 / terms_.dwell_time_s + moved;
  const double settled = moved / rate;
  return settled + (eta - settled) * std::exp(-rate * h);
}

double Friction::MaxDamping() const {
  double most = 0;
  for (int side : {0, 1}) {
    double c = extra_viscous_[side];
    if (model_ == FrictionModel::kStatic) {
      c += Level(side == 0 ? 1 : -1, ramp_[side], FrictionPlace{}) / ramp_[side];
    } else {
      c += sigma1_;
      if (share_ < 1) {
        const double rest = Level(side == 0 ? 1 : -1, ramp_[side], FrictionPlace{});
        c += (1 - share_) * rest / ramp_[side];
      }
    }
    most = std::max(most, c);
  }
  return most;
}

}  // namespace phs::hydraulics
