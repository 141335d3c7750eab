// The law of every hydraulic effect, on its own: closed formulas at a few points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

TEST(PistonLeakage, EqualisesChambersExponentially) {
  // Small step: linear capacitances C_b, C_r; time constant C_b C_r/((C_b + C_r) G).
  const PhsParams params = Frictionless();
  const double G = 1e-12, x = 1e-6;
  const PhsSystem s = Compile(With(params, "piston_leakage", {{"conductance_m3_per_Pas", G}}));
  auto C = [](const hydraulics::LineParams& l) {
    return l.oil_volume_m3 / l.bulk_modulus_Pa + l.gas_volume_m3 / l.static_pressure_Pa;
  };
  const double Cr = C(params.lines[0]), Cb = C(params.lines[1]);
  const double tau = Cb * Cr / ((Cb + Cr) * G);
  const Held rest = Hold(s, x, 0), later = Hold(s, x, tau, tau / 1000);
  // The static difference leaks as well; it adds to the step's.
  const double before = rest.p_bore - rest.p_rod, after = later.p_bore - later.p_rod;
  EXPECT_NEAR(after / before, std::exp(-1), 2e-2);
  EXPECT_GT(later.state[0], -1e-6);
}

TEST(ExternalLeakage, LosesThePrechargeFromItsStartOn) {
  const PhsSystem s = Compile(With(Frictionless(), "external_leakage",
                                   {{"conductance_m3_per_Pas", 1e-6}, {"start_s", 1.0}}, {"L1"}));
  EXPECT_NEAR(Hold(s, 0, 0.999).p_rod, 1.8e6 / 0.8976, 1);
  const Held lost = Hold(s, 0, 3.0);
  EXPECT_NEAR(lost.p_rod, kAtmosphere, 100);
  EXPECT_NEAR(lost.p_bore, 1.8e6, 1e-3) << "the other line keeps its pressure";
}

TEST(LineResistance, DropsPressureInProportionToFlow) {
  const double R = 1e10, v = 1e-3;
  PhsParams params = Frictionless();
  const PhsSystem s = Compile(With(params, "line_resistance", {{"laminar_Pas_per_m3", R}}));
  const PhsSystem plain = Compile(params);
  const double T = 1.0;
  const auto ramp = [v](double t) { return v * t; };
  const Held with = Drive(s, T, 1e-3, ramp), without = Drive(plain, T, 1e-3, ramp);
  // Settled ramp: chamber above line by R q, q = A v less what the chamber oil itself takes.
  const double drop = with.p_rod - without.p_rod;
  const double full = R * params.cylinders[0].RodArea() * v;
  EXPECT_GT(drop, 0.6 * full);
  EXPECT_LT(drop, full);
  EXPECT_LT(with.p_bore, without.p_bore);
}

TEST(LineResistance, FollowsTheViscosityAtTheStaticTemperature) {
  // ISO VG 68 by ASTM D341: 9350 mm²/s and 902 kg/m3 at -20 °C, 215 and 877 at 20 °C.
  const double v = 1e-3, ratio = 9350.0 * 902 / (215.0 * 877);
  auto drop = [v](double temperature_K) {
    PhsParams params = Frictionless();
    params.temperature_K = temperature_K;
    const PhsSystem s = Compile(With(params, "line_resistance", {{"laminar_Pas_per_m3", 1e8}}));
    const auto ramp = [v](double t) { return v * t; };
    return Drive(s, 1.0, 1e-3, ramp).p_rod - Drive(Compile(params), 1.0, 1e-3, ramp).p_rod;
  };
  EXPECT_NEAR(drop(253.15) / drop(293.15), ratio, 0.01 * ratio);
}

