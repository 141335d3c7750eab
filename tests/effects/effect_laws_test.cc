// The law of every effect, on its own: closed formulas at a few points.
#include <gtest/gtest.h>

#include <cmath>

#include "../hydraulics/test_systems.h"
#include "effects/catalogue.h"
#include "effects/rig_model.h"

namespace phs::effects {
namespace {

using hydraulics::BoBo;
using hydraulics::Evaluation;
using hydraulics::FrictionModel;
using hydraulics::kAtmosphere;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;
using hydraulics::Quarter;

PhsParams With(PhsParams params, const std::string& effect,
               std::map<std::string, double> values = {}, std::vector<std::string> targets = {}) {
  params.effects.push_back({effect, std::move(targets), std::move(values)});
  return params;
}

PhsSystem Compile(const PhsParams& params) { return hydraulics::Make(params, &Catalogue()); }

// Holds the motion x(t) = rate t (from 0) for `duration`, h = step; returns the last evaluation.
struct Held {
  double force, pressure_force, friction, piston, p_bore, p_rod;
  std::vector<double> state;
};
template <typename Motion>
Held Drive(const PhsSystem& s, double duration, double h, Motion motion) {
  std::vector<double> state(s.num_states(), 0.0), rate(state);
  Evaluation e(s);
  const int n = static_cast<int>(std::lround(duration / h));
  double v = 0;
  for (int i = 0; i < n; ++i) {
    const double x = motion(i * h);
    v = (motion((i + 1) * h) - x) / h;
    s.CalcStateRate(i * h, h, &x, &v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
  }
  const double x = motion(duration);
  s.Calc(duration, &x, &v, state.data(), &e.out);
  return {e.force[0],  e.pressure_force[0], e.friction[0], e.piston[0],
          e.p_bore[0], e.p_rod[0],          state};
}
Held Hold(const PhsSystem& s, double x, double duration, double h = 1e-3) {
  return Drive(s, duration, h, [x](double) { return x; });
}

PhsParams Frictionless() {
  PhsParams p = Quarter();
  p.friction.model = FrictionModel::kNone;
  return p;
}

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

TEST(LineInertance, RingsAtItsFrequency) {
  // Chamber oil C1 against line C2 through I: w² = (1/C1 + 1/C2)/I.
  PhsParams params = Frictionless();
  const double I = 1.6e7, share = 0.2;
  const PhsSystem s = Compile(
      With(params, "line_inertance",
           {{"inertance_kg_per_m4", I}, {"laminar_Pas_per_m3", 1e6}, {"oil_share", share}}));
  const auto& l = params.lines[0];
  const double C1 = share * l.oil_volume_m3 / l.bulk_modulus_Pa;
  const double C2 =
      (1 - share) * l.oil_volume_m3 / l.bulk_modulus_Pa + l.gas_volume_m3 / l.static_pressure_Pa;
  const double period = 2 * M_PI / std::sqrt((1 / C1 + 1 / C2) / I);
  const double x = 1e-7;
  const double start = Hold(s, x, 0).p_rod, half = Hold(s, x, period / 2, period / 4000).p_rod;
  const double full = Hold(s, x, period, period / 4000).p_rod;
  const double settled = l.static_pressure_Pa + x * params.cylinders[0].RodArea() / (C1 + C2);
  EXPECT_NEAR((full - settled) / (start - settled), 1, 2e-2);
  EXPECT_NEAR((half - settled) / (start - settled), -1, 2e-2);
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

TEST(Cavitation, HoldsThePulledLineNearTheReleasePressure) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const PhsSystem s = Compile(With(params, "cavitation", {{"release_Pa", 5e5}}));
  const double with = Hold(s, 8e-4, 0).p_bore;
  EXPECT_LT(with, 5e5);
  EXPECT_GT(with, 2e5);
  EXPECT_LT(Hold(Compile(params), 8e-4, 0).p_bore, 1e4);
}

// Friction effects: force when sliding at v, far from any reversal.
double Sliding(const PhsParams& params, double v, double start = 0, double pressure_x = 0) {
  (void)pressure_x;
  const PhsSystem s = Compile(params);
  return Drive(s, 1.0, 1e-3, [=](double t) { return start + v * t; }).friction;
}

TEST(Stribeck, RaisesSlowSliding) {
  const PhsParams p = Quarter();
  for (double v : {1e-3, -4e-3}) {
    const double extra =
        Sliding(With(p, "stribeck", {{"extra_N", 500}, {"speed_m_s", 2e-3}}), v) - Sliding(p, v);
    EXPECT_NEAR(extra, std::copysign(500 * std::exp(-std::abs(v) / 2e-3), v), 1e-3);
  }
}

TEST(Presliding, TurnsALookUpIntoASpringBeforeSliding) {
  PhsParams p = Quarter();
  p.friction.model = FrictionModel::kStatic;
  p.friction.damping_Ns_per_m = 0;
  const PhsSystem s = Compile(With(p, "presliding", {{"stiffness_N_per_m", 2e7}}));
  const Held h = Drive(s, 1, 1e-3, [](double t) { return 2e-5 * std::min(t, 0.5) * 2; });
  EXPECT_NEAR(h.friction, 2e7 * 2e-5, 1e-6);
}

TEST(PressureFriction, GrowsWithThePressureOfEachChamber) {
  const PhsParams p = Quarter();
  const double kb = 2e-4, kr = 1e-4;
  const PhsParams with =
      With(p, "pressure_friction", {{"bore_N_per_Pa", kb}, {"rod_N_per_Pa", kr}});
  const PhsSystem s = Compile(p);
  const double v = -2e-3;
  const Held at = Drive(s, 1.0, 1e-3, [v](double t) { return v * t; });
  const double expected =
      kb * (at.p_bore - 1.8e6) + kr * (at.p_rod - p.lines[0].static_pressure_Pa);
  EXPECT_NEAR(Sliding(with, v) - Sliding(p, v), -expected, 0.03 * std::abs(expected))
      << "the bristle follows the rising level by its own length";
}

TEST(PositionFriction, ScalesTheLevel) {
  const PhsParams p = Quarter();
  const PhsParams with =
      With(p, "position_friction", {{"slope_1_per_m", 30}, {"curvature_1_per_m2", 1e3}});
  const double y = 5e-3 + 1e-3;
  EXPECT_NEAR(Sliding(with, 1e-3, 5e-3) / Sliding(p, 1e-3, 5e-3), 1 + 30 * y + 1e3 * y * y, 1e-3);
}

TEST(DwellFriction, BreakawayGrowsWithRest) {
  const PhsParams p =
      With(Quarter(), "dwell_friction", {{"extra_N", 600}, {"time_s", 2}, {"length_m", 1e-3}});
  const PhsSystem s = Compile(p);
  auto peak = [&s](double rest) {
    std::vector<double> state(s.num_states(), 0.0), rate(state);
    Evaluation e(s);
    double x = 0, top = 0;
    const double h = 1e-3;
    auto go = [&](double v, double T) {
      for (double t = 0; t < T; t += h, x += h * v) {
        s.Calc(t, &x, &v, state.data(), &e.out);
        top = std::max(top, e.friction[0]);
        s.CalcStateRate(t, h, &x, &v, state.data(), rate.data());
        for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
      }
    };
    go(5e-3, 2);
    go(-5e-3, 0.05);
    go(0, rest);
    top = 0;
    go(1e-3, 0.3);
    return top;
  };
  const double fresh = peak(0.01), rested = peak(20);
  EXPECT_GT(rested - fresh, 250);
  EXPECT_GT(peak(2) - fresh, 100);
  EXPECT_LT(peak(2), rested);
}

TEST(ViscousFriction, IsProportionalToSpeed) {
  const PhsParams p = Quarter();
  const PhsParams with =
      With(p, "viscous_friction", {{"extension_Ns_per_m", 8000}, {"retraction_Ns_per_m", 3000}});
  EXPECT_NEAR(Sliding(with, 0.01) - Sliding(p, 0.01), 80, 1e-6);
  EXPECT_NEAR(Sliding(with, -0.01) - Sliding(p, -0.01), -30, 1e-6);
}

TEST(AsymmetricFriction, ShiftsLevelsApart) {
  const PhsParams p = Quarter();
  const PhsParams with = With(p, "asymmetric_friction", {{"level_N", 150}});
  EXPECT_NEAR(Sliding(with, 0.01) - Sliding(p, 0.01), 150, 1e-6);
  EXPECT_NEAR(Sliding(with, -0.01) - Sliding(p, -0.01), 150, 1e-6);
}

TEST(Backlash, PistonStaysWhileThePlayIsCrossed) {
  const double gap = 4e-4;
  const PhsSystem s = Compile(With(Quarter(), "backlash", {{"gap_m", gap}}));
  const Held inside = Drive(s, 1, 1e-3, [](double t) { return 1.5e-4 * t; });
  EXPECT_NEAR(inside.force, 0, 1e-6);
  EXPECT_NEAR(inside.piston, 0, 2e-6) << "held by friction";
  const Held beyond = Drive(s, 1, 1e-3, [](double t) { return 2e-3 * t; });
  EXPECT_NEAR(beyond.piston, 2e-3 - gap / 2 - beyond.force / 1e9, 1e-9);
}

TEST(MountCompliance, DeflectsByForceOverStiffness) {
  const double k = 4.1e7;
  const PhsSystem s = Compile(With(Quarter(), "mount_compliance", {{"stiffness_N_per_m", k}}));
  for (double x : {3e-3, -2e-3}) {
    const Held h = Drive(s, 1, 1e-3, [x](double t) { return x * t; });
    EXPECT_NEAR(x - h.piston, h.force / k, 1e-12);
    EXPECT_NEAR(h.force - h.pressure_force - h.friction, 0, 1e-6);
    EXPECT_NEAR(h.friction,
                x > 0 ? 1850 + 100 * (x - 1e-3) / 9e-3 : -1600 - 100 * (2e-3 - 1e-3) / 9e-3, 30);
  }
}

TEST(BushViscoelastic, RelaxesWithItsTime) {
  // Against a cylinder much stiffer than the bush (no gas): F = (k + k2 exp(-t/tau)) x.
  PhsParams p = Frictionless();
  for (auto& l : p.lines) l.gas_volume_m3 = 0, l.oil_volume_m3 = 1e-7;
  const double k = 1e7, k2 = 5e6, tau = 0.2, x = 1e-5;
  const PhsSystem s =
      Compile(With(p, "bush_viscoelastic",
                   {{"stiffness_N_per_m", k}, {"relaxing_N_per_m", k2}, {"relaxation_s", tau}}));
  const double h = 1e-4;
  const auto step = [x, h](double t) { return t >= h ? x : 0; };
  const Held soon = Drive(s, 2 * h, h, step), later = Drive(s, tau + h, h, step);
  const Held end = Drive(s, 20 * tau, h, step);
  const double F0 = end.force;
  EXPECT_NEAR((soon.force - F0) / ((k2 * x)), 1, 0.02);
  EXPECT_NEAR((later.force - F0) / (soon.force - F0), std::exp(-1), 0.01);
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

TEST(Instruments, GainOffsetDriftDelayOnPredictedChannels) {
  RigMotion motion;
  motion.step_s = 0.01;
  motion.position_m.resize(1);
  for (int i = 0; i < 400; ++i) motion.position_m[0].push_back(1e-3 * std::sin(0.02 * i));
  const PhsParams p = Quarter();
  auto run = [&](const PhsParams& params) {
    Result<RigModel> rig = RigModel::Create(RigKind::kQuarter, params);
    EXPECT_TRUE(rig.ok()) << rig.error().Line();
    RigPrediction out;
    EXPECT_TRUE(rig.value().Run(motion, &out).ok());
    return out.channels;
  };
  const auto plain = run(p);
  const auto offset = run(With(p, "sensor_offset", {{"load_N", 120}, {"p_rod_Pa", -3e4}}));
  const auto drift = run(With(p, "sensor_drift", {{"p_bore_Pa_per_s", 500}}));
  const auto gain = run(With(p, "sensor_gain", {{"load", 1.05}}));
  const auto delay = run(With(p, "sensor_delay", {{"load_s", 0.025}}));
  EXPECT_DOUBLE_EQ(offset[1][200], plain[1][200] + 120);
  EXPECT_DOUBLE_EQ(offset[3][200], plain[3][200] - 3e4);
  EXPECT_DOUBLE_EQ(drift[2][200], plain[2][200] + 1000);
  EXPECT_DOUBLE_EQ(gain[1][200], 1.05 * plain[1][200]);
  EXPECT_NEAR(delay[1][200], 0.5 * (plain[1][197] + plain[1][198]), 1e-6);
}

TEST(Catalogue, HasEveryNameOfTheDocumentOnce) {
  for (const char* name : {"piston_leakage",    "external_leakage",  "line_resistance",
                           "line_inertance",    "check_restriction", "entrained_air",
                           "hose_expansion",    "gas_thermal",       "accumulator_precharge",
                           "cavitation",        "stribeck",          "presliding",
                           "pressure_friction", "position_friction", "dwell_friction",
                           "viscous_friction",  "backlash",          "mount_compliance",
                           "bush_viscoelastic", "sensor_offset",     "sensor_drift",
                           "sensor_delay",      "sensor_gain",       "temperature_drift"}) {
    int found = 0;
    for (const auto& info : Catalogue().effects()) found += info.name == name;
    EXPECT_EQ(found, 1) << name;
  }
  for (const auto& info : Catalogue().effects()) {
    for (const auto& p : info.parameters) {
      EXPECT_LE(p.min, p.low) << info.name << "." << p.name;
      EXPECT_LE(p.high, p.max) << info.name << "." << p.name;
      EXPECT_TRUE(p.otherwise >= p.min && p.otherwise <= p.max) << info.name << "." << p.name;
    }
  }
}

TEST(Catalogue, UnknownNamesAndKeysGiveTheNearest) {
  const auto wrong = CreatePhsSystem(With(Quarter(), "backlas"));
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().Line().find("did you mean backlash?"), std::string::npos);
  const auto key = CreatePhsSystem(With(Quarter(), "backlash", {{"gapp_m", 1}}));
  ASSERT_FALSE(key.ok());
  EXPECT_NE(key.error().Line().find("did you mean gap_m?"), std::string::npos);
  const auto range = CreatePhsSystem(With(Quarter(), "backlash", {{"gap_m", -1}}));
  ASSERT_FALSE(range.ok());
  EXPECT_NE(range.error().Line().find("effects.backlash.gap_m"), std::string::npos);
  const auto target = CreatePhsSystem(With(Quarter(), "backlash", {}, {"7"}));
  ASSERT_FALSE(target.ok());
}

TEST(Effects, ResistanceAndInertanceOnOneChamberAddUp) {
  PhsParams p = With(With(Frictionless(), "line_resistance"), "line_inertance");
  const PhsSystem s = Compile(p);
  EXPECT_EQ(s.num_states(), 4) << "one volume and one flow per chamber";
}

}  // namespace
}  // namespace phs::effects
