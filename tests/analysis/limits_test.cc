#include "analysis/limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/base/scratch_dir.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

std::vector<NamedSummary> Summaries() {
  return {{"phs", Json::parse(R"({"status":"ok","reason":"","run":{"max_Y_over_Q":0.91,"x_m":null},
            "steady_curve":{"wheels":[{"name":"lead_outer","Y_N":-8e3}]}})")},
          {"rigid", Json::parse(R"({"status":"ok","reason":"","run":{"max_Y_over_Q":0.5}})")}};
}

Json Ratios() { return Json::parse(R"({"phs_over_rigid":{"run":{"max_Y_over_Q":1.82}}})"); }

std::vector<LimitCheck> Checks(const Limit& limit) {
  auto checks = CheckLimits({limit}, Summaries(), Ratios());
  EXPECT_TRUE(checks.ok());
  if (!checks.ok()) return {};
  // In front stand the checks that both runs ended well.
  EXPECT_EQ(checks.value()[0].quantity, "status");
  return {checks.value().begin() + 2, checks.value().end()};
}

TEST(LimitsTest, MissedLimitSaysByHowMuch) {
  const auto checks = Checks({.quantity = "run.max_Y_over_Q", .at_most = 0.8});
  ASSERT_EQ(checks.size(), 2u);
  EXPECT_FALSE(checks[0].Passed());
  EXPECT_NEAR(checks[0].excess, 0.11, 1e-12);
  EXPECT_EQ(checks[0].Text(), "phs: run.max_Y_over_Q is 0.91, at most 0.8 allowed: 0.11 too much");
  EXPECT_TRUE(checks[1].Passed());
}

TEST(LimitsTest, BoundItselfIsKeptAndAtLeastIsTheOtherWay) {
  EXPECT_TRUE(
      Checks({.quantity = "run.max_Y_over_Q", .bogie = "phs", .at_most = 0.91})[0].Passed());
  const auto low = Checks({.quantity = "run.max_Y_over_Q", .bogie = "rigid", .at_least = 0.6});
  ASSERT_EQ(low.size(), 1u);
  EXPECT_FALSE(low[0].Passed());
  EXPECT_THAT(low[0].Text(), HasSubstr("0.1 too little"));
}

TEST(LimitsTest, ListsByNameMagnitudesAndRatios) {
  const std::string y = "steady_curve.wheels.lead_outer.Y_N";
  EXPECT_TRUE(Checks({.quantity = y, .at_most = 7e3})[0].Passed());
  EXPECT_FALSE(Checks({.quantity = y, .at_most = 7e3, .of_magnitude = true})[0].Passed());
  const auto ratio = Checks({.quantity = "ratios.phs_over_rigid.run.max_Y_over_Q", .at_most = 1});
  ASSERT_EQ(ratio.size(), 1u);
  EXPECT_NEAR(ratio[0].excess, 0.82, 1e-12);
}

TEST(LimitsTest, MissingNumberAndFailedRunAreNotPassed) {
  const auto none = Checks({.quantity = "run.x_m", .at_most = 1});
  ASSERT_EQ(none.size(), 1u);
  EXPECT_FALSE(none[0].Passed());
  auto summaries = Summaries();
  summaries[1].second["status"] = "derailed";
  summaries[1].second["reason"] = "a <wheel> & \"rail\"";
  const auto checks = CheckLimits({}, summaries, Ratios());
  ASSERT_TRUE(checks.ok());
  EXPECT_TRUE(checks.value()[0].Passed());
  EXPECT_FALSE(checks.value()[1].Passed());
  const std::string xml = JUnitXml("curve", checks.value());
  EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"1\""));
  EXPECT_THAT(xml, HasSubstr("derailed: a &lt;wheel&gt; &amp; &quot;rail&quot;"));
}

TEST(LimitsTest, UnknownNamesAreErrorsWithTheNearest) {
  auto unknown = CheckLimits({{.quantity = "run.max_Y_over_q", .at_most = 1, .where = "l.yaml:2"}},
                             Summaries(), Ratios());
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(unknown.error().Line(), HasSubstr("did you mean 'run.max_Y_over_Q'?"));
  auto bogie = CheckLimits({{.quantity = "run.max_Y_over_Q", .bogie = "phx", .at_most = 1}},
                           Summaries(), Ratios());
  ASSERT_FALSE(bogie.ok());
  EXPECT_THAT(bogie.error().Line(), HasSubstr("did you mean 'phs'?"));
}

TEST(LimitsTest, FilesAreReadStrictly) {
  const std::string path = ScratchFile("limits.yaml");
  const auto load = [&](const std::string& text) {
    std::ofstream(path) << text;
    return LoadLimits(path);
  };
  const auto good = load("limits:\n  - {quantity: run.a_N, bogie: phs, at_most: 2, at_least: 1}\n");
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(good.value()[0].at_least, 1);
  EXPECT_THAT(load("limits:\n  - {quantity: a}\n").error().Line(), HasSubstr("at_most"));
  EXPECT_THAT(load("limits: []\n").error().Line(), HasSubstr("empty or missing"));
  EXPECT_THAT(load("limits:\n  - {quantity: a, atmost: 1, at_least: 0}\n").error().Line(),
              HasSubstr("did you mean 'at_most'?"));
  EXPECT_FALSE(load("limits:\n  - {quantity: a, at_most: 1, at_least: 2}\n").ok());
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace phs::analysis
