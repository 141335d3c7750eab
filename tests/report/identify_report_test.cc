#include "report/identify_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/result_dir.h"
#include "example_results.h"
#include "holds.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using ::testing::HasSubstr;
using testing::Holds;
using testing::Lacks;

class IdentifyReport : public ::testing::Test {
 protected:
  std::string File(const std::string& name) const { return directory_.File(name); }
  void WriteResult(const std::string& text) { std::ofstream(File("result.json")) << text; }
  std::string Html(const IdentifyReportInput& input) {
    const Status status = WriteIdentifyReport(input, File("report.html"));
    EXPECT_TRUE(status.ok()) << status.error().Line();
    return ReadFile(File("report.html")).value();
  }
  ScratchDir directory_;
};

TEST_F(IdentifyReport, ShowsEffectIntervalsErrorsAndDoubt) {
  testing::WriteExampleIdentification(directory_.path());
  const std::string html = Html({.result = File("result.json"),
                                 .measured = File("measured.csv"),
                                 .predicted = File("predicted.csv"),
                                 .baseline = File("baseline.csv")});
  EXPECT_TRUE(Holds(html, "The declared model lacks backlash."));
  EXPECT_TRUE(Holds(html, "backlash cannot be told from mount compliance"));
  EXPECT_TRUE(Holds(html, "gap [mm]</th><td class=\"strong\">0.1210</td><td>0.117 … 0.125"));
  EXPECT_TRUE(Holds(html, "<td>0.412</td><td class=\"strong\">0.0210</td>"));  // RMSE [kN]
  EXPECT_TRUE(Holds(html, "weaker than backlash"));
  EXPECT_TRUE(Holds(html, "Residual (measured − predicted): load cell force"));
  EXPECT_TRUE(Holds(html, "Mean residual of load cell force, corrected"));
  EXPECT_LT(html.size(), 6u << 20);
}

TEST_F(IdentifyReport, NothingFoundIsSaidPlainly) {
  WriteResult(R"({"rig":"quarter","channels":{"load_cell_N":{"before":{"nrmse":0.01},
    "after":{"nrmse":0.01}}},"effects":[],"candidates":[]})");
  const std::string html = Html({.result = File("result.json")});
  EXPECT_TRUE(Holds(html, "No missing effect is supported by the data"));
  EXPECT_TRUE(Holds(html, "No effect was accepted"));
  EXPECT_TRUE(Lacks(html, "Found."));
}

TEST_F(IdentifyReport, AnEffectOnNoListStandsWithItsFormulaAndPlace) {
  WriteResult(R"json({"rig":"quarter","channels":{"load_cell_N":{"before":{"nrmse":0.02},
    "after":{"nrmse":0.01}}},"effects":[{"name":"unlisted","on":["L2"],
    "formula":"c1*(max(p-7.5e+06[Pa],0[Pa])/1e+07[Pa])",
    "parameters":{"c1_m3_per_s":{"value":1.5e-7,"low":1.4e-7,"high":1.6e-7}},
    "evidence":{"delta_bic":123.0}}],"candidates":[]})json");
  const std::string html = Html({.result = File("result.json")});
  EXPECT_TRUE(Holds(html,
                    "The declared model lacks a flow on no list on L2, "
                    "c1*(max(p-7.5e+06[Pa],0[Pa])/1e+07[Pa])."));
  EXPECT_TRUE(Holds(html, ">delta bic<")) << "evidence has a table of its own";
}

TEST_F(IdentifyReport, AFormulaSaysWhatItStandsFor) {
  for (const auto& [number, words] : std::vector<std::pair<std::string, std::string>>{
           {"c1_N", "a force on no list"},
           {"c1_m3", "a volume on no list"},
           {"c1_m", "an error of the piston reading on no list"},
           {"c1_Pa", "an error of the pressure reading on no list"}}) {
    WriteResult(R"({"rig":"quarter","channels":{"load_cell_N":{"before":{"nrmse":0.02},
      "after":{"nrmse":0.01}}},"candidates":[],"effects":[{"name":"unlisted","formula":"c1*x",
      "parameters":{")" +
                number + R"(":{"value":1}}}]})");
    const std::string html = Html({.result = File("result.json")});
    EXPECT_TRUE(Holds(html, "The declared model lacks " + words)) << number;
  }
}

TEST_F(IdentifyReport, ARigRunHasOneModel) {
  WriteResult(R"({"rig":"element","channels":{"force_N":{"rmse":12.5,"nrmse":0.034}}})");
  std::ofstream(File("m.csv")) << "t_s,x_m,force_N\n0,0,1\n0.1,0.01,2\n0.2,0.02,4\n";
  std::ofstream(File("p.csv")) << "t_s,x_m,force_N\n0,0,1.5\n0.2,0.02,3.5\n";
  const std::string html =
      Html({.result = File("result.json"), .measured = File("m.csv"), .predicted = File("p.csv")});
  EXPECT_TRUE(Holds(html, "Rig against model"));
  EXPECT_TRUE(Holds(html, "<td>0.0125</td>"));
  EXPECT_TRUE(Holds(html, "force over displacement: measured and model"));
  EXPECT_TRUE(Lacks(html, "declared, fitted"));
}

TEST_F(IdentifyReport, BadInputIsNamed) {
  WriteResult("[1, 2]");
  const Status status = WriteIdentifyReport({.result = File("result.json")}, File("report.html"));
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().Line(), HasSubstr("result.json"));
  EXPECT_FALSE(WriteIdentifyReport({.result = File("none.json")}, File("report.html")).ok());
  WriteResult("{}");
  EXPECT_FALSE(WriteIdentifyReport({.result = File("result.json"),
                                    .measured = File("none.csv"),
                                    .predicted = File("none.csv")},
                                   File("report.html"))
                   .ok());
}

}  // namespace
}  // namespace phs::report
