// `phs identify` of step tables: all setups of Table B-1 as one record; what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "identify/run/steps_run.h"
#include "identify/run/steps_search.h"
#include "phs_model/phs_model.h"
#include "phs_places.h"
#include "tests/base/scratch_dir.h"

namespace phs::identify {
namespace {

using ::testing::HasSubstr;

const std::string kTable = PHS_TEST_DATA "/../rigs/lowe_table_b1.csv";

class StepsIdentifyTest : public ::testing::Test {
 protected:
  Result<RigOutcome> Identify(const std::string& text) {
    Result<measurement::Manifest> manifest =
        measurement::LoadManifest(folder_.Write("manifest.yaml", text));
    if (!manifest.ok()) return manifest.error();
    Result<ResultDir> dir = ResultDir::Create(folder_.File("out"), true);
    PHS_CHECK(dir.ok());
    Result<RigOutcome> out = IdentifySteps(manifest.value(), dir.value());
    if (out.ok()) {
      EXPECT_TRUE(dir.value().Commit().ok());
    }
    return out;
  }
  std::string Refused(const std::string& text) {
    const Result<RigOutcome> out = Identify(text);
    return out.ok() ? "was accepted" : out.error().Line();
  }
  static std::string Run(int setup) {
    return "  - {model: quarter_setup" + std::to_string(setup) + ", data: " + kTable + "}\n";
  }
  ScratchDir folder_;
};

// All setups as one record take a third of a minute: who stops it must not wait for that.
TEST_F(StepsIdentifyTest, StopsBeforeTheNextFit) {
  const auto manifest = measurement::LoadManifest(folder_.Write(
      "m.yaml", "rig: steps\nshared: [lines.oil_volume_m3]\nruns:\n" + Run(3) + Run(4)));
  ASSERT_TRUE(manifest.ok());
  const auto dir = ResultDir::Create(folder_.File("out"), true);
  int asked = 0;
  const auto made = IdentifySteps(manifest.value(), dir.value(), [&] { return ++asked < 4; });
  EXPECT_FALSE(made.ok());
  EXPECT_EQ(asked, 4);
}

TEST_F(StepsIdentifyTest, TwoSetupsAsOneRecord) {
  const Result<RigOutcome> made =
      Identify("rig: steps\nshared: [lines.oil_volume_m3, L1.accumulator_precharge_Pa]\nruns:\n" +
               Run(3) + Run(4));
  ASSERT_TRUE(made.ok()) << made.error().Line();
  const auto& r = made.value().result;
  std::vector<std::string> effects;
  for (const auto& e : r["effects"]) effects.push_back(e["name"]);
  EXPECT_THAT(effects, ::testing::Contains("filling"));
  EXPECT_EQ(r["runs"].size(), 2U);
  EXPECT_LT(r["runs"][0]["errors"]["settled_left_out"]["of_gauge"].get<double>(), 0.046);
  EXPECT_LT(r["runs"][1]["errors"]["settled_left_out"]["of_gauge"].get<double>(), 0.02);
  // The data ask for gas that warms, in both.
  EXPECT_EQ(std::count(effects.begin(), effects.end(), "gas_thermal"), 2);
  // One value for all runs, or one for each.
  EXPECT_TRUE(r["fitted"].contains("lines.oil_volume_m3"));
  EXPECT_TRUE(r["fitted"].contains("quarter_setup4: L2.gas_volume_m3"));
  for (const auto& [name, v] : r["fitted"].items()) {
    EXPECT_LT(v["low"].get<double>(), v["value"].get<double>()) << name;
    EXPECT_GT(v["high"].get<double>(), v["value"].get<double>()) << name;
  }
  for (const char* file : {"model.yaml", "model_4.yaml"}) {
    const auto model = phs_model::LoadPhsParams(folder_.File("out") + "/" + file);
    ASSERT_TRUE(model.ok()) << model.error().Line();
    EXPECT_STREQ(model.value().lines[0].reservoir.law->name, "ideal");
    EXPECT_TRUE(phs_model::CreatePhsSystem(model.value()).ok());
  }
}

TEST_F(StepsIdentifyTest, WhatCannotBeFittedIsRefused) {
  const std::string setup1 = "rig: steps\nmodel: quarter_setup1\ndata: " + kTable + "\n";
  EXPECT_THAT(Refused(setup1 + "free: [lines.oil_volume_m3, L1.accumulator_precharge_Pa, "
                               "L1.static_pressure_Pa, L2.static_pressure_Pa]\n"),
              HasSubstr("4 numbers (lines.oil_volume_m3, L1.accumulator_precharge_Pa, "
                        "L1.static_pressure_Pa, L2.static_pressure_Pa) for 3 settled pressures"));
  EXPECT_THAT(Refused(setup1 + "shared: [lines.oil_volume_m3]\n"), HasSubstr("no runs to share"));
  EXPECT_THAT(Refused("rig: steps\nshared: [lines.oil_volume]\nruns:\n" + Run(3) + Run(4)),
              HasSubstr("did you mean lines.oil_volume_m3?"));
  EXPECT_THAT(Refused("rig: steps\nruns:\n  - {data: " + kTable + "}\n"), HasSubstr("model"));
  EXPECT_THAT(Refused(setup1 + "free: [L1.gas_volume_m3]\n"), HasSubstr("is 0 in the declared"));
}

// Setup 1 has three pressures: its oil alone can be told, a filling of two numbers cannot.
TEST_F(StepsIdentifyTest, ThreePressuresTellOneNumber) {
  const Result<RigOutcome> made =
      Identify("rig: steps\nmodel: quarter_setup1\ndata: " + kTable + "\n");
  ASSERT_TRUE(made.ok()) << made.error().Line();
  EXPECT_EQ(made.value().result["fitted"].size(), 1U);
  for (const auto& c : made.value().result["candidates"]) {
    if (c["name"] != "filling") continue;
    EXPECT_THAT(c["why"].get<std::string>(), HasSubstr("3 numbers"));
    EXPECT_TRUE(c["error_left_out"].is_null());
  }
}

}  // namespace
}  // namespace phs::identify