TEST(LineResistance, FollowsTheViscosityOfTheHour) {
  // The oil cools by 40 K in 4 s, then the piston moves: the drop is that of a model used at -20 °C.
  const double v = 1e-3, ratio = 9350.0 * 902 / (215.0 * 877);
  const auto ramp = [v](double t) { return v * std::max(t - 5, 0.0); };
  auto drop = [&](double cooler_K) {
    const PhsParams params =
        With(Frictionless(), "temperature_drift",
             {{"rate_K_per_s", -0.25 * cooler_K}, {"limit_K", cooler_K}, {"expansion_1_per_K", 0}});
    const PhsSystem s = Compile(With(params, "line_resistance", {{"laminar_Pas_per_m3", 1e8}}));
    return Drive(s, 6.0, 1e-3, ramp).p_rod - Drive(Compile(params), 6.0, 1e-3, ramp).p_rod;
  };
  EXPECT_NEAR(drop(40) / drop(0), ratio, 0.01 * ratio);
}

TEST(LineResistance, TurbulentFlowEqualisesInTheTimeOfTheClosedForm) {
  // Two compliances C1, C2 behind K q²: d(dp)/dt = -q (1/C1 + 1/C2), so sqrt(dp) falls linearly and
  // is zero at t* = 2 sqrt(dp0 K)/(1/C1 + 1/C2).
  const double K = 1e15, x = -2e-4, share = 0.2;
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const PhsSystem s = Compile(
      With(params, "line_resistance",
           {{"laminar_Pas_per_m3", 1e3}, {"turbulent_Pas2_per_m6", K}, {"oil_share", share}}));
  const auto& bore = params.lines[1];
  const double C1 = share * bore.oil_volume_m3 / bore.bulk_modulus_Pa;
  const double C2 = (1 - share) * bore.oil_volume_m3 / bore.bulk_modulus_Pa;
  const double dp0 = -params.cylinders[0].BoreArea() * x / C1;
  const double end = 2 * std::sqrt(dp0 * K) / (1 / C1 + 1 / C2);
  const double settled = 1.8e6 + dp0 * C1 / (C1 + C2);
  const auto ahead = [&](double t) {
    return (Hold(s, x, t, end / 100).p_bore - settled) * (C1 + C2) / C2;
  };
  EXPECT_NEAR(ahead(0), dp0, 1e-3 * dp0);
  EXPECT_NEAR(ahead(0.5 * end), dp0 / 4, 5e-3 * dp0);
  EXPECT_NEAR(ahead(0.9 * end), dp0 / 100, 2e-3 * dp0);
  EXPECT_NEAR(ahead(1.5 * end), 0, 1e-3 * dp0) << "and stays there";
}

TEST(LineResistance, TurbulentFlowMayReverseInCoarseSteps) {
  const auto swing = [](double t) { return 2e-3 * std::sin(2 * M_PI * 0.7 * t); };
  const PhsSystem s = Compile(
      With(Frictionless(), "line_resistance",
           {{"laminar_Pas_per_m3", 3e7}, {"turbulent_Pas2_per_m6", 1e13}, {"oil_share", 0.2}}));
  for (double t = 2.0; t < 3.5; t += 0.1) {
    const double fine = Drive(s, t, 2e-4, swing).p_bore, coarse = Drive(s, t, 0.02, swing).p_bore;
    EXPECT_NEAR(coarse, fine, 3e3) << t;
  }
}

TEST(PistonLeakage, FallsWithTheViscosityAtTheStaticTemperature) {
  // The same time constant as at 20 °C after a time longer by the ratio of viscosities.
  auto left = [](double temperature_K, double time) {
    PhsParams params = Frictionless();
    params.temperature_K = temperature_K;
    const PhsSystem s =
        Compile(With(params, "piston_leakage", {{"conductance_m3_per_Pas", 1e-12}}));
    const Held later = Hold(s, 1e-6, time, time / 1000), rest = Hold(s, 1e-6, 0);
    return (later.p_bore - later.p_rod) / (rest.p_bore - rest.p_rod);
  };
  const double ratio = 1030.0 * 889 / (215.0 * 877);  // 0 °C over 20 °C
  EXPECT_NEAR(left(273.15, 5.0 * ratio), left(293.15, 5.0), 2e-3);
  EXPECT_LT(left(293.15, 5.0), 0.9);
}

