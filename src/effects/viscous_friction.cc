#include "effects/viscous_friction.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Walk;

Status InstallViscousFriction(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    extension->AddForce(i, std::make_unique<ViscousForce>(effect.values.at("extension_Ns_per_m"),
                                                          effect.values.at("retraction_Ns_per_m"),
                                                          effect.values.at("exponent"),
                                                          effect.values.at("from_m_s")));
  }
  return {};
}

}  // namespace

double ViscousForce::Force(const hydraulics::ForcePlace& place) const noexcept {
  constexpr double kReference = 1e-2, kSmooth = 1e-4;  // [m/s]
  const double v =
      place.speed > 0 ? std::max(place.speed - from_, 0.0) : std::min(place.speed + from_, 0.0);
  double force = (v > 0 ? extension_ : retraction_) * v;
  if (force != 0 && exponent_ != 1) {
    force *=
        std::pow((v * v + kSmooth * kSmooth) / (kReference * kReference), 0.5 * (exponent_ - 1));
  }
  return force;
}

const EffectInfo& ViscousFrictionInfo() {
  static const EffectInfo info = {
      "viscous_friction",
      "friction",
      "cylinders",
      "+ c v (|v|/1 cm/s)^(n-1), |v| beyond v_f",
      {
          {"extension_Ns_per_m", "N s/m", 5000, 0, 1e8, 0, 1e6, "c for v > 0"},
          {"retraction_Ns_per_m", "N s/m", 5000, 0, 1e8, 0, 1e6, "c for v < 0"},
          {"exponent", "-", 1, 0.2, 4, 0.4, 2.5, "n"},
          {"from_m_s", "m/s", 0, 0, 10, 0, 0.05, "v_f: no drag below it"},
      },
      InstallViscousFriction,
      {
          .rig =
              {
                  {.free = {{"extension_Ns_per_m", 1000, 2e4, 2},
                            {"retraction_Ns_per_m", 1000, 2e4, 2, Walk::kInStep}},
                   .amounts = 2},
                  {.free = {{"extension_Ns_per_m", 3000}, {"retraction_Ns_per_m", 3000}},
                   .held = {{"exponent", 2}},
                   .amounts = 2},
                  {.free = {{"extension_Ns_per_m", 1e4}, {"retraction_Ns_per_m", 1e4}},
                   .held = {{"exponent", 0.65}},
                   .amounts = 2},
              },
          .bench =
              {
                  {.free = {{"extension_Ns_per_m", 0.1, 0, 1, Walk::kEach, 0, 50},
                            {"retraction_Ns_per_m", 0.1, 0, 1, Walk::kEach, 0, 50}},
                   .amounts = 2,
                   .beside = {"friction.viscous"}},
              },
          .bogie =
              {
                  {.free = {{"extension_Ns_per_m", 5000, 5e4, 2},
                            {"retraction_Ns_per_m", 5000, 5e4, 2, Walk::kInStep}},
                   .amounts = 2},
              },
          .options =
              {
                  {.free = {{"exponent", 0.7, 1.6, 2}}},
                  {.free = {{"from_m_s", 2e-3, 1e-2, 2}}},
              },
          // Its viscous part of one direction, which is a number less.
          .contains = {"asymmetric_friction"},
          .over = {"N", "sv"},
      }};
  return info;
}

}  // namespace phs::effects
