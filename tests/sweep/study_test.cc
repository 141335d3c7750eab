#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/json_path.h"
#include "base/result_dir.h"
#include "sweep/case_files.h"
#include "sweep/outputs.h"
#include "sweep/study_file.h"
#include "tests/base/scratch_dir.h"

namespace phs::sweep {
namespace {

using testing::HasSubstr;

Result<Study> Read(const std::string& text) {
  const std::string path = ScratchFile("study.yaml");
  std::ofstream(path) << text;
  return LoadStudy(path);
}

Study Loaded(const std::string& text) {
  const auto study = Read(text);
  EXPECT_TRUE(study.ok()) << study.error().Line();
  return study.value();
}

std::string Fault(const std::string& text) {
  const auto study = Read(text);
  return study.ok() ? "no error" : study.error().Line();
}

TEST(Study, GridCrossesAllValuesLastAxisFastest) {
  const Study study = Loaded(
      "scenario: curve_r550\naxes:\n"
      "  - {key: scenario.speed_km_h, from: 40, to: 60, count: 3}\n"
      "  - {key: scenario.bogie, values: [phs, rigid_link]}\n");
  ASSERT_EQ(study.num_runs(), 6);
  EXPECT_EQ(study.runs[0], (std::vector<std::string>{"40", "phs"}));
  EXPECT_EQ(study.runs[1], (std::vector<std::string>{"40", "rigid_link"}));
  EXPECT_EQ(study.runs[5], (std::vector<std::string>{"60", "rigid_link"}));
}

TEST(Study, ListTakesItsRunsFromATable) {
  std::ofstream(ScratchFile("cases.csv"))
      << "scenario.speed_km_h,scenario.bogie\n40,phs\n80,soft_link\n";
  const Study study = Loaded("scenario: curve_r550\ndesign: list\ncases: cases.csv\n");
  ASSERT_EQ(study.num_runs(), 2);
  EXPECT_EQ(study.runs[1], (std::vector<std::string>{"80", "soft_link"}));
  EXPECT_EQ(study.axes[0].column, "speed_km_h");
}

TEST(Study, SobolIndicesLayOutBasePointsAndTheirMixtures) {
  const Study study = Loaded(
      "scenario: curve_r550\ndesign: sobol_indices\nsamples: 4\naxes:\n"
      "  - {key: scenario.friction, min: 0.1, max: 0.5}\n"
      "  - {key: model.friction.scale, min: 0.5, max: 1.5}\n");
  ASSERT_EQ(study.num_runs(), 16);
  EXPECT_EQ(study.runs[2][0], study.runs[1][0]);  // A with the first axis from B
  EXPECT_EQ(study.runs[2][1], study.runs[0][1]);
  EXPECT_EQ(study.runs[3][0], study.runs[0][0]);
  EXPECT_EQ(study.runs[3][1], study.runs[1][1]);
}

TEST(Study, ColumnsOfTwoAxesDiffer) {
  const Study study = Loaded(
      "scenario: curve_r550\naxes:\n"
      "  - {key: model.L1.gas_volume_m3, values: [4e-5]}\n"
      "  - {key: model.L2.gas_volume_m3, values: [4e-5]}\n");
  EXPECT_EQ(study.axes[0].column, "model_L1_gas_volume_m3");
  EXPECT_EQ(study.axes[1].column, "model_L2_gas_volume_m3");
}

TEST(Study, EachWrongStudyIsNamed) {
  const std::string head = "scenario: curve_r550\naxes:\n  - ";
  EXPECT_THAT(Fault(head + "{key: scenario.sped_km_h, values: [40]}\n"),
              HasSubstr("scenario.sped_km_h: unknown key"));
  EXPECT_THAT(Fault(head + "{key: scenario.sped_km_h, values: [40]}\n"),
              HasSubstr("did you mean 'speed_km_h'?"));
  EXPECT_THAT(Fault(head + "{key: model.L1.gas_volum_m3, values: [1e-5]}\n"),
              HasSubstr("did you mean 'L1.gas_volume_m3'?"));
  EXPECT_THAT(Fault(head + "{key: track.segmnts.0.length_m, values: [9]}\n"),
              HasSubstr("did you mean 'segments'?"));
  EXPECT_THAT(Fault(head + "{key: track.segments.9.length_m, values: [9]}\n"),
              HasSubstr("no element '9'"));
  EXPECT_THAT(Fault(head + "{key: speed_km_h, values: [9]}\n"), HasSubstr("scenario.KEY"));
  EXPECT_THAT(Fault(head + "{key: scenario.friction, values: []}\n"), HasSubstr("is empty"));
  EXPECT_THAT(Fault(head + "{key: scenario.friction, values: [1]}\n  - {key: scenario.friction, "
                           "values: [1]}\n"),
              HasSubstr("is varied twice"));
  EXPECT_THAT(Fault("scenario: curve_r55\naxes: [{key: scenario.friction, values: [0.3]}]\n"),
              HasSubstr("curve_r550"));
  EXPECT_THAT(Fault("scenario: curve_r550\ndesgin: grid\naxes: [{key: scenario.friction, values: "
                    "[0.3]}]\n"),
              HasSubstr("did you mean 'design'?"));
  EXPECT_THAT(Fault("scenario: curve_r550\n"), HasSubstr("axes"));
  EXPECT_THAT(Fault("scenario: curve_r550\ndesign: sobol\nsamples: 4\naxes: [{key: "
                    "scenario.friction, min: 0.5, max: 0.1}]\n"),
              HasSubstr("max"));
  EXPECT_THAT(Fault(head + "{key: scenario.friction, from: 0, to: 1, count: 2000000}\n"),
              HasSubstr("count"));
}

TEST(CaseFiles, ABogieIsVariedWhereTheCellHoldsAValue) {
  std::ofstream(ScratchFile("bogies.csv"))
      << "scenario.bogie,bogie.coupling_*.stiffness,bogie.anchor_1.stiffness\n"
         "ge_coupling_shaft,x2,\nscheffel_cross_anchors,,1e6\nphs,,\n";
  const Study study = Loaded("scenario: curve_r550\ndesign: list\ncases: bogies.csv\n");
  const ScratchDir dir;
  for (const int run : {0, 1, 2}) {
    ASSERT_TRUE(WriteCaseFiles(study, run, dir.path()).ok());
    const std::string scenario = ReadFile(dir.File("scenario.yaml")).value();
    if (run == 2) {
      EXPECT_THAT(scenario, HasSubstr("bogie: phs\n"));
    }
  }
  EXPECT_THAT(ReadFile(dir.File("ge_coupling_shaft.xml")).value(),
              HasSubstr("stiffness=\"12600000\""));
  EXPECT_THAT(ReadFile(dir.File("scheffel_cross_anchors.xml")).value(),
              HasSubstr("stiffness=\"1e6\""));
  const std::string head = "scenario: curve_r550\naxes:\n  - ";
  EXPECT_THAT(Fault(head + "{key: bogie.lead_left_brackt.pos, values: [x2]}\n"),
              HasSubstr("did you mean 'lead_left_bracket'?"));
}

TEST(CaseFiles, WildcardSetsEveryElementThatHasTheKey) {
  const Study study = Loaded(
      "scenario: curve_r550\naxes:\n"
      "  - {key: track.segments.*.radius_m, values: [321]}\n"
      "  - {key: model.*.gas_volume_m3, values: [1.25e-05]}\n");
  const ScratchDir dir;
  const auto file = WriteCaseFiles(study, 0, dir.path());
  ASSERT_TRUE(file.ok()) << file.error().Line();
  const std::string track = ReadFile(dir.File("track.yaml")).value();
  EXPECT_THAT(track, HasSubstr("321"));
  EXPECT_THAT(track, testing::Not(HasSubstr("radius_m: 550")));
  const std::string model = ReadFile(dir.File("model.yaml")).value();
  std::size_t lines = 0;
  for (std::size_t at = model.find("1.25e-05"); at != std::string::npos;
       at = model.find("1.25e-05", at + 1)) {
    ++lines;
  }
  EXPECT_EQ(lines, 4u);
}

TEST(CaseFiles, WildcardSetsEveryEntryOfAMapThatHasTheKey) {
  const std::string head = "scenario: locomotive_yaw_dampers\naxes:\n  - {key: scenario.joints.*.";
  const ScratchDir dir;
  const auto file = WriteCaseFiles(Loaded(head + "damping, values: [4321]}\n"), 0, dir.path());
  ASSERT_TRUE(file.ok()) << file.error().Line();
  const std::string scenario = ReadFile(dir.File("scenario.yaml")).value();
  EXPECT_EQ(scenario.find("3.0e+5"), std::string::npos) << scenario;
  const std::size_t first = scenario.find("4321");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(scenario.find("4321", first + 1), std::string::npos) << "both joints";
  EXPECT_THAT(Fault(head + "stiffness, values: [1]}\n"), HasSubstr("in no element"))
      << "no joint of the scenario has a stiffness";
  EXPECT_THAT(Fault("scenario: locomotive_yaw_dampers\naxes:\n  - {key: scenario.joints.*.x.y, "
                    "values: [1]}\n"),
              HasSubstr("in no element"));
}

TEST(Outputs, AreFoundByPathAndNamedByColumn) {
  const nlohmann::ordered_json summary = {
      {"steady_curve", {{"wheelsets", {{{"name", "lead"}, {"lateral_m", 0.5}}}}}},
      {"run", {{"max_sum_Y_N", 7}}}};
  EXPECT_EQ(NumberAt(summary, "steady_curve.wheelsets.lead.lateral_m").value(), 0.5);
  EXPECT_EQ(OutputColumn("steady_curve.wheelsets.lead.lateral_m"), "lead_lateral_m");
  EXPECT_EQ(OutputColumn("cases.traction, electric braking.largest_shift_m"),
            "traction_electric_braking_largest_shift_m")
      << "a comma would end the column";
  EXPECT_EQ(OutputColumns({"bending.damping", "run.T_gamma_total_J", "shear.damping"}),
            (std::vector<std::string>{"bending_damping", "T_gamma_total_J", "shear_damping"}));
  EXPECT_EQ(NumberAt(summary, "run.max_sum_Y_N").value(), 7);
  const auto wrong = NumberAt(summary, "steady_curve.wheelsets.led.lateral_m");
  ASSERT_FALSE(wrong.ok());
  EXPECT_THAT(wrong.error().Line(),
              HasSubstr("did you mean 'steady_curve.wheelsets.lead.lateral_m'?"));
}

}  // namespace
}  // namespace phs::sweep
