#include "effects/formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {

using phs_model::AddEffect;
using phs_model::CreatePhsSystem;
using phs_model::FindPhsParams;
using rigs::RigKind;
using rigs::RigModel;
using rigs::RigMotion;
using rigs::RigPrediction;
namespace {

double Value(const std::string& text, const hydraulics::ForcePlace& place) {
  const auto formula = Formula::Parse(text, {{"c1", 3.0}, {"c2", -2.0}});
  EXPECT_TRUE(formula.ok()) << (formula.ok() ? "" : formula.error().Line());
  return formula.ok() ? formula.value().Value(place) : NAN;
}

std::string Refusal(const std::string& text) {
  const auto formula = Formula::Parse(text, {{"c1", 3.0}});
  return formula.ok() ? "" : formula.error().Line();
}

TEST(Formula, EvaluatesAsWritten) {
  hydraulics::ForcePlace at;
  at.piston = 0.01, at.speed = -0.2, at.direction = -1, at.bore_rise = 3e5, at.time = 7;
  at.temperature = 5;
  EXPECT_DOUBLE_EQ(Value("c1*s*(p/1e5[Pa])", at), -9);
  EXPECT_DOUBLE_EQ(Value("c1 - c2*2", at), 7);
  EXPECT_DOUBLE_EQ(Value("c1*(x/0.02[m])^2 + c2*(v/0.1[m/s])", at), 0.75 + 4);
  EXPECT_NEAR(Value("c1*sin(2*pi*x/0.04[m])", at), 3, 1e-12);
  EXPECT_NEAR(Value("c1*sqrt(abs(v)/0.05[m/s])*exp(-t/7[s])", at), 6 * std::exp(-1), 1e-12);
  EXPECT_DOUBLE_EQ(Value("5[N/m]*x - 2[N]*(dT/10[K])", at), 0.05 - 1);
  EXPECT_DOUBLE_EQ(Value("4e-4[m^2]*p", at), 120);
  EXPECT_DOUBLE_EQ(Value("-c1^1*2", at), -6);
}

TEST(Formula, DimensionsAndNamesAreChecked) {
  EXPECT_NE(Refusal("c1 + x").find("unequal dimensions"), std::string::npos);
  EXPECT_NE(Refusal("c1*x").find("no force"), std::string::npos);
  EXPECT_NE(Refusal("c1*sin(x)").find("dimension"), std::string::npos);
  EXPECT_NE(Refusal("c1*y").find("unknown name y"), std::string::npos);
  EXPECT_NE(Refusal("c1*(x/2[ft])").find("unknown unit ft"), std::string::npos);
  EXPECT_NE(Refusal("c1*(s").find("not closed"), std::string::npos);
  EXPECT_NE(Refusal("c1 c1").find("unexpected"), std::string::npos);
  EXPECT_NE(Refusal("").find("missing"), std::string::npos);
  std::string deep;
  for (int i = 0; i < 3000; ++i) deep += "(";
  EXPECT_FALSE(Refusal(deep).empty());
}

TEST(Formula, WhatNeverHasAFiniteValueIsRefused) {
  EXPECT_NE(Refusal("c1/0").find("a division by zero"), std::string::npos);
  EXPECT_NE(Refusal("c1*(x/(1[m]-1[m]))").find("a division by zero"), std::string::npos);
  EXPECT_NE(Refusal("c1*0^-1").find("without finite value"), std::string::npos);
  EXPECT_NE(Refusal("c1*(1e308*1e308)").find("without finite value"), std::string::npos);
  EXPECT_NE(Refusal("c1*sqrt(1-2)").find("a root of a negative number"), std::string::npos);
  // A coefficient is another number in the next fit.
  EXPECT_TRUE(Formula::Parse("c1*(c1/c2)", {{"c1", 1.0}, {"c2", 0.0}}).ok());
}

TEST(Formula, LargerOfTwoAndOtherUnits) {
  hydraulics::ForcePlace at;
  at.bore_rise = 3e6;
  EXPECT_DOUBLE_EQ(Value("c1*max(p-1e6[Pa],0[Pa])/1e6[Pa]", at), 6);
  EXPECT_DOUBLE_EQ(Value("c1*max(p-4e6[Pa],0[Pa])/1e6[Pa]", at), 0);
  EXPECT_NE(Refusal("c1*max(p,0)").find("unequal dimensions"), std::string::npos);
  EXPECT_NE(Refusal("c1*max(p)").find("two values"), std::string::npos);
  const std::map<std::string, double> c = {{"c1", 2.0}};
  const auto volume = Formula::Parse("c1*(p/1e6[Pa])^2 + 1e-6[m^3]", c, FormulaUnit::kVolume);
  ASSERT_TRUE(volume.ok()) << volume.error().Line();
  EXPECT_DOUBLE_EQ(volume.value().Value(at), 18 + 1e-6);
  const auto flow = Formula::Parse("c1*(p/1e6[Pa])*(t/1[s])", c, FormulaUnit::kFlow);
  ASSERT_TRUE(flow.ok());
  EXPECT_EQ(flow.value().VariableOtherThan("p"), "t");
  EXPECT_EQ(flow.value().VariableOtherThan("pt"), "");
  EXPECT_FALSE(Formula::Parse("c1 + 1[m]", c, FormulaUnit::kFlow).ok());
}

/// Bore pressure of the quarter rig with one unlisted effect, compressed and held for a time.
double HeldBorePressure(const std::string& formula, const std::string& coefficient, double value,
                        const std::string& target, double duration) {
  hydraulics::PhsParams params = FindPhsParams("quarter_setup2").value();
  hydraulics::EffectParams effect{"unlisted", {target}, {{coefficient, value}}};
  effect.formula = formula;
  if (!formula.empty()) params.effects.push_back(effect);
  const auto system = CreatePhsSystem(params);
  EXPECT_TRUE(system.ok()) << (system.ok() ? "" : system.error().Line());
  return system.ok() ? Hold(system.value(), -2e-3, duration).p_bore : NAN;
}

TEST(Unlisted, VolumeOfALineAddsToItsCompliance) {
  // c1 (p/P) with c1/P = V_oil/beta is as much oil again.
  hydraulics::PhsParams twice = FindPhsParams("quarter_setup2").value();
  auto& line = twice.lines[static_cast<size_t>(twice.FindLine("L2"))];
  const double more = line.oil_volume_m3 / line.bulk_modulus_Pa * 1e6;
  line.oil_volume_m3 *= 2;
  const double expected = Hold(CreatePhsSystem(twice).value(), -2e-3, 0).p_bore;
  EXPECT_NEAR(HeldBorePressure("c1*(p/1e6[Pa])", "c1_m3", more, "L2", 0), expected,
              1e-5 * expected);
  // And stores as much.
  hydraulics::PhsParams formula = FindPhsParams("quarter_setup2").value();
  hydraulics::EffectParams effect{"unlisted", {"L2"}, {{"c1_m3", more}}};
  effect.formula = "c1*(p/1e6[Pa])";
  formula.effects.push_back(effect);
  const double x = -2e-3, v = 0;
  double stored[2];
  int k = 0;
  for (const auto* params : {&twice, &formula}) {
    const auto system = CreatePhsSystem(*params);
    ASSERT_TRUE(system.ok());
    const std::vector<double> rest(static_cast<size_t>(system.value().num_states()), 0.0);
    Evaluation e(system.value());
    system.value().Calc(0, &x, &v, rest.data(), &e.out);
    stored[k++] = e.out.stored_energy;
  }
  EXPECT_NEAR(stored[1] / stored[0], 1, 1e-4);
}

TEST(Unlisted, ReliefValveHoldsALineNearItsOpening) {
  const double closed = HeldBorePressure("", "", 0, "L2", 0);
  ASSERT_GT(closed, 4e6);
  const std::string valve = "c1*(max(p-1e6[Pa],0[Pa])/1e6[Pa])";
  EXPECT_NEAR(HeldBorePressure(valve, "c1_m3_per_s", 1e-4, "L2", 5), 2.8e6, 1e3)
      << "bled down to the opening, 1 MPa above static";
  EXPECT_NEAR(HeldBorePressure(valve, "c1_m3_per_s", 1e-4, "L1", 5), closed, 1e3)
      << "the other line lies below it";
}

TEST(Unlisted, AReadingChangesItsChannelAlone) {
  hydraulics::PhsParams params = FindPhsParams("quarter_setup2").value();
  RigMotion motion{0, 0.005, {{}}, {}, {}, {}, {}};
  for (int i = 0; i < 400; ++i) motion.position_m[0].push_back(1e-3 * std::sin(0.02 * i));
  const auto run = [&](const std::string& formula, const std::string& coefficient, double value,
                       std::vector<std::string> targets) {
    hydraulics::PhsParams with = params;
    if (!formula.empty()) {
      with.effects.push_back({"unlisted", std::move(targets), {{coefficient, value}}, formula});
    }
    RigPrediction out;
    const auto rig = RigModel::Create(RigKind::kQuarter, with);
    EXPECT_TRUE(rig.ok() && rig.value().Run(motion, &out).ok());
    return out.channels;
  };
  const auto plain = run("", "", 0, {});
  const double static_rod =
      params.lines[static_cast<size_t>(params.FindLine(params.cylinders[0].rod_line))]
          .static_pressure_Pa;
  const auto laser = run("c1*(x/1e-3[m])^2", "c1_m", 1e-5, {});
  const auto sensor = run("c1*(q/1e6[Pa])*(t/1[s])", "c1_Pa", 3e4, {params.cylinders[0].bore_line});
  for (size_t i = 0; i < plain[0].size(); i += 37) {
    EXPECT_NEAR(laser[0][i], plain[0][i] + 1e-5 * std::pow(plain[0][i] / 1e-3, 2), 1e-15);
    const double rise = (plain[3][i] - static_rod) / 1e6, t = 0.005 * static_cast<double>(i);
    EXPECT_NEAR(sensor[2][i], plain[2][i] + 3e4 * rise * t, 1e-6);
  }
  const auto tap = run("c1*(v/0.05[m/s])^2", "c1_Pa", -1e5, {params.cylinders[0].rod_line});
  for (size_t i = 37; i < 399; i += 37) {
    const double v = 1e-3 * 0.02 * std::cos(0.02 * static_cast<double>(i)) / 0.005;
    EXPECT_NEAR(tap[3][i] - plain[3][i], -1e5 * std::pow(v / 0.05, 2), 0.2) << "of 640 Pa";
  }
  const auto cell = run("c1*(max(F+2e4[N],0[N])/1e4[N])^2", "c1_N", -40, {});
  const auto askew = run("c1*(F/1e4[N])*(x/1e-3[m])", "c1_N", 60, {});
  for (size_t i = 0; i < plain[0].size(); i += 37) {
    const double load = plain[1][i] / 1e4;
    EXPECT_NEAR(cell[1][i], plain[1][i] - 40 * std::pow(std::max(load + 2, 0.0), 2), 1e-9);
    EXPECT_NEAR(askew[1][i], plain[1][i] + 60 * load * plain[0][i] / 1e-3, 1e-9);
  }
  const auto strained = run("c1*(F/1e4[N])", "c1_Pa", 5e4, {params.cylinders[0].bore_line});
  EXPECT_NEAR(strained[2][200], plain[2][200] + 5 * plain[1][200], 1e-6);
  for (const size_t other : {0, 2, 3}) EXPECT_EQ(cell[other], plain[other]);
  for (const size_t other : {1, 2, 3}) EXPECT_EQ(laser[other], plain[other]);
  for (const size_t other : {0, 1, 3}) EXPECT_EQ(sensor[other], plain[other]);
}

TEST(Unlisted, ALawWithoutAmountDoesNothingWhereverItActs) {
  const hydraulics::PhsParams params = FindPhsParams("quarter_setup2").value();
  for (const auto& [formula, target] :
       {std::pair{"c1*(max(-p-1e6[Pa],0[Pa])/1e6[Pa])", "L2"}, std::pair{"c1*(x/1[m])", "1"}}) {
    hydraulics::PhsParams with = params;
    with.effects.push_back({"unlisted", {target}, {{"c1_m3_per_s", 0}}, formula});
    EXPECT_TRUE(CreatePhsSystem(with).ok()) << formula;
  }
  hydraulics::PhsParams wrong = params;
  wrong.effects.push_back({"unlisted", {"L2"}, {{"c1_Pa", 0}}, "c1*(p"});
  EXPECT_FALSE(CreatePhsSystem(wrong).ok()) << "it must still be a law";
}

TEST(Unlisted, RefusesWhatHasNoMeaning) {
  const auto refusal = [](const std::string& formula, std::map<std::string, double> values,
                          std::vector<std::string> targets) {
    hydraulics::PhsParams params = FindPhsParams("quarter_setup2").value();
    hydraulics::EffectParams effect{"unlisted", std::move(targets), std::move(values)};
    effect.formula = formula;
    params.effects.push_back(effect);
    const auto system = CreatePhsSystem(params);
    return system.ok() ? "" : system.error().Line();
  };
  using testing::HasSubstr;
  EXPECT_THAT(refusal("c1*(x/1[m])", {{"c1_m3", 1e-6}}, {"L1"}), HasSubstr("over x"));
  EXPECT_THAT(refusal("c1", {{"c1_m3_per_s", 1e-9}}, {"L1"}), HasSubstr("vanish at rest"));
  EXPECT_THAT(refusal("c1*(p/1[Pa])", {{"c1_m3_per_s", 1e-9}}, {}), HasSubstr("without targets"));
  EXPECT_THAT(refusal("c1", {{"c1_N", 5}}, {"L1"}), HasSubstr("not on lines"));
  EXPECT_THAT(refusal("c1*(p/1[Pa])", {{"c1_m3", 1e-9}}, {"1"}), HasSubstr("not to cylinders"));
  EXPECT_THAT(refusal("c1*s", {{"c1_N", 5}, {"c1_m3", 1e-9}}, {}), HasSubstr("two units"));
  EXPECT_THAT(refusal("c1*s", {{"c1_m", 1e-6}}, {"1"}), HasSubstr("over s"));
  EXPECT_THAT(refusal("c1*s*(F/1[N])", {{"c1_N", 1}}, {"1"}), HasSubstr("over s"));
  EXPECT_THAT(refusal("c1*(F/1[N])", {{"c1_N", 1}}, {"L1"}), HasSubstr("no piston"));
  EXPECT_THAT(refusal("c1*(F/1[N])", {{"c1_m3", 1e-6}}, {"L1"}), HasSubstr("over F"));
  EXPECT_THAT(refusal("c1", {{"c1_m", 1e-6}}, {"L1"}), HasSubstr("no piston"));
  EXPECT_THAT(refusal("c1", {{"c1_Pa", 1e3}}, {"1"}), HasSubstr("that of a line"));
  EXPECT_THAT(refusal("c1*s", {{"c1_N", 5}}, {"L9"}), HasSubstr("none of the model's"));
}

TEST(Unlisted, ActsInACylinderAndIsWrittenBack) {
  auto loaded = FindPhsParams("quarter_setup2");
  ASSERT_TRUE(loaded.ok());
  hydraulics::PhsParams params = loaded.value();
  const auto plain = CreatePhsSystem(params);
  ASSERT_TRUE(plain.ok());
  ASSERT_TRUE(AddEffect(&params, "unlisted").ok());
  EXPECT_FALSE(CreatePhsSystem(params).ok()) << "no formula";
  params.effects[0].formula = "c1*(x/0.01[m]) + c2*s*(p/1e6[Pa])";
  params.effects[0].values["c1_N"] = 500;
  params.effects[0].values["c2_N"] = 40;
  auto map = YamlMap::Parse(phs_model::ToYaml(params), "again");
  ASSERT_TRUE(map.ok());
  auto again = phs_model::ReadPhsParams(map.value());
  ASSERT_TRUE(again.ok()) << again.error().Line();
  EXPECT_EQ(again.value().effects[0].formula, params.effects[0].formula);
  const auto with = CreatePhsSystem(again.value());
  ASSERT_TRUE(with.ok()) << with.error().Line();
  double force[2], pressure = 0;
  const double x = 0.004, v = 0.01;
  const hydraulics::PhsSystem* systems[2] = {&plain.value(), &with.value()};
  for (int k = 0; k < 2; ++k) {
    hydraulics::PhsOutputs out;
    out.force = &force[k];
    out.p_bore = &pressure;
    systems[k]->Calc(0, &x, &v, nullptr, &out);
  }
  EXPECT_NEAR(force[1] - force[0], 500 * 0.4 + 40 * (pressure - 1.8e6) / 1e6, 1e-6);
}

}  // namespace
}  // namespace phs::effects
