// The conicity that a run keeps is that of its own wheels, rails and gauge.
#include "analysis/pair_conicity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "rail/contact_functions.h"
#include "tests/rail/contact_pair.h"
#include "vehicle/scenario_file.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

vehicle::Simulation Simulated(const std::string& bogie, const std::string& changes) {
  auto scenario = vehicle::ScenarioWith(
      "", R"({"track": "straight", "speed_m_s": 15, "bogie": ")" + bogie + "\"" + changes + "}");
  EXPECT_TRUE(scenario.ok()) << scenario.error().Line();
  auto simulation = vehicle::Simulation::Create(scenario.value());
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  return std::move(simulation).value();
}

double ValueAt(const Json& curve, double amplitude_m) {
  for (size_t i = 0; i < curve["amplitude_m"].size(); ++i) {
    if (std::abs(curve["amplitude_m"][i].get<double>() - amplitude_m) < 1e-9) {
      return curve["equivalent"][i];
    }
  }
  ADD_FAILURE() << "no amplitude " << amplitude_m;
  return 0;
}

// Wickens, Fundamentals of Rail Vehicle Dynamics, 2003, section 2.3: a cone on round rails.
TEST(PairConicity, OfAConeItIsWickens) {
  const double cone = 0.05;
  const rail::WheelRail pair = rail::Create(rail::ConeOnArc("0.05", "0.3"));
  const Json json = ConicityJson(CalcConicity(pair, 0));
  ASSERT_TRUE(json.contains("curves")) << json.dump();
  ASSERT_EQ(json["curves"].size(), 1u);
  const double wickens = cone * (0.75 + 0.3 * cone) / (0.75 - 0.46 * cone);
  EXPECT_NEAR(ValueAt(json["curves"][0], 3e-3) / wickens, 1, 5e-3);
  EXPECT_EQ(json["wheel"], "cone:0.05");
}

TEST(PairConicity, OfARunItIsThatOfItsBindingToTheBit) {
  const auto simulation = Simulated("phs", "");
  const Json json = ConicityJson(CalcConicity(simulation));
  const rail::WheelRail& pair = simulation.binding().wheel_rail();
  const auto own = rail::CalcContactFunctions(pair, pair, 10e-3, 0.1e-3);
  ASSERT_TRUE(own.ok());
  ASSERT_EQ(json["curves"].size(), 2u);
  const Json& rigid = json["curves"][0];
  ASSERT_EQ(rigid["amplitude_m"].size(), own.value().conicity.size());
  ASSERT_GT(own.value().conicity.size(), 4u);
  for (size_t i = 0; i < own.value().conicity.size(); ++i) {
    EXPECT_EQ(rigid["amplitude_m"][i], own.value().conicity[i].amplitude);
    EXPECT_EQ(rigid["equivalent"][i], own.value().conicity[i].value);
  }
  EXPECT_EQ(json["gauge_m"], pair.params().gauge);
  EXPECT_EQ(json["wheel"], "S1002.prw");
  // Under load the wheel's own share of the vehicle's weight.
  const double load = json["curves"][1]["wheel_load_N"];
  EXPECT_NEAR(4 * load, simulation.model()->body_subtreemass[0] * 9.81, 1);
  EXPECT_GT(json["curves"][1]["equivalent"].size(), 4u);
}

TEST(PairConicity, WornTreadsAndOtherGaugesHaveTheirOwn) {
  const auto at_3_mm = [](const rail::WheelRailParams& p) {
    return ValueAt(ConicityJson(CalcConicity(rail::Create(p), 0))["curves"][0], 3e-3);
  };
  rail::WheelRailParams p = rail::StandardPair();
  const double as_new = at_3_mm(p);
  EXPECT_NEAR(as_new, 0.18, 0.01);  // S1002 on UIC60, 1435 mm: the usual figure
  p.wear.depth_m = 2e-3;
  EXPECT_GT(at_3_mm(p), 1.2 * as_new);
  EXPECT_EQ(ConicityJson(CalcConicity(rail::Create(p), 0))["worn_depth_m"], 2e-3);
  p.wear.depth_m = 0;
  p.gauge = 1.432;
  EXPECT_GT(at_3_mm(p), 1.1 * as_new);
}

TEST(PairConicity, WithoutProfilesItSaysSo) {
  const auto simulation = Simulated("cooperrider", "");
  const Json json = ConicityJson(CalcConicity(simulation));
  EXPECT_FALSE(json.contains("curves"));
  EXPECT_THAT(json["missing"].get<std::string>(), HasSubstr("no wheel and rail profiles"));
  EXPECT_THAT(json["missing"].get<std::string>(), HasSubstr("a conicity of 0.05"));
}

}  // namespace
}  // namespace phs::analysis
