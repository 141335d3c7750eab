#include "report/curving_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/result_dir.h"
#include "example_results.h"
#include "holds.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using testing::ExampleOptions;
using ::testing::HasSubstr;
using testing::Holds;
using testing::Lacks;
namespace fs = std::filesystem;

class CurvingReport : public ::testing::Test {
 protected:
  std::string Make(ExampleOptions options) {
    options.interval_m = std::max(options.interval_m, 0.5);
    testing::WriteExampleResults(directory_.path(), options);
    return Remake();
  }
  std::string Remake() {
    const std::string path = directory_.File("report.html");
    const Status status = WriteCurvingReport(directory_.path(), path);
    EXPECT_TRUE(status.ok()) << status.error().Line();
    return ReadFile(path).value();
  }
  ScratchDir directory_;
};

TEST_F(CurvingReport, ShowsTheNumbersOfTheResult) {
  const std::string html = Make({});
  // Of the example at s = 430 m: 0.3, 1 and 0.6 times a/R, a = 1.55 m, and 0.2 mrad each.
  EXPECT_TRUE(
      Holds(html, "<td class=\"strong\">1.04 outer</td><td>3.01 outer</td><td>1.89 outer</td>"));
  EXPECT_TRUE(Holds(html, "R = 550 m to the left"));
  EXPECT_TRUE(Holds(html, "rigid link / PHS"));
  // A diagonal line of the example begins at 1.8 MPa and falls by 8 kPa in the curve.
  EXPECT_TRUE(Holds(html, "line L2 [MPa absolute]</th><td>1.80</td><td>1.79</td><td>1.79 at "));
}

TEST_F(CurvingReport, ATrackCannotBringAScript) {
  (void)Make({});
  const std::string path = directory_.File("compare.json");
  auto json = nlohmann::ordered_json::parse(ReadFile(path).value());
  json["track"]["name"] = "</script><img src=x onerror=bad()>";
  ASSERT_TRUE(WriteFileAtomically(path, json.dump()).ok());
  const std::string html = Remake();
  EXPECT_TRUE(Lacks(html, "<img"));
  EXPECT_TRUE(Holds(html, "onerror=bad()"));
}

TEST_F(CurvingReport, SaysWhatTheStepChangesAndWhichLimitsWereTouched) {
  EXPECT_TRUE(Lacks(Make({}), "What the step changes"));
  const std::string path = directory_.File("compare.json");
  auto all = nlohmann::ordered_json::parse(ReadFile(path).value());
  auto& phs = all["bogies"]["phs"];
  phs["warnings"] = {{{"name", "low_pressure_L2"}, {"text", "line L2 is nearly empty"}}};
  phs["run"]["energy_error_relative"] = 4e-3;
  const auto change = [](double value, double half, double of_scale) {
    return nlohmann::ordered_json{{"value", value},
                                  {"half_step", half},
                                  {"relative", value / half - 1},
                                  {"of_scale", of_scale}};
  };
  phs["discretisation"] = {{"timestep_s", 1e-3},
                           {"half_step_s", 5e-4},
                           {"changes",
                            {{"run.T_gamma_total_J", change(5300, 5000, 0)},
                             {"steady_curve.lines.L1.pressure_Pa", change(2e6, 2e6, 0)},
                             {"steady_curve.bending_rad", change(3e-4, 1e-4, 0.045)}}},
                           {"moving", {"run.T_gamma_total_J", "steady_curve.bending_rad"}}};
  phs["discretisation"]["changes"]["run.T_gamma_total_J"]["of_scale"] = nullptr;
  std::ofstream(path) << all.dump(2);
  const std::string html = Remake();
  EXPECT_TRUE(Holds(html, "PHS: line L2 is nearly empty."));
  EXPECT_TRUE(Holds(html, "PHS: 0.40 % of the energy is missing"));
  EXPECT_TRUE(Holds(html, "PHS: 2 of its numbers move by more than 2 %"));
  EXPECT_TRUE(Holds(html, "What the step changes"));
  EXPECT_TRUE(Holds(html, "<td class=\"strong\">6.0</td><td>its own size</td>"));
  EXPECT_TRUE(Holds(html, "<td class=\"strong\">4.5</td><td>largest magnitude in the run</td>"));
  EXPECT_TRUE(Lacks(html, "Line pressure, line L1"));
  // Names and units of the other tables, no keys of the file.
  EXPECT_TRUE(Holds(html,
                    "<th scope=\"row\">Work lost as Tγ along the track [kJ]</th>"
                    "<td>5.30</td><td>5.00</td>"));
  EXPECT_TRUE(Holds(html, "Bending (steering) of the bogie [mrad]</th><td>0.300</td>"));
  EXPECT_TRUE(Lacks(html, "T_gamma_total_J</th>"));
}