TEST(CheckRestriction, ResistsByDirection) {
  const PhsSystem s = Compile(With(Frictionless(), "check_restriction",
                                   {{"out_Pas_per_m3", 1e11}, {"in_Pas_per_m3", 1e8}}));
  const PhsSystem plain = Compile(Frictionless());
  const auto ramp = [](double t) { return 1e-3 * t; };
  const Held with = Drive(s, 1, 1e-3, ramp), without = Drive(plain, 1, 1e-3, ramp);
  // Extension pushes oil out of the rod chamber (resisted) and into the bore chamber (free).
  EXPECT_GT(with.p_rod - without.p_rod, 3e5);
  EXPECT_LT(std::abs(with.p_bore - without.p_bore), 1e4);
}

TEST(EntrainedAir, SoftensAtLowPressureOnly) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double a = 0.01, n = 1.2;
  const PhsSystem s =
      Compile(With(params, "entrained_air", {{"air_fraction", a}, {"polytropic_exponent", n}}));
  const auto& l = params.lines[0];
  const double Ar = params.cylinders[0].RodArea();
  for (double x : {1e-5, 2e-4, 1e-3}) {
    const double p = Hold(s, x, 0).p_rod;
    const double air =
        a * l.oil_volume_m3 *
        (std::pow(kAtmosphere / l.static_pressure_Pa, 1 / n) - std::pow(kAtmosphere / p, 1 / n));
    EXPECT_NEAR(air + l.oil_volume_m3 / l.bulk_modulus_Pa * (p - l.static_pressure_Pa), x * Ar,
                1e-10);
  }
  // Dissolved above p_s: stiff as oil alone.
  const PhsSystem d =
      Compile(With(params, "entrained_air", {{"air_fraction", a}, {"saturation_Pa", 5e6}}));
  const double k = (Hold(d, 1.01e-3, 0).p_rod - Hold(d, 1e-3, 0).p_rod) / (1e-5 * Ar);
  EXPECT_NEAR(k / (l.bulk_modulus_Pa / l.oil_volume_m3), 1, 1e-3);
}

TEST(GasThermal, FastIsAdiabaticSlowIsIsothermal) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.oil_volume_m3 = 1e-6;  // gas alone
  const double gamma = 1 + hydraulics::kNitrogenR / hydraulics::kNitrogenCv;
  const auto& l = params.lines[0];
  const double x = 1e-3, V1 = l.gas_volume_m3 - x * params.cylinders[0].RodArea();
  const auto ramp = [x](double t) { return x * std::min(t, 1.0); };
  const PhsSystem slow = Compile(With(params, "gas_thermal", {{"thermal_time_s", 1e-3}}));
  const PhsSystem fast = Compile(With(params, "gas_thermal", {{"thermal_time_s", 1e8}}));
  const PhsSystem real =
      Compile(With(params, "gas_thermal", {{"thermal_time_s", 1e8}, {"real_gas", 1}}));
  const double ratio = l.gas_volume_m3 / V1;
  const double p_slow = Drive(slow, 1.1, 1e-3, ramp).p_rod;
  const double p_fast = Drive(fast, 1.1, 1e-3, ramp).p_rod;
  const double p_real = Drive(real, 1.1, 1e-3, ramp).p_rod;
  EXPECT_NEAR(p_slow / (l.static_pressure_Pa * ratio), 1, 3e-3);
  EXPECT_NEAR(p_fast / (l.static_pressure_Pa * std::pow(ratio, gamma)), 1, 3e-3);
  EXPECT_NEAR(p_real / p_fast, 1, 0.03);
  EXPECT_NE(p_real, p_fast);
}

TEST(AccumulatorPrecharge, MovesTheBlowOff) {
  PhsParams params = Frictionless();
  const PhsSystem s = Compile(With(params, "accumulator_precharge", {{"precharge_Pa", 9e6}}));
  EXPECT_NEAR(Hold(s, 5e-3, 0).p_rod, 9e6, 3e5);
}

