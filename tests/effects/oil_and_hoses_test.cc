// How oil and the hoses around it give way: volume and stored energy over the pressure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

TEST(HoseExpansion, AddsItsCompliance) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double C = 8e-13;
  const PhsSystem s = Compile(With(params, "hose_expansion", {{"compliance_m3_per_Pa", C}}));
  const auto& l = params.lines[0];
  const double x = 1e-5, rise = Hold(s, x, 0).p_rod - l.static_pressure_Pa;
  const double expected = x * params.cylinders[0].RodArea() /
                          (l.oil_volume_m3 / l.bulk_modulus_Pa + C * 1e9 / (1e9 + 2e6));
  EXPECT_NEAR(rise / expected, 1, 2e-3);
}

/// Energy stored after `x` was held so long that creep has come to its end; pressures of both chambers.
struct Rest {
  double stored, p_rod, p_bore;
};
Rest StoredAt(const PhsSystem& s, double x) {
  const Held held = Hold(s, x, 20, 0.01);
  Evaluation e(s);
  const double v = 0;
  s.Calc(20, &x, &v, held.state.data(), &e.out);
  return {e.out.stored_energy, held.p_rod, held.p_bore};
}

// Without gas a line stores int p dV = (V/K + C) (p^2 - p0^2)/2, C of its hose, at once or by creep; a hose
// whose compliance falls as C/(1 + p/p_k) stores C p_k (dp - p_k ln((p_k + p)/(p_k + p0))).
TEST(HoseExpansion, StoresWhatItsComplianceTook) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double C = 8e-13, stiffening = 4e6;
  const auto oil = [&](int line, double p) {
    const auto& l = params.lines[static_cast<size_t>(line)];
    return l.oil_volume_m3 / l.bulk_modulus_Pa * (p * p - std::pow(l.static_pressure_Pa, 2)) / 2;
  };
  const double p0 = params.lines[0].static_pressure_Pa;
  ASSERT_EQ(params.lines[0].name, "L1");
  const Rest creeping = StoredAt(
      Compile(With(params, "hose_expansion",
                   {{"compliance_m3_per_Pa", 0}, {"creep_m3_per_Pa", C}, {"creep_time_s", 0.3}},
                   {"L1"})),
      5e-4);
  EXPECT_GT(creeping.p_rod, 2 * p0);
  EXPECT_NEAR((creeping.stored - oil(0, creeping.p_rod) - oil(1, creeping.p_bore)) /
                  (C * (std::pow(creeping.p_rod, 2) - p0 * p0) / 2),
              1, 0.02);
  const Rest stiff =
      StoredAt(Compile(With(params, "hose_expansion",
                            {{"compliance_m3_per_Pa", C}, {"stiffening_Pa", stiffening}}, {"L1"})),
               5e-4);
  const double taken =
      C * stiffening *
      (stiff.p_rod - p0 - stiffening * std::log((stiffening + stiff.p_rod) / (stiffening + p0)));
  EXPECT_NEAR((stiff.stored - oil(0, stiff.p_rod) - oil(1, stiff.p_bore)) / taken, 1, 0.02);
}

// What comes late comes to rest where the elastic hose of the same numbers is at once, and has stored
// the same; before that it is stiffer.
TEST(HoseExpansion, WhatComesLateEndsAsTheElasticHose) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double C = 8e-13;
  for (const double order : {1.0, 8.0}) {
    std::map<std::string, double> hose = {{"compliance_m3_per_Pa", C},
                                          {"stiffening_Pa", 6e6},
                                          {"stated_at_Pa", 2e6},
                                          {"stiffening_order", order},
                                          {"creep_time_s", 0.3}};
    const PhsSystem at_once = Compile(With(params, "hose_expansion", hose));
    hose["late_share"] = 0.7;
    const PhsSystem late = Compile(With(params, "hose_expansion", hose));
    const Rest now = StoredAt(at_once, 5e-4), then = StoredAt(late, 5e-4);
    EXPECT_NEAR(then.p_rod / now.p_rod, 1, 1e-4) << order;
    EXPECT_NEAR(then.p_bore / now.p_bore, 1, 1e-4) << order;
    EXPECT_NEAR(then.stored / now.stored, 1, 1e-3) << order;
    EXPECT_GT(Hold(late, 5e-4, 0).p_rod, 1.05 * now.p_rod) << order;
  }
}

// V_oil/K' ln(1 + K' (p - p0)/beta).
TEST(OilStiffening, TakesUpWhatItsLogarithmSays) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const auto& l = params.lines[1];
  const double slope = 18, x = -1.5e-3;
  const PhsSystem s = Compile(With(params, "oil_stiffening", {{"slope", slope}}));
  const double pressed = -x * params.cylinders[0].BoreArea();
  const double rise = l.bulk_modulus_Pa / slope * std::expm1(slope * pressed / l.oil_volume_m3);
  EXPECT_NEAR((Hold(s, x, 0).p_bore - l.static_pressure_Pa) / rise, 1, 1e-5);
  EXPECT_GT(rise, 1.05 * l.bulk_modulus_Pa * pressed / l.oil_volume_m3);
}

// beta = B (1 - c exp(-p/P)): what is pressed in is the integral of dp/beta, here by Simpson's rule,
// and what is stored that of p dp/beta; at the static pressure beta stays as declared.
TEST(OilStiffening, MayComeOverAPressureAlone) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double c = 0.8, P = 5.39e6;
  const PhsSystem s =
      Compile(With(params, "oil_stiffening", {{"slope", 0}, {"softness", c}, {"over_Pa", P}}));
  const double areas[] = {params.cylinders[0].RodArea(), -params.cylinders[0].BoreArea()};
  for (const double x : {-5e-4, 1e-4, 5e-4}) {
    const Rest rest = StoredAt(s, x);
    double stored = 0;
    for (const size_t line : {0u, 1u}) {
      const auto& l = params.lines[line];
      const double p0 = l.static_pressure_Pa, p = line == 0 ? rest.p_rod : rest.p_bore;
      const double B = l.bulk_modulus_Pa / (1 - c * std::exp(-p0 / P));
      double volume = 0;
      constexpr int kSteps = 2000;
      for (int i = 0; i <= kSteps; ++i) {
        const double at = p0 + (p - p0) * i / kSteps;
        const double weight = (i == 0 || i == kSteps ? 1 : 2 + 2 * (i % 2)) * (p - p0) / kSteps / 3;
        const double part = weight * l.oil_volume_m3 / (B * (1 - c * std::exp(-at / P)));
        volume += part, stored += part * at;
      }
      if (p > 1e5) {
        EXPECT_NEAR(volume / (areas[line] * x), 1, 1e-4) << x << " " << l.name;
      }
    }
    if (std::min(rest.p_rod, rest.p_bore) > 1e5) {
      EXPECT_NEAR(rest.stored / stored, 1, 1e-4) << x;
    }
  }
  EXPECT_FALSE(
      PhsSystem::Create(With(params, "oil_stiffening", {{"softness", c}}), &effects::Catalogue())
          .ok())
      << "beside the slope that it has unless told otherwise";
}

}  // namespace
}  // namespace phs::effects
