// `rig: bogie` on records of the independent multibody program (tests/rigdata/bogie_curve).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/data_path.h"
#include "identify/run/bogie_run.h"
#include "tests/base/scratch_dir.h"
#include "tests/rigdata/bogie_curve/truth.h"

namespace phs::identify::search {
namespace {

class BogieIndependentTest : public testing::Test {
 protected:
  /// A run of the independent bogie, as it is.
  static bogie_curve::MeasuredRun Run(const bogie_curve::Truth& truth) {
    const bogie_curve::TrackLine track(truth.design);
    bogie_curve::RunWish wish;
    wish.last_s = track.Length() - 5;
    const auto wheel = FindData("profile", "models/profiles", "S1002", {".prw"});
    EXPECT_TRUE(wheel.ok());
    const std::string profiles = std::filesystem::path(wheel.value()).parent_path();
    return bogie_curve::Measure(bogie_curve::MakeBogie(truth, track, profiles), wish);
  }
  /// A measured run of R = 550 m with something hidden, or nothing: what is found in it.
  nlohmann::ordered_json Identified(uint64_t seed, const std::string& hide, double value,
                                    const std::string& candidates) const {
    bogie_curve::Truth truth = bogie_curve::DeclaredTruth("r550");
    bogie_curve::DrawOffDeclared(seed, &truth);
    if (!hide.empty()) bogie_curve::Hide(hide, value, &truth);
    bogie_curve::MeasuredRun run = Run(truth);
    bogie_curve::AddInstruments(seed, &run);
    return Found(run, "measured_r550", "[0.2, 13]", "[13, 24.5]", candidates, 1);
  }
  nlohmann::ordered_json Found(const bogie_curve::MeasuredRun& run, const std::string& scenario,
                               const std::string& estimation, const std::string& validation,
                               const std::string& candidates, int max_effects) const {
    std::ofstream(scratch_.File("run.csv")) << bogie_curve::Csv(run);
    std::ofstream(scratch_.File("manifest.yaml"))
        << "rig: bogie\nmodel: " << scenario << "\ndata: run.csv\nestimation: " << estimation
        << "\nvalidation: " << validation << "\ncandidates: [" << candidates << "]\n";
    const auto manifest = measurement::LoadManifest(scratch_.File("manifest.yaml"));
    EXPECT_TRUE(manifest.ok());
    auto dir = ResultDir::Create(scratch_.File("out"), true);
    SearchOptions options;
    options.effort.max_effects = max_effects;
    const auto outcome = IdentifyBogie(manifest.value(), options, nullptr, dir.value());
    EXPECT_TRUE(outcome.ok()) << outcome.error().Line();
    return outcome.value().result;
  }
  std::string ScenarioOfR250() const {
    std::ofstream(scratch_.File("r250.yaml"))
        << "track: curve_r250\nvehicle: bogie\nbogie: phs_declared\nspeed_km_h: 50\n"
        << "wheel: S1002\nrail: UIC60\nfriction: 0.35\ncreep: kalker_table\n";
    return scratch_.File("r250.yaml");
  }
  ScratchDir scratch_;
};

// With the whole catalogue, as a user asks it. White noise as large as Polach's law makes of it had
// `wheel_rail_friction` of 0.20 accepted; one difference of theories in each channel, `line_resistance`.
TEST_F(BogieIndependentTest, NothingIsNamedInACleanRecord) {
  const auto result = Identified(1, "", 0, "");
  EXPECT_TRUE(result["effects"].empty()) << result["effects"].dump(1);
  EXPECT_EQ(result["verdict"], "sufficient") << result["reasons"].dump(1);
}

// In a tight curve the two programs put the axles 0.04 to 0.08 mm apart. Predicted with the
// vehicle, friction came out 0.92 and gas 1.2 times as it is there; forces and pressures at the
// measured ways do not know of it.
TEST_F(BogieIndependentTest, NumbersOfThePhsDoNotFollowWhereTheAxlesStand) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  bogie_curve::Truth truth = bogie_curve::DeclaredTruth("r250");
  const auto result = Found(Run(truth), ScenarioOfR250(), "[0.2, 16]", "[16, 30.8]", "", 0);
  const auto value = [&](const char* name) {
    return result["fitted"][name]["value"].get<double>();
  };
  EXPECT_NEAR(value("friction.scale"), 1, 0.02);
  EXPECT_NEAR(value("lines.gas_volume_m3"), 16.16e-6, 0.01 * 16.16e-6);
  EXPECT_NEAR(value("lines.oil_volume_m3"), 1.1e-3, 0.1 * 1.1e-3)
      << "told by a tenth of what gas is";
  EXPECT_NEAR(value("friction.stiffness_N_per_m"), 3.6e7, 0.1 * 3.6e7);
}

// Springs of one box that put wheel loads 8 kN off were taken here: theory governs their slowest
// octave in a tight curve, and it counted for nothing however far it was off (likelihood.h).
TEST_F(BogieIndependentTest, WhatSpoilsTheWheelLoadsIsNotNamedInATightCurve) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  bogie_curve::Truth truth = bogie_curve::DeclaredTruth("r250");
  bogie_curve::DrawOffDeclared(2, &truth);
  bogie_curve::MeasuredRun run = Run(truth);
  bogie_curve::AddInstruments(2, &run);
  const auto result = Found(run, ScenarioOfR250(), "[0.2, 16]", "[16, 30.8]", "", 1);
  EXPECT_TRUE(result["effects"].empty()) << result["effects"].dump(1);
  EXPECT_EQ(result["verdict"], "sufficient") << result["reasons"].dump(1);
}

