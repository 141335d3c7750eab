// Filling at one temperature, use at another: each part against its closed formula, the whole
// against its own balance, and against what was found of the quarter rig.
#include "hydraulics/warm_filling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hydraulics/phs_system.h"

namespace phs::hydraulics {
namespace {

using ::testing::HasSubstr;

constexpr double kFilled = 293.15, kP = 1.8e6;

/// One cylinder between two lines alike.
PhsParams Quarter(double gas_m3) {
  PhsParams p;
  p.name = "test";
  p.friction.model = FrictionModel::kNone;
  CylinderParams c;
  c.name = "1", c.bore_line = "L2", c.rod_line = "L1";
  p.cylinders.push_back(c);
  for (const char* name : {"L1", "L2"}) {
    LineParams l;
    l.name = name;
    l.static_pressure_Pa = kP;
    l.gas_volume_m3 = gas_m3;
    l.reservoir.volume_m3 = 0.32e-3;
    p.lines.push_back(l);
  }
  return p;
}

PhsParams At(PhsParams p, double temperature_K) {
  p.filled_at_K = kFilled;
  p.temperature_K = temperature_K;
  return AtItsTemperature(p).value();
}

double Pressure(const PhsParams& p, double temperature_K) {
  return At(p, temperature_K).lines[1].static_pressure_Pa;
}

TEST(WarmFilling, WithoutTheKeysNothingChanges) {
  PhsParams p = Quarter(16e-6);
  p.temperature_K = 260;
  EXPECT_EQ(AtItsTemperature(p).value(), p);
  EXPECT_EQ(Pressure(p, kFilled), kP) << "used where it was filled";
}

TEST(WarmFilling, GasAloneFollowsGayLussac) {
  PhsParams p = Quarter(100e-6);
  p.oil_expansion_1_per_K = 0;
  for (LineParams& l : p.lines) l.bulk_modulus_Pa = 1e11;
  for (const double T : {253.15, 283.15, 293.15, 323.15}) {
    // Oil of 1e11 Pa takes up 1.1e-3 m3/1e11 Pa beside 1e-4 m3/1.8e6 Pa: 2e-4 of the change.
    EXPECT_NEAR(Pressure(p, T), kP * T / kFilled, 3e-4 * std::abs(kP * (T / kFilled - 1)) + 1e-3);
  }
}

TEST(WarmFilling, OilAloneRisesByModulusTimesExpansion) {
  const PhsParams p = Quarter(0);
  for (const double warmer : {-1.0, 0.5, 10.0, 30.0}) {
    EXPECT_NEAR(Pressure(p, kFilled + warmer), kP + 1.4e9 * 6.65e-4 * warmer, 2e3);
  }
}

TEST(WarmFilling, OilGasAndHousingBalance) {
  for (const double gas : {5e-6, 16e-6, 180e-6}) {
    for (const double T : {261.0, 285.0, 300.0, 323.0}) {
      const PhsParams p = Quarter(gas), warm = At(p, T);
      const double now = warm.lines[1].static_pressure_Pa;
      const double grown = 6.65e-4 * 1.1e-3 * (T - kFilled);
      const double gas_now = gas * kP / now * T / kFilled;
      EXPECT_NEAR(grown, 1.1e-3 / 1.4e9 * (now - kP) + gas - gas_now, 3e-9) << gas << " " << T;
      EXPECT_NEAR(warm.lines[1].gas_volume_m3, gas_now, 1e-12);
      EXPECT_NEAR(warm.lines[1].oil_volume_m3, 1.1e-3 + grown, 1e-12);
    }
  }
}

// What an independent calculation of the quarter rig gave: setup 2 and setup 4, 1.8 MPa.
TEST(WarmFilling, QuarterRigOverADay) {
  EXPECT_NEAR(Pressure(Quarter(16.16e-6), kFilled - 32), 0.67e6, 0.01e6);
  EXPECT_NEAR(Pressure(Quarter(16.16e-6), kFilled + 30), 12.4e6, 0.1e6);
  const double setup4 = 0.32e-3 * 1.0e6 / kP;
  EXPECT_NEAR(Pressure(Quarter(setup4), kFilled - 32), 1.42e6, 0.01e6);
  EXPECT_NEAR(Pressure(Quarter(setup4), kFilled + 30), 2.26e6, 0.01e6);
}

TEST(WarmFilling, BlowOffOpensAtTheTemperatureRatio) {
  PhsParams p = Quarter(180e-6);
  p.lines[0].accumulator.volume_m3 = 0.75e-3;
  EXPECT_NEAR(At(p, 263.15).lines[0].accumulator_precharge_Pa, 15e6 * 263.15 / kFilled, 1);
  p.lines[0].accumulator.law = FindGasLaw("bwr");
  const double real = At(p, 263.15).lines[0].accumulator_precharge_Pa;
  EXPECT_LT(real, 15e6 * 263.15 / kFilled) << "dense nitrogen falls quicker than a perfect gas";
  EXPECT_GT(real, 0.95 * 15e6 * 263.15 / kFilled);
}

TEST(WarmFilling, OneLineMayBeWarmerThanTheOthers) {
  PhsParams p = Quarter(16e-6);
  p.filled_at_K = kFilled;
  p.temperature_K = kFilled;
  p.lines[0].temperature_K = 303.15;
  const PhsParams warm = AtItsTemperature(p).value();
  EXPECT_EQ(warm.lines[1], p.lines[1]);
  EXPECT_EQ(warm.lines[0].static_pressure_Pa, Pressure(Quarter(16e-6), 303.15));
}

TEST(WarmFilling, TheSystemRestsAtTheNewPressure) {
  PhsParams p = Quarter(16.16e-6);
  p.filled_at_K = kFilled;
  p.temperature_K = 273.15;
  const PhsSystem system = PhsSystem::Create(p, nullptr).value();
  const double x = 0, v = 0;
  double bore = 0, rod = 0;
  PhsOutputs out;
  out.energy = false, out.p_bore = &bore, out.p_rod = &rod;
  system.Calc(0, &x, &v, nullptr, &out);
  EXPECT_NEAR(bore / Pressure(Quarter(16.16e-6), 273.15), 1, 1e-9);
  EXPECT_EQ(system.params().filled_at_K, 0);
  EXPECT_EQ(AtItsTemperature(system.params()).value(), system.params());
}

TEST(WarmFilling, WhatCannotBeIsSaid) {
  PhsParams p = Quarter(0);
  p.filled_at_K = kFilled;
  p.temperature_K = 283.15;
  EXPECT_THAT(AtItsTemperature(p).error().Line(), HasSubstr("L1: filled at 293.15 K it would be"));
  p = Quarter(300e-6);
  p.filled_at_K = kFilled;
  p.temperature_K = 253.15;
  EXPECT_THAT(AtItsTemperature(p).error().Line(), HasSubstr("reservoir is empty of oil at 253.15"));
  p = Quarter(16e-6);
  p.lines[0].temperature_K = 280;
  EXPECT_THAT(PhsSystem::Create(p, nullptr).error().Line(), HasSubstr("without filled_at_K"));
  p.lines[0].temperature_K = 0;
  p.filled_at_K = 20;
  EXPECT_THAT(PhsSystem::Create(p, nullptr).error().Line(), HasSubstr("0 or 200 … 400"));
}

}  // namespace
}  // namespace phs::hydraulics
