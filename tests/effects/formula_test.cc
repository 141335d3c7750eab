#include "effects/formula.h"

#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"

namespace phs::effects {
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
  auto map = YamlMap::Parse(hydraulics::ToYaml(params), "again");
  ASSERT_TRUE(map.ok());
  auto again = hydraulics::ReadPhsParams(map.value());
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