TEST_F(CurvingReport, SaysHowTheCurveLiesAndWhichWheelCarriesMost) {
  (void)Make({});
  const std::string path = directory_.File("compare.json");
  auto all = nlohmann::ordered_json::parse(ReadFile(path).value());
  all["track"]["centre_line"]["s_m"] = {0.0, 430.0};
  all["track"]["centre_line"]["cant_rad"] = {0.0, 0.0527};
  auto& steady = all["bogies"]["phs"]["steady_curve"];
  steady["speed_m_s"] = 80 / 3.6;
  const auto wheel = [](const char* name, double y, double ratio, double slope, double flange) {
    return nlohmann::ordered_json{{"name", name},
                                  {"Y_N", y},
                                  {"Y_over_Q", ratio},
                                  {"contact_angle_rad", slope},
                                  {"flange_N", flange}};
  };
  steady["wheels"] = {wheel("lead_outer", 6e3, 0.04, 0.14, 0),
                      wheel("lead_inner", -7e3, -0.07, 0.01, 0),
                      wheel("trail_outer", 8.58e3, 0.057, 0.1, 0)};
  all["scenario"] = {{"wheel", "S1002"}, {"rail", "UIC60"}, {"friction", 0.35}};
  const auto axle = [](const char* name, double yaw, double attack) {
    return nlohmann::ordered_json{
        {"name", name}, {"yaw_rad", yaw}, {"angle_of_attack_rad", attack}};
  };
  steady["wheelsets"] = {axle("lead", 2.8e-3, 5.5e-5), axle("trail", -2.59e-3, 2.91e-4)};
  ASSERT_TRUE(WriteFileAtomically(path, all.dump()).ok());
  // 80 km/h: v²/R cos - g sin = 0.8966 - 0.5167 m/s2; balance sqrt(g R tan) = 16.87 m/s.
  std::string html = Remake();
  EXPECT_TRUE(Holds(html,
                    "Left curve of R = 550 m, canted by 52.7 mrad; it balances 60.7 km/h. At "
                    "80.0 km/h 0.380 m/s² are left towards the outer rail."));
  // Angles of attack differ by -0.236 mrad: 3.1 m/550 m less what the axles turn.
  EXPECT_TRUE(Holds(
      html, "The axles stand 5.39 mrad to each other; radial they would stand 5.63 (95.8 %)"));
  EXPECT_TRUE(Holds(html, "Wheels S1002 on rails UIC60, friction 0.35."));
  EXPECT_TRUE(Holds(html, "Passive hydraulic steering: four cylinders"));
  EXPECT_TRUE(Holds(html,
                    "largest guiding force is 8.58 kN (trailing outer wheel), the largest Y/Q "
                    "0.0700 (leading inner wheel)"));
  EXPECT_TRUE(Holds(html, "steepest contact has 8.02° (leading outer wheel); no flange carries"));
  steady["speed_m_s"] = 10;
  steady["wheels"][0]["flange_N"] = 12e3;
  ASSERT_TRUE(WriteFileAtomically(path, all.dump()).ok());
  html = Remake();
  EXPECT_TRUE(Holds(html, "towards the inner rail"));
  EXPECT_TRUE(Holds(html, "a flange or its root carries 12.0 kN (leading outer wheel)"));
}

/// The energy table closes: kinetic energy as a change, like all else.
TEST_F(CurvingReport, KineticEnergyIsAChange) {
  EXPECT_TRUE(Holds(Make({}), "Gained in kinetic energy"));
}

