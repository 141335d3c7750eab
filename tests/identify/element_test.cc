// Identification of a part on a bench, on data made here with equations of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/data_path.h"
#include "identify/models/element_data.h"
#include "identify/run/bench_checks.h"
#include "phs_places.h"
#include "tests/identify/bench_record.h"

namespace phs::identify::element {

using measurement::LoadManifest;
namespace {

std::vector<std::string> Names(const nlohmann::ordered_json& result) {
  std::vector<std::string> names;
  for (const auto& e : result["effects"]) names.push_back(e["name"]);
  return names;
}

TEST(ElementIdentify, NothingHiddenNothingFound) {
  for (const unsigned seed : {11u, 12u, 13u}) {
    const auto r = BenchRecord("clean", seed, [](const Sample&) { return 0.0; }).Identified();
    EXPECT_TRUE(Names(r).empty()) << r["effects"].dump(1);
  }
}

/// The declared law's own ramp in place of tanh, so that the noise, which remembers three samples,
/// is all that is left: two to three times what a white noise of its differences would be.
TEST(ElementIdentify, ACleanRecordWithColouredNoiseIsSufficient) {
  for (const unsigned seed : {11u, 12u}) {
    const auto r = BenchRecord("coloured", seed, [](const Sample& s) {
                     return 30 * (std::clamp(s.v / 3e-4, -1.0, 1.0) - std::tanh(s.v / 2e-4));
                   }).Identified();
    EXPECT_TRUE(Names(r).empty()) << r["effects"].dump(1);
    EXPECT_GT(r["unexplained"]["residual_over_noise"], 1.8);
    EXPECT_EQ(r["verdict"], "sufficient") << r["reasons"];
  }
}

TEST(ElementIdentify, PressureInTheFrictionIsFoundWithItsSlope) {
  const auto r = BenchRecord("pressure", 21, [](const Sample& s) {
                   return std::tanh(s.v / 2e-4) * 2.5e-5 * s.p;
                 }).Identified();
  ASSERT_EQ(Names(r), std::vector<std::string>{"pressure_friction"}) << r["effects"].dump(1);
  const auto& slope = r["effects"][0]["parameters"]["bore_N_per_Pa"];
  EXPECT_NEAR(slope["value"].get<double>(), 2.5e-5, 1.5e-6);
  EXPECT_LT(slope["low"].get<double>(), 2.55e-5);
  EXPECT_GT(slope["high"].get<double>(), 2.45e-5);
  EXPECT_LT(r["channels"]["force_N"]["after"]["rmse"].get<double>(), 0.5);
}

TEST(ElementIdentify, AnUnlistedRippleIsDescribedByAFormulaThatRunsInTheModel) {
  const BenchRecord record(
      "ripple", 31, [](const Sample& s) { return 1.5 * std::sin(2 * M_PI * s.x / 0.004 + 0.6); });
  const auto r = record.Identified();
  ASSERT_EQ(Names(r), std::vector<std::string>{"unlisted"}) << r["effects"].dump(1);
  const std::string formula = r["unexplained"]["formula"];
  EXPECT_NE(formula.find("sin(2*pi*x/0.00"), std::string::npos) << formula;
  const double c1 = r["effects"][0]["parameters"]["c1_N"]["value"];
  const double c2 = r["effects"][0]["parameters"]["c2_N"]["value"];
  EXPECT_NEAR(std::hypot(c1, c2), 1.5, 0.08);
}

TEST(ElementIdentify, FrictionThatGrowsWithTheSquareOfSpeedIsNotBentIntoAListedEffect) {
  const auto r = BenchRecord("square", 41, [](const Sample& s) {
                   return 900 * s.v * std::abs(s.v);
                 }).Identified();
  ASSERT_EQ(Names(r), std::vector<std::string>{"unlisted"}) << r["effects"].dump(1);
  const std::string formula = r["effects"][0]["formula"];
  EXPECT_NE(formula.find("abs(v)"), std::string::npos) << formula;
  EXPECT_LT(r["channels"]["force_N"]["after"]["rmse"].get<double>(), 0.45);
}

/// What contradicts itself is named and not explained away.
TEST(ElementIdentify, ATurnedSignAndSwappedColumnsAreNamed) {
  const auto tampered = [](const std::string& name, const std::string& line) {
    const BenchRecord record(name, 61, [](const Sample&) { return 0.0; });
    std::ofstream(record.folder() / "manifest.yaml", std::ios::app) << line << '\n';
    return record.Identified();
  };
  const auto turned = tampered("turned", "factors: {force_N: -1}");
  EXPECT_EQ(turned["verdict"], "not_described");
  EXPECT_NE(turned["reasons"].dump().find("turned sign"), std::string::npos) << turned["reasons"];
  EXPECT_TRUE(Names(turned).empty());
  ASSERT_EQ(turned["next_test"].size(), 1u) << turned["next_test"];  // and no motion is designed
  EXPECT_NE(turned["next_test"][0].dump().find("mend the record first"), std::string::npos);
  EXPECT_FALSE(turned.contains("test_design"));
  const auto swapped = tampered("swapped", "columns: {x_m: force_N, force_N: x_m}");
  EXPECT_EQ(swapped["verdict"], "not_described");
  EXPECT_NE(swapped["reasons"].dump().find("under each other's name"), std::string::npos)
      << swapped["reasons"];
  EXPECT_TRUE(Names(swapped).empty());
  const auto clean = tampered("untampered", "");
  EXPECT_EQ(clean["reasons"].dump().find("turned sign"), std::string::npos) << clean["reasons"];
  EXPECT_EQ(clean["reasons"].dump().find("each other"), std::string::npos) << clean["reasons"];
}

/// A record of the declared part alone, tampered with: nothing may be explained by an effect.
class TamperedBench : public testing::Test {
 protected:
  static nlohmann::ordered_json Run(const std::string& name, const Tamper& tamper) {
    auto r = BenchRecord(
                 name, 61, [](const Sample&) { return 0.0; }, tamper)
                 .Identified();
    EXPECT_TRUE(Names(r).empty()) << name << r["effects"].dump(1);
    return r;
  }
  static bool Says(const nlohmann::ordered_json& list, const std::string& words) {
    return list.dump().find(words) != std::string::npos;
  }
};

/// A seal as measured, whose friction turns as no smooth law does: nothing is found, and the
/// declared model is not left worse than its plain fit.
TEST(ElementIdentify, WhereNothingIsAcceptedTheNumbersAreThoseThatLeaveLeast) {
  const BenchRecord folder("measured_seal", 1, [](const Sample&) { return 0.0; });
  std::ofstream(folder.folder() / "manifest.yaml")
      << "rig: element\nmodel: bench_seal\ndata: " << PHS_SOURCE_DIR
      << "/models/rigs/seal_friction/O-ring_3bar.csv\n"
         "columns: {t_s: t_ms, x_m: x_mm, p_Pa: p_bar, force_N: F_N}\nestimation: [1, "
         "40]\nvalidation: [40, 60]\n"
         "candidates: [presliding]\n";
  const auto r = IdentifiedIn(folder.folder());
  ASSERT_TRUE(Names(r).empty());
  EXPECT_EQ(r["verdict"], "not_described");
  const auto& e = r["channels_estimation"]["force_N"];
  EXPECT_EQ(e["after"]["rmse"], e["before"]["rmse"]);
}

TEST_F(TamperedBench, AForceInAnotherUnitIsNamed) {
  const auto r = Run("unit_force", [](std::vector<Row>* rows) {
    for (Row& row : *rows) row.force *= 1e-3;
  });
  EXPECT_EQ(r["verdict"], "not_described");
  EXPECT_TRUE(Says(r["reasons"], "another unit: force_N")) << r["reasons"];
  EXPECT_TRUE(Says(r["reasons"], "kN? factors: {force_N: 1000}")) << r["reasons"];
}

// Every number took a share of it, and the declared model sufficed.
TEST_F(TamperedBench, AForceInKilogramsIsNoPartATenthAsStrong) {
  const auto r = Run("unit_kgf", [](std::vector<Row>* rows) {
    for (Row& row : *rows) row.force /= 9.80665;
  });
  EXPECT_EQ(r["verdict"], "not_described");
  EXPECT_TRUE(Says(r["reasons"], "as if force_N read 0.102 times its size (in kgf?)"))
      << r["reasons"];
}

// The spring's force was a small difference of large numbers, and the fit crept along its valley.
TEST_F(TamperedBench, AZeroFarFromTheMotionIsTakenOut) {
  const auto r = Run("far_zero", [](std::vector<Row>* rows) {
    for (Row& row : *rows) row.x += 2;
  });
  EXPECT_TRUE(Says(r["data_findings"], "m from zero: positions count from there"))
      << r["data_findings"];
  EXPECT_LT(r["channels"]["force_N"]["after"]["rmse"].get<double>(), 0.45);
}

TEST(SwallowedUnit, IsToldByTheNumbersThatItDrives) {
  const auto numbers = [](double force, double position) {  // read so many times too large
    const double stiff = force / position;
    return std::vector<FittedNumber>{{"element.mass_kg", 4, 4.1 * stiff},
                                     {"element.stiffness_N_per_m", 3000, 2900 * stiff},
                                     {"friction.coulomb_N", 15, 15 * force},
                                     {"friction.viscous_Ns_per_m", 60, 63 * stiff},
                                     {"friction.exponent", 1, 1}};
  };
  EXPECT_EQ(FindSwallowedUnit(numbers(1, 1)), std::nullopt);
  EXPECT_EQ(FindSwallowedUnit(numbers(0.45, 1)), std::nullopt);  // no unit
  const auto pounds = FindSwallowedUnit(numbers(1 / 4.4482216, 1));
  ASSERT_TRUE(pounds);
  EXPECT_THAT(*pounds, testing::HasSubstr("force_N read 0.2248 times its size (in lbf?)"));
  // Centimetres that were taken for millimetres: forces at rest stay as they are.
  const auto centimetres = FindSwallowedUnit(numbers(1, 0.1));
  ASSERT_TRUE(centimetres);
  EXPECT_THAT(*centimetres, testing::HasSubstr("x_m read 0.1 times its size (factors: {x_m: 10})"));
  // A part that is weaker in one way than another is no unit; nor are three numbers enough.
  auto uneven = numbers(1 / 4.4482216, 1);
  uneven[1].fitted *= 4;
  EXPECT_EQ(FindSwallowedUnit(uneven), std::nullopt);
  auto few = numbers(1 / 4.4482216, 1);
  few.erase(few.begin() + 1);
  EXPECT_EQ(FindSwallowedUnit(few), std::nullopt);
  // The measured seal that ships, fitted from a textbook's numbers: three happen to look like
  // centimetres.
  EXPECT_EQ(FindSwallowedUnit({{"friction.coulomb_N", 5, 3.175},
                               {"friction.viscous_Ns_per_m", 50, 7.446},
                               {"friction.stiffness_N_per_m", 5e4, 5633}}),
            std::nullopt);
}

TEST_F(TamperedBench, AMotionInMillimetresIsMendedAndSaid) {
  const auto r = Run("unit_motion", [](std::vector<Row>* rows) {
    for (Row& row : *rows) row.x *= 1e3;
  });
  EXPECT_TRUE(Says(r["data_findings"], "taken in units of 0.001 m")) << r["data_findings"];
  EXPECT_LT(r["channels"]["force_N"]["after"]["rmse"].get<double>(), 0.45);
}

/// A third of the record at the ends of the amplifier: left out, and what is left fits.
TEST_F(TamperedBench, AClippedForceIsNamedAndLeftOut) {
  const auto r = Run("clipped", [](std::vector<Row>* rows) {
    for (Row& row : *rows) row.force = std::clamp(row.force, -32.5, 32.5);
  });
  EXPECT_TRUE(Says(r["data_findings"], "saturated at -32.5 and 32.5")) << r["data_findings"];
  EXPECT_LT(r["channels"]["force_N"]["after"]["rmse"].get<double>(), 0.46);
}

TEST_F(TamperedBench, SpikesOfForceAndMotionAreLeftOut) {
  const auto r = Run("spikes", [](std::vector<Row>* rows) {
    for (size_t i = 40; i < rows->size(); i += 190) (*rows)[i].force += i % 380 < 190 ? 60 : -45;
    for (size_t i = 115; i < rows->size(); i += 430) (*rows)[i].x += 4e-3;
  });
  EXPECT_TRUE(Says(r["data_findings"], "21 spikes")) << r["data_findings"];
  EXPECT_TRUE(Says(r["data_findings"], "10 spikes")) << r["data_findings"];
  EXPECT_LT(r["channels"]["force_N"]["after"]["rmse"].get<double>(), 0.45);
}

TEST_F(TamperedBench, AClockThatJittersIsNamed) {
  const auto r = BenchRecord(
                     "jitter", 61, [](const Sample&) { return 0.0; }, nullptr, 2e-3)
                     .Identified();
  EXPECT_TRUE(Names(r).empty()) << r["effects"].dump(1);
  EXPECT_TRUE(Says(r["data_findings"], "clock is not uniform")) << r["data_findings"];
}

TEST(ElementIdentify, PoorDataEndWithAWord) {
  const BenchRecord record("poor", 51, [](const Sample&) { return 0.0; });
  auto manifest = LoadManifest((record.folder() / "manifest.yaml").string()).value();
  std::ofstream flat(record.folder() / "flat.csv");
  flat << "t_s,x_m,force_N\n";
  for (int i = 0; i < 3000; ++i) flat << 0.01 * i << ",0.002," << 5 + (i % 7) * 0.1 << "\n";
  flat.close();
  manifest.runs[0].data = (record.folder() / "flat.csv").string();
  manifest.runs[0].estimation = {0, 20}, manifest.runs[0].validation = {20, 30};
  const auto data = ReadElementData(manifest);
  ASSERT_FALSE(data.ok());
  EXPECT_NE(data.error().Line().find("does not move"), std::string::npos) << data.error().Line();
}

/// The measured O-ring (models/rigs/seal_friction, CC0): the declared friction knows speed only.
TEST(ElementIdentify, SealNeedsPressureInForceAndFriction) {
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  const auto path = FindData("manifest", "models/rigs", "seal_friction", {".yaml"});
  ASSERT_TRUE(path.ok());
  const auto manifest = LoadManifest(path.value());
  ASSERT_TRUE(manifest.ok()) << manifest.error().Line();
  const fs::path out = fs::temp_directory_path() / "phs_seal_out";
  auto dir = ResultDir::Create(out.string(), true);
  ASSERT_TRUE(dir.ok());
  const auto outcome = RunElementIdentify(manifest.value(), {}, nullptr, dir.value());
  ASSERT_TRUE(outcome.ok()) << outcome.error().Line();
  const auto& r = outcome.value().result;
  const std::vector<std::string> names = Names(r);
  ASSERT_GE(names.size(), 2u) << r["effects"].dump(1);
  EXPECT_EQ(names[0], "pressure_area");
  double slope = 0, area = 0;
  for (const auto& e : r["effects"]) {
    if (e["name"] == "pressure_friction") slope = e["parameters"]["bore_N_per_Pa"]["value"];
    if (e["name"] == "pressure_area") area = e["parameters"]["area_m2"]["value"];
  }
  // 3 %: a formula of second order in pressure, found beside it, takes 0.8 % back at 5 bar.
  EXPECT_NEAR(area, M_PI / 4 * 0.025 * 0.025, 0.15e-4) << "a 25 mm piston";
  // Half the jump between the directions less the area's share: 3.9 N at 1 bar, 7.8 N at 7 bar.
  EXPECT_NEAR(slope, 6.5e-6, 1.5e-6);
}

/// EMPS (Janot, Gautier, Brunot 2019; not shipped): published inverse-model errors 3.112 % on the
/// training record with asymmetric friction, 5.982 % on the test record.
TEST(ElementIdentify, EmpsIsAsymmetricAndAtOrBelowThePublishedErrors) {
  if (std::getenv("PHS_EMPS_DIR") == nullptr) GTEST_SKIP() << "PHS_EMPS_DIR is not set";
  const auto path = FindData("manifest", "models/rigs", "emps", {".yaml"});
  ASSERT_TRUE(path.ok());
  const auto manifest = LoadManifest(path.value());
  ASSERT_TRUE(manifest.ok()) << manifest.error().Line();
  auto dir = ResultDir::Create((fs::temp_directory_path() / "phs_emps_out").string(), true);
  ASSERT_TRUE(dir.ok());
  const auto outcome = RunElementIdentify(manifest.value(), {}, nullptr, dir.value());
  ASSERT_TRUE(outcome.ok()) << outcome.error().Line();
  const auto& r = outcome.value().result;
  bool asymmetric = false;
  for (const auto& e : r["effects"]) {
    if (e["name"] != "asymmetric_friction") continue;
    asymmetric = true;
    EXPECT_NEAR(e["parameters"]["viscous_Ns_per_m"]["value"].get<double>(), 166.7 - 240.4, 12);
  }
  EXPECT_TRUE(asymmetric) << r["effects"].dump(1);
  EXPECT_LE(r["channels_estimation"]["force_N"]["after"]["relative_percent"].get<double>(), 3.112);
  EXPECT_LE(r["channels"]["force_N"]["after"]["relative_percent"].get<double>(), 5.98);
  EXPECT_NEAR(r["channels_estimation"]["force_N"]["before"]["relative_percent"].get<double>(),
              4.083, 0.35);
}

}  // namespace
}  // namespace phs::identify::element
