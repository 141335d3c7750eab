// The further forms of effects, each against its closed formula.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "hydraulics/friction.h"
#include "hydraulics/pipe.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

TEST(EffectForms, ACreepingHoseGivesWayWithItsTime) {
  const double C = 4e-13, tau = 0.5, x = 2e-4;
  const PhsParams params = OilWith("hose_expansion", {{"compliance_m3_per_Pa", 0},
                                                      {"creep_m3_per_Pa", C},
                                                      {"creep_time_s", tau},
                                                      {"rod_ratio", 2}});
  const auto& l = params.lines[0];
  const double oil = l.oil_volume_m3 / l.bulk_modulus_Pa, area = params.cylinders[0].RodArea();
  const double p0 = l.static_pressure_Pa;
  EXPECT_NEAR(Hold(Compile(params), x, 0).p_rod - p0, area * x / oil, 1e-3 * area * x / oil);
  // p falls to A x/(C_oil + C_c) with the time tau C_oil/(C_oil + C_c); rod lines have twice C.
  const double end = area * x / (oil + 2 * C), time = tau * oil / (oil + 2 * C);
  EXPECT_NEAR(Hold(Compile(params), x, 20 * tau).p_rod - p0, end, 1e-3 * end);
  const double at = end + (area * x / oil - end) * std::exp(-1.0);
  EXPECT_NEAR(Hold(Compile(params), x, time, 1e-4).p_rod - p0, at, 3e-3 * at);
}

// Three Kelvin elements side by side in oil: after a step their volumes come with their own times.
TEST(EffectForms, AHoseMayCreepOverDecadesOfTime) {
  const double C = 4e-14, tau = 0.5, d = 8, x = 2e-4;
  const auto p_at = [&](double time) {
    const PhsParams params = OilWith("hose_expansion", {{"compliance_m3_per_Pa", 0},
                                                        {"creep_m3_per_Pa", C},
                                                        {"creep_time_s", tau},
                                                        {"creep_spread", d}});
    return Hold(Compile(params), x, time, 1e-3).p_rod;
  };
  const PhsParams params = OilWith("hose_expansion", {{"compliance_m3_per_Pa", 0}});
  const auto& l = params.lines[0];
  const double oil = l.oil_volume_m3 / l.bulk_modulus_Pa, p0 = l.static_pressure_Pa;
  const double first = params.cylinders[0].RodArea() * x / oil;  // C is small: to first order
  for (const double t : {0.0625, 0.5, 4.0}) {
    double crept = 0;
    for (const double own : {tau / d, tau, tau * d}) crept += -std::expm1(-t / own) / 3;
    EXPECT_NEAR((p0 + first - p_at(t)) / (first * C / oil * crept), 1, 0.06) << t;
  }
}

// The same hose, its compliance stated at none and at 2 MPa.
TEST(EffectForms, AHosesComplianceMayBeStatedAtAPressure) {
  const double C = 8e-13, pk = 4e6, at = 2e6, x = 4e-4;
  const auto p_of = [&](double compliance, double stated) {
    return Hold(Compile(OilWith("hose_expansion", {{"compliance_m3_per_Pa", compliance},
                                                   {"stiffening_Pa", pk},
                                                   {"stiffening_order", 3},
                                                   {"stated_at_Pa", stated}})),
                x, 0)
        .p_rod;
  };
  EXPECT_NEAR(p_of(C * std::pow(1 + at / pk, -3), at), p_of(C, 0), 1);
  EXPECT_GT(std::abs(p_of(C, at) - p_of(C, 0)), 1e5);
}

TEST(EffectForms, AStiffeningHoseTakesUpItsVolume) {
  // Order 3: C p_k/2 (a0^-2 - a^-2), a = 1 + p/p_k.
  const double C = 8e-13, pk = 4e6, x = 4e-4;
  const PhsParams params =
      OilWith("hose_expansion",
              {{"compliance_m3_per_Pa", C}, {"stiffening_Pa", pk}, {"stiffening_order", 3}});
  const auto& l = params.lines[0];
  const double p = Hold(Compile(params), x, 0).p_rod, p0 = l.static_pressure_Pa;
  const double hose = 0.5 * C * pk * (std::pow(1 + p0 / pk, -2) - std::pow(1 + p / pk, -2));
  EXPECT_NEAR(hose + l.oil_volume_m3 / l.bulk_modulus_Pa * (p - p0),
              x * params.cylinders[0].RodArea(), 1e-9);
}

