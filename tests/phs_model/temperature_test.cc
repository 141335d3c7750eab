// filled_at_K in a model file: a charge is that of the filling, and the file is written back with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "phs_model/bogie_spread.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {
namespace {

using hydraulics::PhsParams;

double BorePressure(const PhsParams& params) {
  const Result<hydraulics::PhsSystem> system = CreatePhsSystem(params);
  EXPECT_TRUE(system.ok());
  return system.value().params().lines[1].static_pressure_Pa;
}

TEST(Temperature, FollowsOnlyWhereTheFillingIsKnown) {
  PhsParams p = FindPhsParams("quarter_setup4").value();
  ASSERT_TRUE(SetParameter(&p, "temperature_K", 263.15).ok());
  EXPECT_EQ(BorePressure(p), 1.8e6) << "stated at the temperature it is used at";
  ASSERT_TRUE(SetParameter(&p, "filled_at_K", 293.15).ok());
  EXPECT_LT(BorePressure(p), 1.5e6);
  ASSERT_TRUE(SetParameter(&p, "L2.temperature_K", 293.15).ok());
  EXPECT_EQ(BorePressure(p), 1.8e6) << "a line of its own temperature";
}

TEST(Temperature, ComesBackFromAFile) {
  PhsParams p = SpreadOverBogie(FindPhsParams("quarter_setup2").value());
  p.filled_at_K = 288.15;
  p.temperature_K = 300;
  p.oil_expansion_1_per_K = 7e-4;
  p.lines[2].temperature_K = 310;
  auto map = YamlMap::Parse(ToYaml(p), "model.yaml");
  ASSERT_TRUE(map.ok());
  EXPECT_EQ(ReadPhsParams(map.value()).value(), p);
}

// The gas that a charge gives depends on the ratio of two pressures at the filling alone: not on
// the temperature of use.
TEST(Temperature, AChargeIsThatOfTheFilling) {
  const auto gas = [](const std::string& temperatures) {
    auto map = YamlMap::Parse(
        "name: t\n" + temperatures +
            "cylinders: [{name: \"1\", bore_line: A, rod_line: B}]\n"
            "line_defaults: {reservoir: {law: bwr, volume_m3: 0.32e-3, charge_pressure_Pa: "
            "1.0e6}}\n"
            "lines: [{name: A, static_pressure_Pa: 1.0e7}, {name: B, static_pressure_Pa: 1.0e7}]\n",
        "t.yaml");
    return ReadPhsParams(map.value()).value().lines[0].gas_volume_m3;
  };
  EXPECT_EQ(gas("temperature_K: 253.15\nfilled_at_K: 293.15\n"), gas("temperature_K: 293.15\n"));
  EXPECT_NE(gas("temperature_K: 253.15\n"), gas("temperature_K: 293.15\n"));
}

}  // namespace
}  // namespace phs::phs_model
