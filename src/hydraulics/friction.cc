#include "hydraulics/friction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace phs::hydraulics {

Friction::Friction(const FrictionParams& params, FrictionLaws laws)
    : model_(params.model), curve_(params.curve), laws_(std::move(laws)), scale_(params.scale) {
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
  sigma1_ = params.damping_Ns_per_m;
  sigma0_ = params.stiffness_N_per_m;
  declared_.ratio = params.breakaway_ratio;
  if (model_ == FrictionModel::kNone) laws_.bristle.reset();
  if (laws_.bristle) {
    model_ = FrictionModel::kPresliding;
    sigma0_ = laws_.bristle->Stiffness();
    share_ = laws_.bristle->Share();
  }
  if (model_ != FrictionModel::kPresliding) sigma0_ = sigma1_ = 0;
  for (const auto& law : laws_.levels) {
    depends_on_pressure_ |= law->DependsOnPressure();
    const bool remembers = !law->MemoryName().empty();
    memory_of_.push_back(remembers ? num_memories() : -1);
    if (!remembers) continue;
    with_memory_.push_back(law.get());
    memory_names_.push_back(law->MemoryName());
  }
  for (const auto& law : laws_.forces) {
    depends_on_pressure_ |= !law->OfSpeedAlone();
    needs_direction_ |= !law->OfSpeedAlone();
    state_of_.push_back(num_memories());
    for (std::string& name : law->StateNames()) memory_names_.push_back(std::move(name));
  }
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

double Friction::Level(int sign, double speed, const FrictionPlace& place) const {
  const double curve = scale_ * Curve(sign > 0 ? 0 : 1, speed);
  if (laws_.levels.empty()) return std::max(curve, 0.0);
  LevelParts level;
  for (size_t i = 0; i < laws_.levels.size(); ++i) {
    const int k = memory_of_[i];
    const double memory = k >= 0 && place.memory != nullptr ? place.memory[k] : 0;
    laws_.levels[i]->Add({sign, speed, place, memory}, &level);
  }
  return std::max((curve * level.of_curve + level.extra) * level.of_all, 0.0);
}

double Friction::Yield(double along, double z_s) const {
  if (z_s <= 0) return along >= 0 ? 1 : 0;
  return laws_.bristle ? laws_.bristle->Yield(along, z_s) : declared_.Yield(along, z_s);
}

FrictionForce Friction::Calc(double v, double z, const FrictionPlace& place) const {
  FrictionForce out;
  const int sign = v > 0 ? 1 : -1;
  const int side = v > 0 ? 0 : 1;
  const double speed = std::abs(v);
  if (model_ == FrictionModel::kStatic) {
    out.force = sign * Level(sign, speed, place) * std::min(speed / ramp_[side], 1.0);
    out.lost_power = out.force * v;
  } else if (model_ == FrictionModel::kPresliding) {
    const double level = Level(sign, speed, place);
    double slides = 0;
    if (share_ < 1) slides = sign * (1 - share_) * level * std::min(speed / ramp_[side], 1.0);
    const double yield = Yield(sign * z, share_ * level / sigma0_);
    out.bristle_speed = v * (1 - yield);
    const double damped = v * std::max(1 - yield, 0.0);
    out.force = sigma0_ * z + sigma1_ * damped + slides;
    out.lost_power = sigma0_ * z * v * yield + (sigma1_ * damped + slides) * v;
  }
  if (!laws_.forces.empty()) {
    const double beside = ForceBeside(v, z, place);
    out.force += beside;
    out.lost_power += beside * v;
  }
  return out;
}

double Friction::Damping(double force, double v, double z, const FrictionPlace& place) const {
  const double faster = v + std::copysign(1e-7 + 1e-4 * std::abs(v), v);
  return std::max(0.0, (Calc(faster, z, place).force - force) / (faster - v));
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

ForcePlace Friction::PlaceOfForces(double v, double z, const FrictionPlace& place) const {
  ForcePlace at{.time = place.time,
                .piston = place.piston,
                .speed = v,
                .bore_rise = place.bore_rise,
                .rod_rise = place.rod_rise,
                .temperature = place.warmer,
                .extra = place.extra};
  if (needs_direction_) at.direction = Direction(v, z, place);
  return at;
}

double Friction::ForceBeside(double v, double z, const FrictionPlace& place) const {
  ForcePlace at = PlaceOfForces(v, z, place);
  double sum = 0;
  for (size_t i = 0; i < laws_.forces.size(); ++i) {
    if (place.memory != nullptr) at.state = place.memory + state_of_[i];
    sum += laws_.forces[i]->Force(at);
  }
  return sum;
}

void Friction::CalcMemoryRates(double v, double z, const FrictionPlace& place, double* rate) const {
  for (size_t k = 0; k < with_memory_.size(); ++k) {
    rate[k] = with_memory_[k]->MemoryRate(v, place.memory[k]);
  }
  if (with_memory_.size() == memory_names_.size()) return;
  ForcePlace at = PlaceOfForces(v, z, place);
  for (size_t i = 0; i < laws_.forces.size(); ++i) {
    at.state = place.memory + state_of_[i];
    laws_.forces[i]->CalcRates(at, rate + state_of_[i]);
  }
}

void Friction::AdvanceMemories(double h, double v, double z, const FrictionPlace& place,
                               double* memory) const {
  if (with_memory_.size() < memory_names_.size()) {
    const ForcePlace at = PlaceOfForces(v, z, place);
    for (size_t i = 0; i < laws_.forces.size(); ++i) {
      laws_.forces[i]->Advance(h, at, memory + state_of_[i]);
    }
  }
  for (size_t k = 0; k < with_memory_.size(); ++k) {
    memory[k] = with_memory_[k]->AdvanceMemory(h, v, memory[k]);
  }
}

double Friction::Advance(double h, double v, double z, const FrictionPlace& place) const {
  const double way = std::abs(v) * h;
  if (way <= 0) return z;
  const int sign = v > 0 ? 1 : -1;
  const double along = sign * z;
  const double z_s = share_ * Level(sign, std::abs(v), place) / sigma0_;
  if (!(z_s > 0)) return sign * std::min(along + way, 0.0);
  return sign * (laws_.bristle ? laws_.bristle->Advance(along, way, z_s)
                               : declared_.Advance(along, way, z_s));
}

double Friction::MaxDamping() const {
  double most = 0;
  for (int side : {0, 1}) {
    const int sign = side == 0 ? 1 : -1;
    double c = 0;
    for (const auto& law : laws_.forces) c += law->Damping(sign);
    if (model_ == FrictionModel::kStatic) {
      c += Level(sign, ramp_[side], FrictionPlace{}) / ramp_[side];
    } else {
      c += sigma1_;
      if (share_ < 1) {
        const double rest = Level(sign, ramp_[side], FrictionPlace{});
        c += (1 - share_) * rest / ramp_[side];
      }
    }
    most = std::max(most, c);
  }
  return most;
}

}  // namespace phs::hydraulics