TEST_F(CurvingReport, SaysWhatSteersAndWhatHoldsBack) {
  const std::string html = Make({});
  EXPECT_TRUE(Holds(html, "it is turned by the creep forces between wheel and rail (7.47 kN m)"));
  EXPECT_TRUE(Holds(html,
                    "held back by the oil pressure in the cylinders (0.897 kN m), the seal "
                    "friction of the cylinders (1.90 kN m) and the primary suspension"));
}

TEST_F(CurvingReport, SharesAreSignedAndAddUpToZero) {
  const std::string html = Make({});
  // Of the example: friction -1.9, pressure -0.12 of the creep forces' 7.47 kN m, the rest primary.
  EXPECT_TRUE(Holds(html,
                    "creep forces +100 %, oil pressure −12 %, seal friction −25 %, primary "
                    "suspension with its links −63 %."));
  EXPECT_TRUE(Holds(html, "Seal friction holds back (−25 %)"));
  EXPECT_TRUE(Holds(html, "Seal friction may hold back or steer."));
  EXPECT_TRUE(Holds(html, "Of a link bogie it is nearly all the links"));
}

TEST_F(CurvingReport, ARatioToNothingIsABoundThatIsExplained) {
  (void)Make({.bogies = {"phs", "rigid_link"}});
  const std::string path = directory_.File("compare.json");
  auto all = nlohmann::ordered_json::parse(ReadFile(path).value());
  all["bogies"]["phs"]["steady_curve"]["wheelsets"][0]["angle_of_attack_rad"] = 2e-5;
  all["bogies"]["rigid_link"]["steady_curve"]["wheelsets"][0]["angle_of_attack_rad"] = -4.6e-3;
  ASSERT_TRUE(WriteFileAtomically(path, all.dump()).ok());
  const std::string html = Remake();
  EXPECT_TRUE(Holds(html, "(at least 46 ×: below 0.1 mrad nothing is resolved)"));
  EXPECT_TRUE(Holds(html, "<td>at least 46 ×</td>"));
  EXPECT_TRUE(Holds(html, "that bound stands in its place"));
}

TEST_F(CurvingReport, WearWithAndWithoutSpinStandSideBySide) {
  const std::string html = Make({});
  EXPECT_TRUE(Holds(html, "– the spin part beside it, Σ|Mz φ| [N]"));
  EXPECT_TRUE(Holds(html, "the work lost in creep counts all slip, spin included"));
}

TEST_F(CurvingReport, ShowsNoFolderOfTheMachine) {
  (void)Make({});
  const std::string path = directory_.File("compare.json");
  auto all = nlohmann::ordered_json::parse(ReadFile(path).value());
  all["bogies"]["phs"]["inputs"] = {{"wheel", "/srv/ann/models/profiles/S1002.prw"},
                                    {"bogie", "/srv/ann/my.xml"}};
  ASSERT_TRUE(WriteFileAtomically(path, all.dump()).ok());
  const std::string html = Remake();
  EXPECT_TRUE(Lacks(html, "/srv/ann"));
  EXPECT_TRUE(Holds(html, "models/profiles/S1002.prw"));
}

TEST_F(CurvingReport, SaysThatAConicityWasNotKept) {
  EXPECT_TRUE(Holds(Make({}), "There is no conicity curve: it was not kept with this result"));
}

TEST_F(CurvingReport, LeftAndRightCurvesReadTheSame) {
  const std::string left = Make({.hand = 1});
  const std::string right = Make({.hand = -1});
  for (const char* words :
       {"points 1.04 mrad to the outer rail", "turned by the creep forces between"}) {
    EXPECT_TRUE(Holds(left, words));
    EXPECT_TRUE(Holds(right, words));
  }
  // Table and cards: magnitude and rail, no sign.
  for (const std::string& html : {left, right}) {
    EXPECT_TRUE(Holds(html, ">1.04 outer</td>"));
    EXPECT_TRUE(Holds(html, "mrad to the outer rail"));
    EXPECT_TRUE(Lacks(html, "positive when the axle points"));
  }
  EXPECT_TRUE(Holds(left, "leading right wheel (outer)"));
  EXPECT_TRUE(Holds(right, "leading left wheel (outer)"));
}