TEST(EffectForms, AnAccumulatorOpensPartByPart) {
  // Thirds of its volume with precharges P - s sqrt(3/2), P, P + s sqrt(3/2); isothermal gas.
  const double P = 6e6, s = 4e5, x = 5e-4;
  const PhsParams params =
      OilWith("accumulator_precharge", {{"precharge_Pa", P}, {"spread_Pa", s}});
  const auto& l = params.lines[0];
  for (const double share : {0.6, 0.8, 1.0}) {
    const double p = Hold(Compile(params), share * x, 0).p_rod;
    double taken = l.oil_volume_m3 / l.bulk_modulus_Pa * (p - l.static_pressure_Pa);
    for (const double k : {-std::sqrt(1.5), 0.0, std::sqrt(1.5)}) {
      taken += l.accumulator.volume_m3 / 3 * std::max(0.0, 1 - (P + k * s) / p);
    }
    EXPECT_NEAR(taken, share * x * params.cylinders[0].RodArea(), 1e-9) << p;
  }
  // Each part has its share of the accumulator's own stop.
  PhsParams stopped = params;
  const double room = 3e-7;
  stopped.lines[0].accumulator.min_gas_volume_m3 = l.accumulator.volume_m3 - room;
  const double p = Hold(Compile(stopped), 2 * x, 0).p_rod;
  EXPECT_GT(p, 1.2 * P);
  EXPECT_NEAR(room + l.oil_volume_m3 / l.bulk_modulus_Pa * (p - l.static_pressure_Pa),
              2 * x * params.cylinders[0].RodArea(), 1e-9);
}

// Below V_min a rubber bead lets the gas lose 27 % of what it would: V = V_min - 0.27 (V_min - V0
// p0/p).
TEST(EffectForms, WhatADiaphragmMeetsMayGiveWay) {
  const double least = 8e-6, share = 0.73;
  PhsParams params = Frictionless();
  params = With(params, "diaphragm_stop", {{"min_gas_volume_m3", least}, {"share", share}});
  const auto& l = params.lines[0];
  const double V0 = l.gas_volume_m3, p0 = l.static_pressure_Pa;
  for (const double x : {0.5e-3, 1.4e-3, 2.0e-3}) {
    const double p = Hold(Compile(params), x, 0).p_rod, free = V0 * p0 / p;
    const double gas = free > least ? free : least - (1 - share) * (least - free);
    EXPECT_NEAR(l.oil_volume_m3 / l.bulk_modulus_Pa * (p - p0) + V0 - gas,
                x * params.cylinders[0].RodArea(), 1e-9)
        << p;
  }
}

TEST(EffectForms, ADiaphragmLaysItselfOnItsWallPartByPart) {
  // Thirds of the gas that stop at V_min/3 (1 - d sqrt(3/2)), V_min/3, V_min/3 (1 + d sqrt(3/2)).
  const double least = 6e-6, spread = 0.4;
  PhsParams params = Frictionless();
  params = With(params, "diaphragm_stop", {{"min_gas_volume_m3", least}, {"spread", spread}});
  const auto& l = params.lines[0];
  const double V0 = l.gas_volume_m3, p0 = l.static_pressure_Pa;
  for (const double x : {1.0e-3, 1.4e-3, 1.7e-3, 2.0e-3}) {
    const double p = Hold(Compile(params), x, 0).p_rod;
    double taken = l.oil_volume_m3 / l.bulk_modulus_Pa * (p - p0);
    for (const double k : {-std::sqrt(1.5), 0.0, std::sqrt(1.5)}) {
      taken += (V0 - std::max(V0 * p0 / p, least * (1 + k * spread))) / 3;
    }
    EXPECT_NEAR(taken, x * params.cylinders[0].RodArea(), 1e-9) << p;
  }
}