// 0.599 [0.597, 0.600] on 2026-11-26: the load of the wheels tells it.
TEST_F(BogieIndependentTest, TheSpringsOfOneBoxAreNamed) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  const auto result = Identified(32, "box_spring", 0.6, "box_spring, cant_error");
  ASSERT_EQ(result["effects"].size(), 1u) << result["candidates"].dump(1);
  EXPECT_EQ(result["effects"][0]["name"], "box_spring");
  EXPECT_EQ(result["effects"][0]["on"], nlohmann::ordered_json::array({"lead_left"}));
  EXPECT_NEAR(result["effects"][0]["parameters"]["factor"]["value"].get<double>(), 0.6, 0.01);
  EXPECT_EQ(result["verdict"], "explained") << result["reasons"].dump(1);
}

TEST_F(BogieIndependentTest, TheSealOfOneCylinderIsNamed) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  const auto result = Identified(8, "seal_1", 3, "");
  ASSERT_EQ(result["effects"].size(), 1u) << result["candidates"].dump(1);
  EXPECT_EQ(result["effects"][0]["name"], "seal_friction");
  EXPECT_EQ(result["effects"][0]["on"], nlohmann::ordered_json::array({"1"}));
  EXPECT_NEAR(result["effects"][0]["parameters"]["factor"]["value"].get<double>(), 3, 0.3);
}

// On no list: one wheel larger than the rest.
TEST_F(BogieIndependentTest, UnequalWheelsAreNotNamed) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  const auto result = Identified(31, "wheel_larger", 5e-4, "");
  EXPECT_TRUE(result["effects"].empty()) << result["effects"].dump(1);
  EXPECT_EQ(result["verdict"], "not_described");
}

TEST_F(BogieIndependentTest, ALeakIsNamed) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  const auto result = Identified(5, "leak_L2", 3e-12, "external_leakage, cant_error");
  ASSERT_EQ(result["effects"].size(), 1u) << result["candidates"].dump(1);
  EXPECT_EQ(result["effects"][0]["name"], "external_leakage");
  EXPECT_NEAR(result["effects"][0]["parameters"]["conductance_m3_per_Pas"]["value"].get<double>(),
              3e-12, 3.5e-13)
      << "3.2e-12 on 2026-11-26: what theory leaves open takes a part of it";
}

// L2 and L3 tell the ratio of their gas. Which of them is off, what L1 and L4 show would say, but
// there the ways cancel: what is left of their noise is no evidence for either.
TEST_F(BogieIndependentTest, TheGasOfOneLineIsNamedOrSaidToBeOneOfTwo) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  const auto result = Identified(9606, "gas_L3", 1.5, "gas_volume");
  ASSERT_EQ(result["effects"].size(), 1u) << result["candidates"].dump(1);
  const auto& effect = result["effects"][0];
  EXPECT_EQ(effect["name"], "gas_volume");
  const double factor = effect["parameters"]["factor"]["value"].get<double>();
  if (effect["on"] == nlohmann::ordered_json::array({"L3"})) {
    EXPECT_NEAR(factor, 1.5, 0.25);
  } else {
    EXPECT_EQ(effect["on"], nlohmann::ordered_json::array({"L2"}));
    EXPECT_NEAR(factor, 1 / 1.5, 0.12);
    EXPECT_EQ(effect["confusable_with"], nlohmann::ordered_json::array({"gas_volume on L3"}));
    EXPECT_EQ(result["verdict"], "undecidable");
  }
}

}  // namespace
}  // namespace phs::identify::search
