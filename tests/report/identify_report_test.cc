#include "report/identify_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/result_dir.h"
#include "example_results.h"
#include "holds.h"
#include "report/readable_name.h"
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
  EXPECT_TRUE(Holds(html,
                    "The declared model lacks backlash with gap 0.121 mm (95 %: 0.117 to "
                    "0.125)."));
  EXPECT_TRUE(Holds(html, "backlash cannot be told from mount compliance"));
  EXPECT_TRUE(Holds(html, "gap [mm]</th><td class=\"strong\">0.121</td><td>0.117 … 0.125"));
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
  EXPECT_TRUE(Lacks(html, "The declared model lacks"));
  // What to do next speaks of no effect either.
  EXPECT_TRUE(Holds(html, "the declared model with its fitted numbers"));
  EXPECT_TRUE(Lacks(html, "an effect that is real"));
  EXPECT_TRUE(Lacks(html, "the found effects"));
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
                    "c1*(max(p-7.5e+06[Pa],0[Pa])/1e+07[Pa]) with c1 "));
  EXPECT_TRUE(Holds(html, ">delta bic<")) << "evidence has a table of its own";
}

TEST_F(IdentifyReport, AFormOnNoListStandsWithItsEffect) {
  WriteResult(R"json({"rig":"quarter","channels":{"load_cell_N":{"before":{"nrmse":0.02},
    "after":{"nrmse":0.01}}},"effects":[{"name":"stribeck","parameters":{"extra_N":{"value":300}},
    "form":{"formula":"c1*(v/0.02[m/s])","parameters":{"c1_N":{"value":-41,"low":-45,"high":-37}}},
    "evidence":{"delta_bic":123.0}}],"candidates":[]})json");
  const std::string html = Html({.result = File("result.json")});
  EXPECT_TRUE(
      Holds(html, "The declared model lacks stribeck in a form of its own with extra 0.300 kN"));
  EXPECT_TRUE(Holds(html, "its own form: c1*(v/0.02[m/s])"));
  EXPECT_TRUE(Holds(html, "−0.0450 … −0.0370")) << "its numbers in the table";
}

TEST_F(IdentifyReport, AnAmountHasTheFiguresThatShowItsInterval) {
  WriteResult(R"json({"rig":"quarter","channels":{"load_cell_N":{"before":{"nrmse":0.02},
    "after":{"nrmse":0.01}}},"effects":[{"name":"accumulator_precharge","parameters":{
    "precharge_Pa":{"value":14990000,"low":14982000,"high":14998000}}}],"candidates":[]})json");
  EXPECT_TRUE(Holds(Html({.result = File("result.json")}),
                    "precharge 14.990 MPa (95 %: 14.982 to 14.998)"));
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

/// Place of the first of two words in a page.
bool ComesFirst(const std::string& html, const std::string& first, const std::string& then) {
  return html.find(first) < html.find(then) && html.find(then) != std::string::npos;
}

