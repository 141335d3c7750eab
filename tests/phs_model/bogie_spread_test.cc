// The quarter rig's model spread over a bogie against the Bo-Bo model written by hand.
#include "phs_model/bogie_spread.h"

#include <gtest/gtest.h>

#include "phs_model/phs_model.h"

namespace phs::effects {

using phs_model::AddEffect;
using phs_model::CreatePhsSystem;
using phs_model::FindPhsParams;
using phs_model::IsQuarter;
using phs_model::SpreadOverBogie;
namespace {

TEST(BogieSpreadTest, QuarterModelGivesTheBoBoNetwork) {
  const auto quarter = FindPhsParams("quarter_setup2").value();
  const auto bo_bo = FindPhsParams("bo_bo").value();
  ASSERT_TRUE(IsQuarter(quarter));
  EXPECT_FALSE(IsQuarter(bo_bo));
  const auto spread = SpreadOverBogie(quarter);
  ASSERT_EQ(spread.cylinders.size(), bo_bo.cylinders.size());
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(spread.cylinders[i].name, bo_bo.cylinders[i].name);
    EXPECT_EQ(spread.cylinders[i].bore_line, bo_bo.cylinders[i].bore_line);
    EXPECT_EQ(spread.cylinders[i].rod_line, bo_bo.cylinders[i].rod_line);
    EXPECT_EQ(spread.lines[i].name, bo_bo.lines[i].name);
    EXPECT_DOUBLE_EQ(spread.lines[i].static_pressure_Pa, bo_bo.lines[i].static_pressure_Pa);
    EXPECT_DOUBLE_EQ(spread.lines[i].oil_volume_m3, bo_bo.lines[i].oil_volume_m3);
    EXPECT_DOUBLE_EQ(spread.lines[i].gas_volume_m3, bo_bo.lines[i].gas_volume_m3);
    EXPECT_DOUBLE_EQ(spread.lines[i].accumulator.volume_m3, bo_bo.lines[i].accumulator.volume_m3);
  }
  EXPECT_EQ(spread.friction.model, bo_bo.friction.model);
  EXPECT_EQ(spread.friction.force_N, bo_bo.friction.force_N);
  EXPECT_DOUBLE_EQ(spread.friction.stiffness_N_per_m, bo_bo.friction.stiffness_N_per_m);
  EXPECT_EQ(CreatePhsSystem(spread).value().num_cylinders(), 4);
}

TEST(BogieSpreadTest, EffectsFollowTheirLinesAndInstrumentsStayBehind) {
  auto quarter = FindPhsParams("quarter_setup2").value();
  ASSERT_TRUE(AddEffect(&quarter, "entrained_air").ok());
  quarter.effects.back().targets = {quarter.cylinders[0].bore_line};
  ASSERT_TRUE(AddEffect(&quarter, "sensor_gain").ok());
  ASSERT_TRUE(AddEffect(&quarter, "stribeck").ok());
  const auto spread = SpreadOverBogie(quarter);
  ASSERT_EQ(spread.effects.size(), 2u);
  EXPECT_EQ(spread.effects[0].targets, (std::vector<std::string>{"L2", "L3"}));
  EXPECT_TRUE(spread.effects[1].targets.empty());
  EXPECT_TRUE(CreatePhsSystem(spread).ok());
}

TEST(BogieSpreadTest, WhatARigOnNoListTaughtRunsInTheBogie) {
  auto quarter = FindPhsParams("quarter_setup2").value();
  quarter.effects.push_back({"moving_mass", {}, {{"mass_kg", 200}}});
  hydraulics::EffectParams valve{"unlisted", {"L2"}, {{"c1_m3_per_s", 2e-8}}};
  valve.formula = "c1*(max(p-2e6[Pa],0[Pa])/1e6[Pa])";
  quarter.effects.push_back(valve);
  const auto spread = SpreadOverBogie(quarter);
  ASSERT_EQ(spread.effects.size(), 1u) << "the mass of the rig's load cell stays behind";
  EXPECT_EQ(spread.effects[0].targets, (std::vector<std::string>{"L2", "L3"}));
  const auto system = CreatePhsSystem(spread);
  ASSERT_TRUE(system.ok()) << system.error().Line();
  EXPECT_EQ(system.value().num_states(),
            CreatePhsSystem(SpreadOverBogie(FindPhsParams("quarter_setup2").value()))
                    .value()
                    .num_states() +
                2)
      << "a flow out of each diagonal line";
}

}  // namespace
}  // namespace phs::effects