TEST(DiaphragmStop, LeavesOnlyTheOilAtTheStop) {
  PhsParams params = Frictionless();
  const PhsSystem s = Compile(With(params, "diaphragm_stop", {{"min_gas_volume_m3", 12e-6}}));
  const auto& l = params.lines[1];
  const double x = -1.5e-3;
  const double k = (Hold(s, x, 0).p_bore - Hold(s, x + 1e-5, 0).p_bore) /
                   (1e-5 * params.cylinders[0].BoreArea());
  EXPECT_NEAR(k / (l.bulk_modulus_Pa / l.oil_volume_m3), 1, 1e-3);
}

// Below the reservoir's precharge its gas stays at V_g0 p0/p_c: the oil alone takes up what is
// pulled.
TEST(DiaphragmStop, RestsOnTheOilPortBelowThePrecharge) {
  PhsParams params = Frictionless();
  const auto& l = params.lines[1];
  const double precharge = 0.8 * l.static_pressure_Pa,
               compliance = l.oil_volume_m3 / l.bulk_modulus_Pa;
  const PhsSystem s = Compile(
      With(params, "diaphragm_stop", {{"min_gas_volume_m3", 0}, {"precharge_Pa", precharge}}));
  const double grown = l.gas_volume_m3 * (l.static_pressure_Pa / precharge - 1);
  for (const double below : {0.1, 0.5}) {
    const double p = (1 - below) * precharge;
    const double pulled = grown + compliance * (l.static_pressure_Pa - p);
    const double x = pulled / params.cylinders[0].BoreArea();
    EXPECT_NEAR(Hold(s, x, 0).p_bore / p, 1, 2e-3) << "a trace of air";
  }
  const double above = 1.2 * precharge, gas = l.gas_volume_m3 * (l.static_pressure_Pa / above - 1);
  const double x =
      (gas + compliance * (l.static_pressure_Pa - above)) / params.cylinders[0].BoreArea();
  EXPECT_NEAR(Hold(s, x, 0).p_bore / above, 1, 2e-3) << "afloat";
}

TEST(Cavitation, HoldsThePulledLineNearTheReleasePressure) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const PhsSystem s = Compile(With(params, "cavitation", {{"release_Pa", 5e5}}));
  const double with = Hold(s, 8e-4, 0).p_bore;
  EXPECT_LT(with, 5e5);
  EXPECT_GT(with, 2e5);
  EXPECT_LT(Hold(Compile(params), 8e-4, 0).p_bore, 1e4);
}

TEST(TemperatureDrift, WarmsGasAndExpandsOil) {
  PhsParams p = Frictionless();
  for (auto& l : p.lines) l.oil_volume_m3 = 1e-6;
  const PhsSystem s =
      Compile(With(p, "temperature_drift", {{"rate_K_per_s", 0.1}, {"expansion_1_per_K", 0}}));
  EXPECT_NEAR(Hold(s, 0, 100, 1).p_bore / (1.8e6 * 303.15 / 293.15), 1, 1e-3);
  PhsParams oil = Frictionless();
  for (auto& l : oil.lines) l.gas_volume_m3 = 0;
  const PhsSystem e = Compile(
      With(oil, "temperature_drift", {{"rate_K_per_s", 0.1}, {"expansion_1_per_K", 6.65e-4}}));
  EXPECT_NEAR(Hold(e, 0, 10, 1).p_bore - 1.8e6, 1.4e9 * 6.65e-4, 2e3);
}

TEST(TemperatureDrift, SettlesWhereItIsToldTo) {
  PhsParams p = Frictionless();
  for (auto& l : p.lines) l.oil_volume_m3 = 1e-6;
  const PhsSystem s =
      Compile(With(p, "temperature_drift",
                   {{"rate_K_per_s", 0.1}, {"settling_s", 50}, {"expansion_1_per_K", 0}}));
  EXPECT_NEAR(s.Ambient(50) - p.temperature_K, 5 * (1 - std::exp(-1)), 1e-9);
  EXPECT_NEAR(s.Ambient(1000) - p.temperature_K, 5, 1e-6);
}