TEST_F(IdentifyReport, TheVerdictIsReadFirst) {
  testing::WriteExampleIdentification(directory_.path());
  const std::string html = Html({.result = File("result.json"),
                                 .measured = File("measured.csv"),
                                 .predicted = File("predicted.csv"),
                                 .baseline = File("baseline.csv")});
  EXPECT_TRUE(
      Holds(html,
            "<p class=\"verdict tone-1\">Cannot be told from this record: backlash "
            "or another.</p>\n<div class=\"beside\"><div>\n<p><strong>What was missing.</strong>"));
  EXPECT_TRUE(
      Holds(html,
            "<strong>How sure.</strong> This record does not tell backlash from mount "
            "compliance: take the name as one of these; backlash brings ΔBIC 4210 "
            "and 91.0 % less error on the parts of the record left out in turn; the "
            "worst channel, load cell force, is left with 1.17 times its noise and uncertainty."));
  EXPECT_TRUE(Holds(html,
                    "the error of the load cell force goes from 3.10 % to 0.160 % of its "
                    "standard deviation (0.412 to 0.0210 kN); of 2 channels 2 get better and "
                    "0 worse by more than 5 %."));
  EXPECT_TRUE(Holds(html,
                    "<strong>Next.</strong> Backlash against mount_compliance: small slow "
                    "reversals about zero force with the piston locked."));
  EXPECT_TRUE(Holds(html, "<li>Backlash explains no more than mount_compliance</li>"));
  EXPECT_TRUE(Holds(html, "2 findings in the record:"));
  EXPECT_TRUE(Holds(html, "measured − predicted [kN]"));
  EXPECT_TRUE(Holds(html, "<li>clock: 3 gaps of 0.1 s</li>"));
  EXPECT_TRUE(Holds(html,
                    "What each model leaves of the load cell force, where the declared model "
                    "errs most: "));
  EXPECT_TRUE(Holds(html, "Error on the validation window, of the standard deviation [%]"));
  // Both pictures and the words stand before the first table.
  EXPECT_TRUE(ComesFirst(html, "errs most", "<h2>Errors</h2>"));
  EXPECT_TRUE(ComesFirst(html, "class=\"verdict", "<table"));
}

TEST_F(IdentifyReport, EveryVerdictHasItsWords) {
  const auto with = [&](const std::string& verdict, const std::string& effects) {
    WriteResult(R"({"rig":"element","verdict":")" + verdict +
                R"(","verdict_text":"the declared model suffices","reasons":["why <b>"],
        "channels":{"force_N":{"before":{"nrmse":0.2},"after":{"nrmse":0.1}}},"effects":[)" +
                effects + R"(],"data_findings":[],"candidates":[{"name":"a"},{"name":"b"}],
        "unexplained":{"channel":"force_N","residual_over_noise":9.5}})");
    return Html({.result = File("result.json")});
  };
  const std::string enough = with("sufficient", "");
  EXPECT_TRUE(Holds(enough, "tone-0\">The declared model suffices.</p>"));
  EXPECT_TRUE(Holds(
      enough, "The worst channel, force, is left with 9.50 times its noise and uncertainty."));
  EXPECT_TRUE(Holds(enough, "nothing was added to the model"));
  EXPECT_TRUE(Holds(enough, "Nothing to mend"));
  EXPECT_TRUE(Holds(enough, "<li>why &lt;b&gt;</li>"));
  const std::string none = with("not_described", "");
  EXPECT_TRUE(Holds(none, "tone-2\">Not described by this model.</p>"));
  EXPECT_TRUE(Holds(none, "nor any of the 2 candidates describes"));
  EXPECT_TRUE(Holds(none, "<strong>Next.</strong> Mend what the reasons name"));
  EXPECT_TRUE(Lacks(none, "Put model.yaml into the bogie"));
  const std::string some = with("not_described", R"({"name":"stribeck"})");
  EXPECT_TRUE(
      Holds(some,
            "The declared model lacks stribeck, but that is not enough, or the data contradict "
            "themselves: the reasons stand below."));
  const std::string found = with("explained", R"({"name":"stribeck"},{"name":"backlash"})");
  EXPECT_TRUE(Holds(found, "tone-0\">Explained by stribeck and backlash.</p>"));
}

