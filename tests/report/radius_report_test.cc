#include "report/radius_report.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/result_dir.h"
#include "conicity_pair.h"
#include "holds.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using testing::Holds;

const char kBogies[] = R"({"scenario": {"wheel": "S1002", "rail": "UIC60", "friction": 0.35},
 "rows": [
  {"radius_m": 300, "hand": "left", "speed_m_s": 15, "bogie": "rigid_link", "yardstick": "rigid_link", "status": "ok",
   "reason": "", "angle_of_attack_lead_rad": -0.0089, "angle_of_attack_trail_rad": 0.0006,
   "T_gamma_N": 1331, "T_gamma_total_J": 348000, "sum_Y_lead_N": 19000, "max_sum_Y_N": 40000,
   "max_Y_over_Q": 1.4, "wear_yardstick_over_own_run": 1},
  {"radius_m": 300, "speed_m_s": 15, "bogie": "phs", "yardstick": "rigid_link", "status": "derailed",
   "reason": "a wheel runs on the tip of its flange"}],
 "critical_speeds": {"rigid_link": {"linear_m_s": 69.5, "nonlinear_m_s": 54},
  "phs": {"linear_m_s": null, "nonlinear_m_s": 16}}})";

TEST(RadiusReport, ShowsRunsCurvesAndWhatDerailed) {
  const std::string in = ScratchFile("bogies.json");
  const std::string out = ScratchFile("bogies.html");
  std::ofstream(in) << kBogies;
  const Status status = WriteRadiusReport(in, out);
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(out).value();
  EXPECT_TRUE(Holds(html, "R = 300 m, 54 km/h"));
  EXPECT_TRUE(Holds(html, "<td>8.90 outer</td>"));
  EXPECT_TRUE(Holds(html, "<td>0.600 inner</td>"));
  EXPECT_TRUE(Holds(html, "derailed: a wheel runs on the tip of its flange"));
  EXPECT_TRUE(Holds(html, "Critical speed on straight track"));
  EXPECT_TRUE(Holds(html, "Non-linear: the lowest speed"));
  EXPECT_TRUE(Holds(html, "There is no conicity curve: it was not kept with this result"));
  std::ofstream(in) << "{}";
  EXPECT_FALSE(WriteRadiusReport(in, out).ok());
}

TEST(RadiusReport, EveryBogieHasItsConicity) {
  nlohmann::ordered_json all = nlohmann::ordered_json::parse(kBogies);
  all["conicity"] = {{"rigid_link", testing::Pair(1.435, {0.11, 0.12, 0.13, 0.14, 0.1812, 0.19})},
                     {"phs", {{"missing", "its wheels are cones"}}}};
  const std::string in = ScratchFile("bogies.json");
  const std::string out = ScratchFile("bogies.html");
  std::ofstream(in) << all.dump();
  const Status status = WriteRadiusReport(in, out);
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(out).value();
  EXPECT_TRUE(Holds(html, "<th scope=\"row\">3</th><td class=\"strong\">0.181</td>"));
  EXPECT_TRUE(Holds(html, "There is no conicity curve of PHS: its wheels are cones."));
}

}  // namespace
}  // namespace phs::report