TEST(EffectForms, AirDissolvesByHenrysLawAndLags) {
  const double a = 0.02, ps = 8e6, x = 2e-4;
  const PhsParams at_once = OilWith("entrained_air", {{"air_fraction", a}, {"saturation_Pa", ps}});
  const PhsParams lagging = OilWith(
      "entrained_air", {{"air_fraction", a}, {"saturation_Pa", ps}, {"dissolving_time_s", 0.2}});
  const auto& l = at_once.lines[0];
  const double p0 = l.static_pressure_Pa, V = a * l.oil_volume_m3 * kAtmosphere;
  const auto free = [&](double p) { return 1 - (p - kAtmosphere) / (ps - kAtmosphere); };
  const double pushed = x * at_once.cylinders[0].RodArea();
  const double C = l.oil_volume_m3 / l.bulk_modulus_Pa;
  const double p = Hold(Compile(at_once), x, 0).p_rod;
  EXPECT_NEAR(V * (free(p0) / p0 - free(p) / p) + C * (p - p0), pushed, 1e-9);
  const double first = Hold(Compile(lagging), x, 0).p_rod;
  EXPECT_NEAR(V * free(p0) * (1 / p0 - 1 / first) + C * (first - p0), pushed, 1e-9);
  EXPECT_NEAR(Hold(Compile(lagging), x, 10).p_rod, p, 1e-4 * p);
  EXPECT_GT(first, 1.01 * p);
}

// Back at x = 0 the line is short of air, V (s0/p0 - s/p) + C (p - p0) = 0, which comes out again:
// ds/dt = (s_e(p) - s)/(r tau).
TEST(EffectForms, AirComesOutAgainWithATimeOfItsOwn) {
  const double a = 0.02, ps = 8e6, tau = 0.5, r = 0.3;
  const PhsParams params = OilWith("entrained_air", {{"air_fraction", a},
                                                     {"saturation_Pa", ps},
                                                     {"dissolving_time_s", tau},
                                                     {"release_ratio", r}});
  const auto& l = params.lines[0];
  const double p0 = l.static_pressure_Pa, V = a * l.oil_volume_m3 * kAtmosphere;
  const double C = l.oil_volume_m3 / l.bulk_modulus_Pa;
  const auto equilibrium = [&](double p) { return 1 - (p - kAtmosphere) / (ps - kAtmosphere); };
  const auto free = [&](double p) { return p * (equilibrium(p0) / p0 + C * (p - p0) / V); };
  const PhsSystem s = Compile(params);
  const auto push = [](double t) { return t < 4 ? 2e-4 : 0; };
  const double dt = 0.01, before = Drive(s, 4.05, 1e-3, push).p_rod;
  const double after = Drive(s, 4.05 + dt, 1e-3, push).p_rod, middle = 0.5 * (before + after);
  const double short_of = equilibrium(middle) - free(middle);
  EXPECT_GT(short_of, 0.01);
  EXPECT_NEAR((free(after) - free(before)) / dt, short_of / (r * tau), 0.02 * short_of / (r * tau));
}

TEST(EffectForms, LeakThroughGapOrificeAndWideningGap) {
  double slope;
  for (double n : {0.5, 1.0, 1.7}) {
    const hydraulics::GapFlow leak(2e-14, n);
    EXPECT_NEAR(leak.Flow({}, 5e6, &slope), 2e-14 * 5e6, 1e-6 * 1e-7);
    EXPECT_NEAR(slope, n * 2e-14, 1e-6 * 2e-14);
    EXPECT_NEAR(leak.Flow({}, -2e7, &slope), -1e-7 * std::pow(4, n), 1e-6 * 1e-7);
    EXPECT_NEAR(leak.Drop({}, 1e-7, &slope), 5e6, 1);
    const hydraulics::GapFlow lip(2e-14, n, -1, 0.25);
    EXPECT_NEAR(lip.Flow({}, 5e6, &slope), 1e-7, 1e-13);
    EXPECT_NEAR(lip.Flow({}, -5e6, &slope), -0.25e-7, 1e-13);
    EXPECT_NEAR(lip.Drop({}, -0.25e-7, &slope), -5e6, 1);
    const hydraulics::GapFlow crack(2e-14, n, -1, 1, 3e6);
    EXPECT_NEAR(crack.Flow({}, 8e6, &slope), 1e-7, 1e-13) << "5 MPa beyond its opening";
    EXPECT_NEAR(crack.Drop({}, 1e-7, &slope), 8e6, 1);
    for (const double dp : {-4e6, 0.0, 2.9e6}) EXPECT_EQ(crack.Flow({}, dp, &slope), 0) << dp;
  }
}