TEST_F(IdentifyReport, StepsAreToldByTheStepsLeftOut) {
  WriteResult(R"({"rig":"steps","declared":"quarter_setup2","effects":[{"name":"gas_thermal",
    "run":"quarter_setup3","parameters":{"thermal_time_s":{"value":4.1,"low":3.0,"high":5.2}},
    "evidence":{"error_begin_before":0.13,"error_begin_after":0.02}}],
    "channels":{"p_end_Pa":{"before":{"m_re_percent":20.3},"after":{"m_re_percent":14.4}},
      "p_begin_Pa":{"before":{"m_re_percent":13.0},"after":{"m_re_percent":2.0}}}})");
  const std::string head =
      "row,chamber,setup,step_actuator_mm,step_piston_mm,p_begin_MPa,p_end_MPa,tau_s\n";
  for (const char* name : {"m.csv", "b.csv", "p.csv"}) {
    std::ofstream(File(name)) << head << "1,1,2,1,0.9,2,1.9,1\n2,2,2,2,1.8,3,2.8,1\n";
  }
  const std::string html = Html({.result = File("result.json"),
                                 .measured = File("m.csv"),
                                 .predicted = File("p.csv"),
                                 .baseline = File("b.csv")});
  EXPECT_TRUE(Holds(html, "Needed: gas thermal.</p>"));
  EXPECT_TRUE(Holds(html,
                    "gas thermal in quarter_setup3 with thermal time 4.10 s (95 %: 3.00 to "
                    "5.20)."));
  EXPECT_TRUE(
      Holds(html,
            "Gas thermal in quarter_setup3 brings the pressures just after the step within "
            "2.00 % in place of 13.0 %; every step was left out of the fit that foretells it."));
  EXPECT_TRUE(Holds(html,
                    "goes from 20.3 % to 14.4 % (settled pressure) and from 13.0 % to 2.00 % "
                    "(pressure just after the step)."));
  EXPECT_TRUE(Holds(html, "Settled pressures of the steps: predicted"));
  EXPECT_TRUE(Holds(html, "Mean relative error, each step left out of its fit [%]"));
}

TEST_F(IdentifyReport, ShortenedListsSayHowMuchTheyLeaveOut) {
  // One that holds noise alone is 100 % wrong before and after; it does not stand in front.
  std::string channels = R"("quiet_Pa":{"before":{"nrmse":1.0},"after":{"nrmse":1.0}},)";
  for (int i = 0; i < 12; ++i) {
    channels += (i == 0 ? "" : ",") + ("\"p" + std::to_string(i)) +
                "_Pa\":{\"before\":{\"nrmse\":0.0" + std::to_string(10 + i) +
                "},\"after\":{\"nrmse\":0.01}}";
  }
  WriteResult(R"({"rig":"bogie","verdict":"explained","channels":{)" + channels +
              R"(},"effects":[{"name":"x","parameters":{"a_m":{"value":1},"b_m":{"value":2},
                 "c_m":{"value":3}}}]})");
  const std::string html = Html({.result = File("result.json")});
  EXPECT_TRUE(Holds(html, "(8 of 13 channels, most changed first; the others under Errors)"));
  const std::string bar = R"(<th class="category" colspan="3">)";
  EXPECT_FALSE(Holds(html, bar + Readable("quiet_Pa").words));
  const size_t most = html.find(bar + Readable("p11_Pa").words);
  const size_t less = html.find(bar + Readable("p10_Pa").words);
  ASSERT_NE(less, std::string::npos);
  EXPECT_LT(most, less);
  EXPECT_TRUE(Holds(html, "x with 3 numbers (table of effects)"));
}

TEST_F(IdentifyReport, WhatAFormHoldsIsSaid) {
  WriteResult(R"({"rig":"quarter","verdict":"explained",
      "channels":{"a_N":{"before":{"nrmse":0.2},"after":{"nrmse":0.1}}},"effects":[
      {"name":"piston_leakage","parameters":{"conductance_m3_per_Pas":{"value":1e-16}},
       "held":{"return_ratio":50}}]})");
  const std::string html = Html({.result = File("result.json")});
  EXPECT_TRUE(Holds(html, "return ratio 50.0 (held by its form)"));
  EXPECT_TRUE(Holds(html, ">held by its form</td>"));
}

TEST_F(IdentifyReport, ResultsOfAnotherFormAreToldNotThrown) {
  WriteResult(R"({"rig":3,"channels":{"a_N":{"before":{},"after":{}}},"effects":[1]})");
  const Status status = WriteIdentifyReport({.result = File("result.json")}, File("report.html"));
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().Line(), HasSubstr("has another form than a result"));
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
