#include "steering_oil.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace bogie_curve {
namespace {

constexpr double kAtmosphere = 101325;
constexpr int kBoreLine[4] = {1, 2, 1, 2};  // of cylinders 1 … 4, counted from L1 = 0
constexpr int kRodLine[4] = {0, 0, 3, 3};

double DiscArea(double diameter) { return std::numbers::pi / 4 * diameter * diameter; }

}  // namespace

SteeringNumbers SteeringNumbers::Declared() {
  SteeringNumbers n;
  const double bore = n.bore * n.bore, rod = n.rod * n.rod;
  for (const size_t cross : {0u, 3u}) {
    n.line[cross].rest = n.line[1].rest * bore / (bore - rod);  // no force at rest
    n.line[cross].accumulator = 0.75e-3;
  }
  return n;
}

SteeringNumbers SteeringNumbers::Measured() {
  SteeringNumbers n;
  for (size_t l = 0; l < 4; ++l) {
    const bool cross = l == 0 || l == 3;
    n.line[l] = {
        1.014e-3, 1.4e9, cross ? 2.74e6 : 2.15e6, cross ? 7.76e-6 : 8.85e-6, cross ? 0.75e-3 : 0.0,
        14.166e6, 0};
  }
  return n;
}

SteeringOil::SteeringOil(SteeringNumbers numbers)
    : numbers_(std::move(numbers)),
      bore_area_(DiscArea(numbers_.bore)),
      rod_area_(DiscArea(numbers_.bore) - DiscArea(numbers_.rod)) {}

SteeringOil::Four SteeringOil::Rest() const {
  Four p;
  for (size_t l = 0; l < 4; ++l) p[l] = numbers_.line[l].rest;
  return p;
}

double SteeringOil::Level(size_t cylinder, double speed) const {
  const double scale = numbers_.seal.scale[cylinder];
  const std::vector<double>& v = numbers_.seal.speed;
  const std::vector<double>& f = numbers_.seal.force;
  // Between zero and the first point beside it the level is that point's: the bristle does the rest.
  size_t i = 0;
  if (speed >= 0) {
    while (v[i] <= 0) ++i;
    if (speed <= v[i]) return scale * f[i];
    while (i + 1 < v.size() && v[i] < speed) ++i;
  } else {
    i = v.size() - 1;
    while (v[i] >= 0) --i;
    if (speed >= v[i]) return -scale * f[i];
    while (i > 0 && v[i] > speed) --i;
    ++i;
  }
  const double slope = (f[i] - f[i - 1]) / (v[i] - v[i - 1]);
  return scale * std::abs(f[i] + slope * (speed - v[i]));
}

double SteeringOil::OneBristleRate(size_t cylinder, double speed, double bristle) const {
  const SealNumbers& s = numbers_.seal;
  const double most = Level(cylinder, speed) / s.stiffness, z = bristle / most;
  if (speed * bristle <= 0 || std::abs(z) <= s.elastic_share) return speed;
  const double half_way = (std::abs(z) - 0.5 * (1 + s.elastic_share)) / (1 - s.elastic_share);
  const double alpha = std::abs(z) >= 1 ? 1 : 0.5 + 0.5 * std::sin(std::numbers::pi * half_way);
  return speed * (1 - alpha * std::abs(z));
}

SteeringOil::Four SteeringOil::Tension(const Four& pressure, const Four& speed,
                                       const Four& bristle) const {
  const SealNumbers& s = numbers_.seal;
  Four force;
  for (size_t i = 0; i < 4; ++i) {
    const double seal = s.stiffness * bristle[i] +
                        s.damping * OneBristleRate(i, speed[i], bristle[i]) + s.viscous * speed[i];
    force[i] = pressure[static_cast<size_t>(kRodLine[i])] * rod_area_ -
               pressure[static_cast<size_t>(kBoreLine[i])] * bore_area_ + seal;
  }
  return force;
}

SteeringOil::Four SteeringOil::PressureRate(const Four& pressure, const Four& speed,
                                            bool leaking) const {
  Four flow{};
  for (size_t i = 0; i < 4; ++i) {
    flow[static_cast<size_t>(kBoreLine[i])] -= bore_area_ * speed[i];
    flow[static_cast<size_t>(kRodLine[i])] += rod_area_ * speed[i];
  }
  Four rate;
  for (size_t l = 0; l < 4; ++l) {
    const LineNumbers& n = numbers_.line[l];
    const double p = pressure[l];
    double compliance = n.oil / n.bulk_modulus + n.gas * n.rest / (p * p);
    if (p > n.precharge) compliance += n.accumulator * n.precharge / (p * p);
    rate[l] = (flow[l] - (leaking ? n.leak * (p - kAtmosphere) : 0)) / compliance;
  }
  return rate;
}

SteeringOil::Four SteeringOil::BristleRate(const Four& speed, const Four& bristle) const {
  Four rate;
  for (size_t i = 0; i < 4; ++i) rate[i] = OneBristleRate(i, speed[i], bristle[i]);
  return rate;
}

}  // namespace bogie_curve