TEST(EffectForms, ReleasedAirComesAndGoesWithItsTimes) {
  const double pc = 5e5, b = 0.05, out = 0.2, back = 3, x = 8e-4;
  std::map<std::string, double> values = {{"release_Pa", pc}, {"solubility", b}};
  const double settled = Hold(Compile(OilWith("cavitation", values)), x, 0).p_bore;
  values["release_time_s"] = out, values["dissolving_time_s"] = back;
  const PhsParams params = OilWith("cavitation", values);
  const PhsSystem s = Compile(params);
  EXPECT_LT(Hold(s, x, 0).p_bore, 1e4) << "nothing has come out yet";
  EXPECT_NEAR(Hold(s, x, 20 * out).p_bore, settled, 1e-3 * settled);
  // Back at x = 0 what has come out holds the line above its static pressure, A s/p = C (p - p0),
  // and dissolves: s ~ exp(-t/tau).
  const auto& l = params.lines[1];
  const double C = l.oil_volume_m3 / l.bulk_modulus_Pa, p0 = l.static_pressure_Pa;
  const double A = b * l.oil_volume_m3 * kAtmosphere;
  const auto pull = [=](double t) { return t < 4 ? x : 0; };
  const Held early = Drive(s, 4.1, 1e-3, pull), late = Drive(s, 6.1, 1e-3, pull);
  const auto free = [&](const Held& at) { return C * (at.p_bore - p0) * at.p_bore / A; };
  EXPECT_GT(free(early), 0.1);
  EXPECT_NEAR(std::log(free(early) / free(late)), 2 / back, 2e-3);
}

TEST(EffectForms, WarmOilIsSofterAndRodLinesMayExpandMore) {
  // p - p0 = beta exp(-s dT) alpha dT without gas; rod lines expand `rod_ratio` times as much.
  const double alpha = 6e-4, s = 5e-3, warmer = 2, ratio = 1.5;
  const PhsParams params = OilWith("temperature_drift", {{"rate_K_per_s", 1},
                                                         {"expansion_1_per_K", alpha},
                                                         {"softening_1_per_K", s},
                                                         {"rod_ratio", ratio}});
  const Held at = Hold(Compile(params), 0, warmer);
  const double rise = params.lines[1].bulk_modulus_Pa * std::exp(-s * warmer) * alpha * warmer;
  EXPECT_NEAR(at.p_bore - params.lines[1].static_pressure_Pa, rise, 1e-3 * rise);
  EXPECT_NEAR(at.p_rod - params.lines[0].static_pressure_Pa, ratio * rise, 1e-3 * ratio * rise);
}

TEST(EffectForms, AMountHardensAndDiffersByDirection) {
  const double k = 5e7, b = 4e6, r = 0.6;
  const PhsParams params =
      OilWith("mount_compliance",
              {{"stiffness_N_per_m", k}, {"hardening_1_per_m2", b}, {"tension_ratio", r}});
  for (double x : {1e-3, -1e-3}) {
    const Held at = Hold(Compile(params), x, 0.1);
    const double u = x - at.piston, s = u > 0 ? r : 1;
    EXPECT_NEAR(at.force, s * k * u * (1 + b * u * u), 1e-4 * std::abs(at.force));
    EXPECT_GT(std::abs(u), 1e-5);
  }
}

/// VDI 2230: stiff until tension has used up the preload, the bolts alone beyond.
TEST(EffectForms, ABoltedMountGapesBeyondItsPreload) {
  const double k = 5e7, r = 0.25, preload = 4000;
  const PhsParams params = OilWith(
      "mount_compliance", {{"stiffness_N_per_m", k}, {"tension_ratio", r}, {"opens_N", preload}});
  int gaping = 0, closed = 0;
  for (double x : {1e-3, 2e-4, -1e-3}) {
    const Held at = Hold(Compile(params), x, 0.1);
    const double u = x - at.piston;
    const bool open = u > preload / k;
    ++(open ? gaping : closed);
    EXPECT_NEAR(at.force, open ? preload + r * k * (u - preload / k) : k * u,
                1e-4 * std::abs(at.force));
  }
  EXPECT_GT(gaping, 0);
  EXPECT_GT(closed, 0);
}

