#include "report/analysis_report.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/result_dir.h"
#include "holds.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using testing::Holds;

class AnalysisReport : public ::testing::Test {
 protected:
  std::string File(const std::string& name) const { return directory_.File(name); }
  ScratchDir directory_;
};

TEST_F(AnalysisReport, ModesOfTwoBogies) {
  std::ofstream(File("a.json")) << R"({"bogie":"phs","bending":{"stiffness_Nm_per_rad":12340,
      "small_amplitude":{"stiffness_Nm_per_rad":900000}},"traction":{"stiffness_N_per_m":5.5e7}})";
  std::ofstream(File("b.json"))
      << R"({"bogie":"rigid_link","bending":{"stiffness_Nm_per_rad":4.2e6}})";
  const Status status = WriteModesReport({File("a.json"), File("b.json")}, File("r.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("r.html")).value();
  EXPECT_TRUE(Holds(html, "<td>12.3</td><td>4200</td>"));
  EXPECT_TRUE(Holds(html, "<td>900</td><td>–</td>"));
  EXPECT_TRUE(Holds(html, "<td>55000</td><td>–</td>"));
  EXPECT_FALSE(WriteModesReport({File("none.json")}, File("r.html")).ok());
}

TEST_F(AnalysisReport, StabilityOverSpeed) {
  std::ofstream(File("s.json")) << R"({"critical_speed_m_s":50,"eigenvalues":[
      {"speed_m_s":40,"real_1_s":-0.5,"imag_rad_s":10},{"speed_m_s":60,"real_1_s":0.2,"imag_rad_s":14}]})";
  const Status status = WriteStabilityReport(File("s.json"), File("r.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("r.html")).value();
  EXPECT_TRUE(Holds(html, "<b>180</b>"));
  EXPECT_TRUE(Holds(html, "Least damping ratio"));
}

}  // namespace
}  // namespace phs::report