TEST_F(CurvingReport, NamesARunThatDerailed) {
  const std::string html = Make({.derailed = true});
  EXPECT_TRUE(Holds(html, "The run of the soft link bogie ended as &#39;derailed&#39;"));
  EXPECT_TRUE(Holds(html, "tip of its flange"));
}

TEST_F(CurvingReport, NamesARunThatNeverCameToTheSteadyCurve) {
  const char* said = "bogie ends before its last axle has come to the steady curve";
  EXPECT_TRUE(Lacks(Make({}), said));
  const std::string path = directory_.File("compare.json");
  auto all = nlohmann::ordered_json::parse(ReadFile(path).value());
  all["bogies"]["phs"]["steady_curve"]["speed_m_s"] = nullptr;
  EXPECT_TRUE(WriteFileAtomically(path, all.dump()).ok());
  EXPECT_TRUE(Holds(Remake(), said));
}

TEST_F(CurvingReport, ASingleRunHasNoRatios) {
  const std::string html = Make({.bogies = {"phs"}, .single = true});
  EXPECT_TRUE(Holds(html, "Angle of attack, leading axle [mrad]"));
  EXPECT_TRUE(Lacks(html, "/ PHS</th>"));
}

TEST_F(CurvingReport, ALocomotiveHasTwoBogies) {
  const std::string html = Make({.bogies = {"phs", "rigid_link"}, .locomotive = true});
  EXPECT_TRUE(Holds(html, "Front bogie"));
  EXPECT_TRUE(Holds(html, "Angle of attack, rear bogie, leading axle"));
  EXPECT_TRUE(Holds(html, "Cylinder forces, rear bogie, PHS"));
  EXPECT_TRUE(Holds(html, "Greatest cylinder force [kN]"));
  // Nothing stops at the front bogie: plan view, bars, words and moments.
  for (const char* bogie : {"front", "rear"}) {
    const std::string name = bogie;
    EXPECT_TRUE(
        Holds(html, name == "front" ? "Front bogie: all angles" : "Rear bogie: all angles"));
    EXPECT_TRUE(Holds(html, "Track-shifting force ΣY, leading axle [kN], " + name + " bogie"));
    EXPECT_TRUE(Holds(html, " at the " + name + " bogie "));
    EXPECT_TRUE(Holds(html, "Yaw moments, " + name + " bogie, leading axle"));
  }
  EXPECT_TRUE(Holds(html, "leading axle of the worse bogie"));
}

TEST_F(CurvingReport, WithoutTimeSeriesTheTablesRemain) {
  const std::string html = Make({.series = false});
  EXPECT_TRUE(Holds(html, "No time series was saved"));
  EXPECT_TRUE(Holds(html, "Wear number Tγ, all wheels of the bogie [N]"));
}

TEST_F(CurvingReport, AMinuteAtAKilohertzStaysBelowSixMegabytes) {
  testing::WriteExampleResults(
      directory_.path(),
      {.bogies = {"phs", "rigid_link"}, .locomotive = true, .interval_m = 0.0167});
  Remake();
  EXPECT_LT(fs::file_size(directory_.File("report.html")), 6u << 20);
}

TEST_F(CurvingReport, TheSameResultGivesTheSameBytes) {
  const std::string once = Make({});
  EXPECT_EQ(once, Remake());
}

TEST_F(CurvingReport, BadInputIsNamed) {
  const std::string place = directory_.path();
  const Status empty = WriteCurvingReport(place, place + "/r.html");
  ASSERT_FALSE(empty.ok());
  EXPECT_THAT(empty.error().Line(), HasSubstr("holds no result of a curving run"));
  std::ofstream(directory_.File("compare.json")) << "{ broken";
  const Status broken = WriteCurvingReport(place, place + "/r.html");
  ASSERT_FALSE(broken.ok());
  EXPECT_THAT(broken.error().Line(), HasSubstr("compare.json"));
  std::ofstream(directory_.File("compare.json")) << "{\"bogies\":{}}";
  EXPECT_FALSE(WriteCurvingReport(place, place + "/r.html").ok());
  EXPECT_FALSE(fs::exists(directory_.File("r.html")));
}

}  // namespace
}  // namespace phs::report