/// A bench part that rubs with 1000 N and has one effect.
PhsSystem Rubbing(const std::string& effect, std::map<std::string, double> values) {
  PhsParams params;
  params.cylinders.resize(1);
  params.cylinders[0].name = "1";
  hydraulics::FrictionParams& f = params.friction;
  f.model = FrictionModel::kStatic;
  f.curve = hydraulics::FrictionCurve::kCoulomb;
  f.coulomb_extension_N = f.coulomb_retraction_N = 1000;
  f.breakaway_extension_N = f.breakaway_retraction_N = 1000;
  f.viscous_extension_Ns_per_m = f.viscous_retraction_Ns_per_m = 0;
  f.damping_Ns_per_m = 0;
  return Compile(With(params, effect, std::move(values)));
}

TEST(EffectForms, FrictionOverPlaceSpeedAndPressureDifference) {
  const PhsSystem spot = Rubbing("position_friction", {{"slope_1_per_m", 0},
                                                       {"spot_share", 0.5},
                                                       {"spot_centre_m", 1e-3},
                                                       {"spot_width_m", 2e-3},
                                                       {"wave_sine", 0.1},
                                                       {"wave_length_m", 4e-3}});
  hydraulics::FrictionPlace place;
  place.piston = 3e-3;
  EXPECT_NEAR(spot.friction(0).Level(1, 0.01, place), 1000 * (1 + 0.5 * std::exp(-1) - 0.1), 1e-6);
  const PhsSystem slow =
      Rubbing("stribeck", {{"extra_N", 300}, {"speed_m_s", 1e-2}, {"exponent", 2}});
  EXPECT_NEAR(slow.friction(0).Level(1, 2e-2, {}), 1000 + 300 * std::exp(-4), 1e-6);
  const PhsSystem fast =
      Rubbing("viscous_friction", {{"extension_Ns_per_m", 1e4}, {"exponent", 2}});
  EXPECT_NEAR(fast.friction(0).Calc(0.05, 0, {}).force, 1000 + 1e4 * 0.05 * 5, 0.01);
}

TEST(EffectForms, SealsArePressedByTheDifferenceOfThePressures) {
  const double k = 1e-4;
  PhsParams params = With(Quarter(), "pressure_friction",
                          {{"bore_N_per_Pa", 0}, {"rod_N_per_Pa", 0}, {"difference_N_per_Pa", k}});
  const PhsSystem s = Compile(params);
  const double rest =
      params.lines[params.FindLine(params.cylinders[0].bore_line)].static_pressure_Pa -
      params.lines[params.FindLine(params.cylinders[0].rod_line)].static_pressure_Pa;
  ASSERT_LT(rest, -1e5);
  hydraulics::FrictionPlace place;
  const double plain = s.friction(0).Level(-1, 0.01, place);
  place.bore_rise = 3e6, place.rod_rise = 1e6;
  EXPECT_NEAR(s.friction(0).Level(-1, 0.01, place) - plain,
              k * (std::abs(rest + 2e6) - std::abs(rest)), 1e-6);
}

TEST(EffectForms, TheCreepingBristleApproachesItsLevelExponentially) {
  const PhsSystem s =
      Rubbing("presliding", {{"creeping", 1}, {"share", 0.4}, {"stiffness_N_per_m", 1e7}});
  const hydraulics::Friction& friction = s.friction(0);
  const double end = 0.4 * 1000 / 1e7;
  double z = -0.5 * end;
  for (int i = 0; i < 10; ++i) z = friction.Advance(1e-3, 3e-3, z, {});
  EXPECT_NEAR(z, end - 1.5 * end * std::exp(-3e-5 / end), 1e-12);
  EXPECT_NEAR(friction.Calc(3e-3, z, {}).force, 1e7 * z + 600, 1e-6);
}

}  // namespace
}  // namespace phs::effects
