#include "rigs/element_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"

namespace phs::effects {

using phs_model::AddEffect;
using phs_model::CreatePhsSystem;
using phs_model::FindPhsParams;
using rigs::RigKind;
using rigs::RigModel;
using rigs::RigMotion;
using rigs::RigPrediction;
namespace {

hydraulics::PhsParams Part() {
  hydraulics::PhsParams p;
  p.name = "part";
  p.cylinders.push_back({});
  p.cylinders[0].name = "1";
  p.friction.model = hydraulics::FrictionModel::kNone;
  return p;
}

hydraulics::PhsParams WithEffect(hydraulics::PhsParams p, const std::string& effect,
                                 const std::map<std::string, double>& values) {
  EXPECT_TRUE(AddEffect(&p, effect).ok());
  for (const auto& [key, value] : values) p.effects.back().values[key] = value;
  return p;
}

std::vector<double> Force(const hydraulics::PhsParams& params, const RigMotion& motion) {
  const auto model = RigModel::Create(RigKind::kElement, params);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.error().Line());
  RigPrediction out;
  EXPECT_TRUE(model.value().Run(motion, &out).ok());
  return out.channels[0];
}

RigMotion Sine(double amplitude, double hertz, double step, int n) {
  RigMotion m;
  m.step_s = step;
  m.position_m.resize(1), m.speed_m_s.resize(1);
  const double w = 2 * M_PI * hertz;
  for (int i = 0; i < n; ++i) {
    m.position_m[0].push_back(amplitude * std::sin(w * i * step));
    m.speed_m_s[0].push_back(amplitude * w * std::cos(w * i * step));
  }
  return m;
}

TEST(ElementBench, MassSpringAreaAndOffsetAddUp) {
  hydraulics::PhsParams p = Part();
  p.element = {.mass_kg = 2, .stiffness_N_per_m = 300, .pressure_area_m2 = 1e-4, .offset_N = 5};
  p = WithEffect(WithEffect(p, "moving_mass", {{"mass_kg", 1}}), "pressure_area",
                 {{"area_m2", 4e-4}});
  RigMotion m = Sine(0.01, 1.5, 1e-4, 20000);
  m.pressure_Pa.assign(20000, 2e5);
  const std::vector<double> f = Force(p, m);
  const double w = 2 * M_PI * 1.5, x = m.position_m[0][7777];
  EXPECT_NEAR(f[7777], -3 * w * w * x + 300 * x + 5e-4 * 2e5 + 5, 1e-4);
}

/// 12 bar on 5 cm² over 0.2 m of gas, adiabatic: at 0.05 m the gas has three quarters of its length,
/// 600 N (0.75^-1.4 - 1) = 297.6 N; turned round it pulls the same at -0.05 m.
TEST(ElementBench, GasSpringHardeningAndQuadraticDampingFollowTheirLaws) {
  hydraulics::PhsParams p = Part();
  p.element = {.gas_force_N = 600, .gas_length_m = 0.2, .gas_exponent = 1.4};
  EXPECT_NEAR(rigs::GasSpringForce(p.element, 0.05), 297.6, 0.1);
  EXPECT_NEAR(rigs::GasSpringForce(p.element, 1e-6) / 1e-6, 1.4 * 600 / 0.2, 0.1);
  EXPECT_EQ(rigs::GasSpringForce(p.element, 0), 0);
  hydraulics::ElementParams turned = p.element;
  turned.gas_length_m = -0.2;
  EXPECT_EQ(rigs::GasSpringForce(turned, -0.05), -rigs::GasSpringForce(p.element, 0.05));
  EXPECT_TRUE(std::isfinite(rigs::GasSpringForce(p.element, 0.3)));
  p.element.hardening_N_per_m3 = 4e6, p.element.quadratic_damping_Ns2_per_m2 = 700;
  p.element.damping_Ns_per_m = 30;
  RigMotion m = Sine(0.01, 1.5, 1e-4, 20000);
  const std::vector<double> f = Force(p, m);
  for (const int i : {1234, 7777, 15000}) {
    const double x = m.position_m[0][i], v = m.speed_m_s[0][i];
    EXPECT_NEAR(
        f[i],
        4e6 * x * x * x + 30 * v + 700 * v * std::abs(v) + 600 * (std::pow(1 - x / 0.2, -1.4) - 1),
        1e-9);
  }
}

/// A damper of 4000 N s/m that holds 40 N, with a play of 0.6 mm: whatever the contact, it carries what
/// the part holds, at most 40 N + 4000 N s/m times 20.1 mm/s.
TEST(ElementBench, APlayCarriesWhatThePartHoldsHoweverStiffItsContact) {
  hydraulics::PhsParams p = Part();
  auto& f = p.friction;
  f.model = hydraulics::FrictionModel::kPresliding;
  f.curve = hydraulics::FrictionCurve::kCoulomb;
  f.coulomb_extension_N = f.coulomb_retraction_N = 40;
  f.breakaway_extension_N = f.breakaway_retraction_N = 40;
  f.viscous_extension_Ns_per_m = f.viscous_retraction_Ns_per_m = 4000;
  f.stiffness_N_per_m = 2e6, f.damping_Ns_per_m = 0, f.breakaway_ratio = 0.98;
  RigMotion m = Sine(8e-3, 0.4, 2.5e-3, 4000);
  m.speed_m_s.clear();
  std::vector<double> soft;
  for (const double contact : {2e6, 1e8, 3e8, 1e9, 1e11}) {
    const std::vector<double> force =
        Force(WithEffect(p, "backlash", {{"gap_m", 6e-4}, {"contact_N_per_m", contact}}), m);
    if (soft.empty()) soft = force;
    double largest = 0, apart = 0;
    for (size_t i = 0; i < force.size(); ++i) {
      largest = std::max(largest, std::abs(force[i]));
      apart += std::abs(force[i] - soft[i]) / static_cast<double>(force.size());
    }
    EXPECT_NEAR(largest, 40 + 4000 * 8e-3 * 2 * M_PI * 0.4, 0.5) << contact;
    EXPECT_LT(apart, 2) << contact;
  }
}

/// A bench answers one channel; the other one is what drives it.
TEST(ElementBench, ReadingsHangOnTheTrueForceAndTheTrueMotion) {
  hydraulics::PhsParams p = Part();
  p.element = {.mass_kg = 2, .stiffness_N_per_m = 300};
  p.effects.push_back({"unlisted", {}, {{"c1_N", 0.5}}, "c1*(F/1[N])*(x/0.01[m])"});
  const RigMotion m = Sine(0.01, 1, 1e-3, 2000);
  const std::vector<double> shown = Force(p, m);
  p.effects.clear();
  const std::vector<double> carried = Force(p, m);
  for (const size_t i : {100, 777, 1900}) {
    EXPECT_NEAR(shown[i], carried[i] * (1 + 0.5 * m.position_m[0][i] / 0.01), 1e-12);
  }
  const auto by_force = [&m](const hydraulics::PhsParams& params) {
    rigs::RigOptions options;
    options.driven_by = rigs::Drive::kForce;
    const auto rig = RigModel::Create(RigKind::kElement, params, options);
    EXPECT_TRUE(rig.ok());
    RigPrediction out;
    EXPECT_TRUE(rig.value().Run(m, &out).ok());
    return out.channels[0];
  };
  const std::vector<double> moved = by_force(p);
  EXPECT_EQ(by_force(WithEffect(p, "sensor_offset", {{"load_N", 0.1}})), moved)
      << "the force is given";
  EXPECT_NEAR(by_force(WithEffect(p, "sensor_offset", {{"piston_m", 2e-3}}))[1500],
              moved[1500] + 2e-3, 1e-12);
}

TEST(ElementBench, AGasSpringOfNoLengthIsRefused) {
  hydraulics::PhsParams p = Part();
  p.element = {.gas_force_N = 600, .gas_length_m = 0};
  const auto model = RigModel::Create(RigKind::kElement, p);
  ASSERT_FALSE(model.ok());
  EXPECT_EQ(model.error().where, "element.gas_length_m");
}

TEST(ElementBench, FlexibleLoadFollowsItsTransferFunctionBelowAtAndAboveResonance) {
  const double m = 10, mf = 3, f0 = 20, zeta = 0.07;
  hydraulics::PhsParams p = Part();
  p.element.mass_kg = m;
  p = WithEffect(p, "load_flexibility",
                 {{"mass_kg", mf}, {"frequency_Hz", f0}, {"damping_ratio", zeta}});
  for (const double hertz : {2.0, 20.0, 55.0}) {
    const double step = 2e-5, w = 2 * M_PI * hertz, w0 = 2 * M_PI * f0;
    const int n = static_cast<int>(3.0 / step);
    const std::vector<double> force = Force(p, Sine(1e-3, hertz, step, n));
    const std::complex<double> i(0, 1);
    const std::complex<double> passed =
        (w0 * w0 + 2.0 * i * zeta * w0 * w) / (w0 * w0 - w * w + 2.0 * i * zeta * w0 * w);
    const std::complex<double> expected = -w * w * 1e-3 * (m - mf + mf * passed);
    std::complex<double> seen = 0;  // over whole periods at the end, long after the start
    const int whole = static_cast<int>(std::lround(std::floor(1.5 * hertz) / hertz / step));
    for (int k = n - whole; k < n; ++k)
      seen += force[k] * std::exp(-i * (w * k * step)) * 2.0 / double(whole);
    EXPECT_NEAR(std::abs(seen * i - expected), 0, 2e-3 * std::abs(expected)) << hertz;
  }
}

TEST(ElementBench, BehindAGapNothingRubsAndBehindASpringFrictionComesLate) {
  hydraulics::PhsParams p = Part();
  p.friction.model = hydraulics::FrictionModel::kStatic;
  p.friction.curve = hydraulics::FrictionCurve::kCoulomb;
  p.friction.coulomb_extension_N = p.friction.coulomb_retraction_N = 50;
  p.friction.breakaway_extension_N = p.friction.breakaway_retraction_N = 50;
  p.friction.viscous_extension_Ns_per_m = p.friction.viscous_retraction_Ns_per_m = 0;
  p.friction.ramp_speed_m_s = 1e-5;
  RigMotion m;
  m.step_s = 1e-3;
  m.position_m.resize(1);
  for (int i = 0; i < 2000; ++i) m.position_m[0].push_back(1e-6 * i);  // 1 mm/s
  const std::vector<double> gap =
      Force(WithEffect(p, "backlash", {{"gap_m", 4e-4}, {"contact_N_per_m", 1e7}}), m);
  EXPECT_NEAR(gap[150], 0, 1e-6) << "inside half the play";
  EXPECT_NEAR(gap[400], 50, 0.5) << "carried along";
  const std::vector<double> spring =
      Force(WithEffect(p, "mount_compliance", {{"stiffness_N_per_m", 1e5}}), m);
  EXPECT_NEAR(spring[200], 20, 2.0) << "1e5 N/m over 0.2 mm, less the creep of the ramp";
  EXPECT_NEAR(spring[1500], 50, 0.1);
}

TEST(ElementBench, WarmFrictionIsLowerByItsSlope) {
  hydraulics::PhsParams p = Part();
  p.friction.model = hydraulics::FrictionModel::kStatic;
  RigMotion m = Sine(0.05, 0.1, 1e-2, 1000);
  m.temperature_K.assign(1000, p.temperature_K);
  const std::vector<double> cold =
      Force(WithEffect(p, "temperature_friction", {{"slope_1_per_K", 0.02}}), m);
  m.temperature_K.assign(1000, p.temperature_K + 10);
  const std::vector<double> warm =
      Force(WithEffect(p, "temperature_friction", {{"slope_1_per_K", 0.02}}), m);
  EXPECT_NEAR(warm[10] / cold[10], 0.8, 1e-12);
}

TEST(ElementBench, MassBehindTheLoadCellOfARigAddsItsInertia) {
  const hydraulics::PhsParams p = FindPhsParams("quarter_setup2").value();
  const double w = 2 * M_PI * 5, a = 1e-3, step = 1e-3;
  const RigMotion motion = Sine(a, 5, step, 1000);
  RigPrediction plain, heavy;
  for (auto [params, out] : {std::pair{p, &plain},
                             std::pair{WithEffect(p, "moving_mass", {{"mass_kg", 200}}), &heavy}}) {
    const auto rig = RigModel::Create(RigKind::kQuarter, params);
    ASSERT_TRUE(rig.ok()) << rig.error().Line();
    ASSERT_TRUE(rig.value().Run(motion, out).ok());
  }
  for (size_t i = 50; i < 950; i += 37) {
    const double inertia = -200 * a * w * w * std::sin(w * step * static_cast<double>(i));
    EXPECT_NEAR(heavy.channels[1][i] - plain.channels[1][i], inertia, 1e-3 * 200 * a * w * w);
    EXPECT_EQ(heavy.channels[2][i], plain.channels[2][i]) << "pressures know nothing of it";
  }
}

TEST(ElementBench, BenchEffectsAreRefusedInACylinderWithLines) {
  hydraulics::PhsParams p = FindPhsParams("quarter_setup2").value();
  ASSERT_TRUE(AddEffect(&p, "load_flexibility").ok());
  const auto system = CreatePhsSystem(p);
  ASSERT_FALSE(system.ok());
  EXPECT_NE(system.error().Line().find("bench only"), std::string::npos);
}

/// Force more by the area times the chamber's rise, in the load cell alone.
TEST(ElementBench, OnARigAnAreaCarriesTheRiseOfItsLine) {
  const hydraulics::PhsParams plain = FindPhsParams("quarter_setup2").value();
  RigMotion motion{0, 0.005, {{}}, {}, {}, {}, {}};
  for (int i = 0; i < 400; ++i) motion.position_m[0].push_back(1e-3 * std::sin(0.02 * i));
  const auto run = [&](const hydraulics::PhsParams& params) {
    RigPrediction out;
    const auto rig = RigModel::Create(RigKind::kQuarter, params);
    EXPECT_TRUE(rig.ok() && rig.value().Run(motion, &out).ok());
    return out.channels;
  };
  const auto without = run(plain);
  const auto& cylinder = plain.cylinders[0];
  for (const bool bore : {true, false}) {
    const std::string& line = bore ? cylinder.bore_line : cylinder.rod_line;
    hydraulics::PhsParams params = plain;
    params.effects.push_back({"pressure_area", {line}, {{"area_m2", 2e-4}}});
    const auto with = run(params);
    const size_t channel = bore ? 2 : 3;
    const double still = plain.lines[static_cast<size_t>(plain.FindLine(line))].static_pressure_Pa;
    for (size_t i = 0; i < 400; i += 37) {
      EXPECT_EQ(with[channel][i], without[channel][i]);
      EXPECT_NEAR(with[1][i] - without[1][i], 2e-4 * (with[channel][i] - still), 1e-6);
    }
    // A hose thrusts less the straighter it is: with the 0.6th power.
    params.effects.back().values["exponent"] = 0.6;
    const auto bent = run(params);
    for (size_t i = 0; i < 400; i += 37) {
      const double rise = with[channel][i] - still;
      const double thrust = std::copysign(2e-4 * 1e7 * std::pow(std::abs(rise) / 1e7, 0.6), rise);
      EXPECT_NEAR(bent[1][i] - without[1][i], thrust, 1e-6);
    }
  }
}

}  // namespace
}  // namespace phs::effects