TEST(TemperatureDrift, MayBeginInTheRecord) {
  const PhsParams p = Frictionless();
  const PhsSystem s =
      Compile(With(p, "temperature_drift", {{"rate_K_per_s", 0.1}, {"start_s", 40}}));
  EXPECT_DOUBLE_EQ(s.Ambient(30), p.temperature_K);
  EXPECT_NEAR(s.Ambient(50) - p.temperature_K, 1, 1e-9);
}

// dT/dt = r [start < t < stop] - T/T_s, by small steps of its own.
TEST(TemperatureDrift, ComesBackOnceItsSourceEnds) {
  constexpr double kRate = 0.1, kStart = 20, kStop = 70, kSettling = 30;
  const PhsParams p = Frictionless();
  const PhsSystem s = Compile(With(p, "temperature_drift",
                                   {{"rate_K_per_s", kRate},
                                    {"start_s", kStart},
                                    {"stop_s", kStop},
                                    {"settling_s", kSettling}}));
  double rise = 0, time = 0;
  for (const double next : {10.0, 20.0, 45.0, 70.0, 71.0, 100.0, 190.0}) {
    for (constexpr double kStep = 1e-3; time < next - kStep / 2; time += kStep) {
      const double middle = time + kStep / 2;
      const double source = middle > kStart && middle < kStop ? kRate : 0;
      rise += kStep * (source - rise / kSettling) / (1 + kStep / (2 * kSettling));
    }
    EXPECT_NEAR(s.Ambient(next) - p.temperature_K, rise, 1e-5) << next << " s";
  }
  const PhsSystem steady =
      Compile(With(p, "temperature_drift", {{"rate_K_per_s", kRate}, {"stop_s", kStop}}));
  EXPECT_NEAR(steady.Ambient(60) - p.temperature_K, 6, 1e-12);
  EXPECT_NEAR(steady.Ambient(500) - p.temperature_K, 7, 1e-12);
}

// Two ways to the same hour of a day: a run over it with the temperature as a law of time, and a
// filling at 20 °C used at the temperature of that hour (hydraulics/warm_filling.h).
TEST(TemperatureDrift, ADayOverARunMeetsTheFillingUsedAtEachHour) {
  PhsParams p = Frictionless();
  for (auto& l : p.lines) l.gas_volume_m3 = 100e-6;
  const PhsSystem day = Compile(With(
      p, "temperature_drift", {{"rate_K_per_s", 0}, {"amplitude_K", -40}, {"period_s", 86400}}));
  for (const double hour : {2.0, 6.0, 9.0, 12.0, 18.0}) {
    PhsParams at = p;
    at.filled_at_K = p.temperature_K;
    at.temperature_K = p.temperature_K - 40 * std::sin(2 * M_PI * hour / 24);
    const PhsSystem filled = Compile(at);
    EXPECT_NEAR(day.Ambient(3600 * hour), at.temperature_K, 1e-9);
    const double over_the_day = Hold(day, 0, 3600 * hour, 60).p_bore;
    EXPECT_NEAR(over_the_day / Hold(filled, 0, 1, 1).p_bore, 1, 2e-3) << hour;
  }
}

TEST(Effects, ResistanceAndInertanceOnOneChamberAddUp) {
  PhsParams p = With(With(Frictionless(), "line_resistance"), "line_inertance");
  const PhsSystem s = Compile(p);
  EXPECT_EQ(s.num_states(), 4) << "one volume and one flow per chamber";
}

// The same as a model that declares so much gas; the other line stays.
TEST(GasVolume, IsThatOfTheReservoir) {
  const PhsParams plain = Frictionless();
  PhsParams declared = plain;
  declared.lines[0].gas_volume_m3 *= 0.6;
  const Held with = Hold(Compile(With(plain, "gas_volume", {{"factor", 0.6}}, {"L1"})), 1e-3, 0);
  const Held expected = Hold(Compile(declared), 1e-3, 0), before = Hold(Compile(plain), 1e-3, 0);
  EXPECT_DOUBLE_EQ(with.p_rod, expected.p_rod);
  EXPECT_GT(std::abs(with.p_rod - before.p_rod), 1e4);
  EXPECT_DOUBLE_EQ(with.p_bore, before.p_bore);
}

}  // namespace
}  // namespace phs::effects
