// `phs study`: a small study of a sweep and a verb from outside, its report and numbers, going on
// after a stop, and every refusal. `phs alarms`: a cut of the shipped study.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;

std::string Read(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class StudyTest : public testing::Test {
 protected:
  /// Two reservoirs at two temperatures, setup 1 without pressure in the cold, and the load cases.
  StudyTest() {
    dir_.Write("sweep.yaml",
               "scenario: straight\nanalysis: held\naxes:\n"
               "  - {key: scenario.phs, values: [quarter_setup1, quarter_setup4]}\n"
               "  - {key: model.filled_at_K, values: [293.15]}\n"
               "  - {key: model.temperature_K, values: [253.15, 293.15]}\n"
               "  - {key: note.place_m, values: [7]}\n"
               "outputs: [rest.shear_stiffness_Nm_per_rad, rest.lines.L2.pressure_Pa]\n");
    Write("may_fail: true\n");
  }
  void Write(const std::string& more, const std::string& run = "[loads, --bogie, phs]") {
    const std::string indented = more.empty() ? "" : "    " + more;
    dir_.Write("study.yaml",
               "question: What does the cold do?\nparts:\n  - name: cold\n"
               "    text: Two reservoirs.\n    sweep: sweep.yaml\n" +
                   indented +
                   "    plots: [{x: temperature_K, y: L2_pressure_Pa, by: [phs]}]\n"
                   "    spreads: [{title: shear, of: [shear_stiffness_Nm_per_rad], "
                   "by: [phs], within_factor: 2}]\n"
                   "  - {name: loads, run: " +
                   run + "}\n");
  }
  Output Study(const std::string& more) const {
    return ExecutePhs("study " + dir_.File("study.yaml") + " --quiet --out " + dir_.File("out") +
                      " " + more);
  }
  ScratchDir dir_;
};

TEST_F(StudyTest, PartsBecomeOneResultWithReportPlotsAndSpreads) {
  const Output made = Study("--jobs 1");
  ASSERT_EQ(made.code, 0) << made.text;
  EXPECT_THAT(made.text, AllOf(HasSubstr("What does the cold do?"),
                               HasSubstr("1 of 2 keep within a factor of 2")));
  const Json study = Json::parse(Read(dir_.File("out/study.json")));
  const Json& cold = study["parts"][0];
  EXPECT_EQ(cold["exit_code"], 1) << "setup 1 has lost its pressure";
  EXPECT_EQ(cold["status"], "ok");
  const Json& groups = cold["spreads"][0]["groups"];
  EXPECT_EQ(groups[0]["lacking"], 1);
  EXPECT_FALSE(groups[0]["kept"].get<bool>());
  EXPECT_TRUE(groups[1]["kept"].get<bool>());
  const Json& curve = cold["plots"][0]["curves"][1];
  EXPECT_EQ(curve["x"], Json({253.15, 293.15}));
  EXPECT_NEAR(curve["y"][1].get<double>(), 1.8e6, 1) << "as filled";
  for (const char* file : {"report.html", "study.yaml", "cold/sweep.csv", "cold/report.html",
                           "cold.txt", "loads/loads.json", "loads.txt", "origin.json"}) {
    EXPECT_TRUE(fs::exists(dir_.File(std::string("out/") + file))) << file;
  }
  EXPECT_FALSE(fs::exists(dir_.File("out.unfinished")));
  EXPECT_THAT(Read(dir_.File("out/cold/sweep.csv")), HasSubstr("place_m"));
  EXPECT_THAT(Read(dir_.File("out/report.html")), HasSubstr("cold/report.html"));
  fs::remove(dir_.File("out/report.html"));
  EXPECT_EQ(ExecutePhs("report " + dir_.File("out")).code, 0);
  EXPECT_TRUE(fs::exists(dir_.File("out/report.html")));
  EXPECT_EQ(Study("").code, 3) << "it exists already";
  EXPECT_EQ(Study("--force").code, 0);
}

TEST_F(StudyTest, APartWhoseRunsMayNotFailFailsTheStudyAndLimitsAreHeld) {
  const std::string limits = dir_.Write(
      "limits.yaml", "limits:\n  - {quantity: spreads.shear.kept, bogie: cold, at_least: 2}\n");
  const Output missed = Study("--check " + limits);
  EXPECT_EQ(missed.code, 1);
  EXPECT_THAT(missed.text, HasSubstr("cold: spreads.shear.kept is 1"));
  Write("");
  const Output failed = Study("--force");
  EXPECT_EQ(failed.code, 1);
  EXPECT_THAT(failed.text, HasSubstr("exit code 1"));
  EXPECT_EQ(Json::parse(Read(dir_.File("out/study.json")))["status"], "failed");
}

TEST_F(StudyTest, WhatIsFinishedIsKeptAndGoesOn) {
  Write("may_fail: true\n", "[loads, --bogie, no_such_bogie]");
  const Output wrong = Study("");
  EXPECT_EQ(wrong.code, 3);
  EXPECT_THAT(wrong.text, HasSubstr("part loads"));
  EXPECT_TRUE(fs::exists(dir_.File("out.unfinished/cold/sweep.csv")));
  EXPECT_THAT(Study("").text, HasSubstr("unfinished study"));
  Write("may_fail: true\n");
  EXPECT_THAT(Study("--resume").text, HasSubstr("another study"));
  EXPECT_EQ(Study("--force").code, 0);
}

TEST_F(StudyTest, WrongVerbsOptionsAndKeysAreRefusedBeforeAnythingRuns) {
  const auto refused = [&](const std::string& run, const std::string& says) {
    Write("", run);
    const Output out = Study("");
    EXPECT_EQ(out.code, 3) << run;
    EXPECT_THAT(out.text, HasSubstr(says)) << run;
    EXPECT_FALSE(fs::exists(dir_.File("out.unfinished"))) << run;
  };
  refused("[load, --bogie, phs]", "did you mean 'loads'");
  refused("[list]", "no verb with a result");
  refused("[study, alarms]", "no verb with a result");
  refused("[loads, --bogi, phs]", "did you mean '--bogie'");
  refused("[loads, --out, x]", "given by the study itself");
  dir_.Write("sweep.yaml",
             "scenario: straight\nanalysis: held\naxes:\n"
             "  - {key: model.temperature_K, values: [253.15]}\n"
             "outputs: [rest.shear_stiffness_Nm_per_rad]\n");
  refused("[loads, --bogie, phs]", "asks for column 'L2_pressure_Pa'");
  refused("[]", "a part is a sweep or a verb");
  EXPECT_THAT(ExecutePhs("study temperature_dai").text,
              HasSubstr("did you mean 'temperature_day'"));
}

TEST_F(StudyTest, ASweepAloneIsAStudyOfOnePart) {
  const Output made =
      ExecutePhs("study " + dir_.File("sweep.yaml") + " --quiet --out " + dir_.File("one"));
  EXPECT_EQ(made.code, 1) << "runs that fail are no answer here";
  const Json study = Json::parse(Read(dir_.File("one/study.json")));
  EXPECT_EQ(study["parts"].size(), 1u);
  EXPECT_TRUE(fs::exists(dir_.File("one/sweep/sweep.csv")));
}

/// A table of runs with its comments, head and every `every`-th row.
std::string Thinned(const std::string& path, int every) {
  std::ifstream file(path);
  std::string text, line;
  int row = -1;
  while (std::getline(file, line)) {
    if (line[0] == '#' || row++ < 0 || row % every == 1) text += line + "\n";
  }
  return text;
}

/// The shipped study as it is, its lists of runs thinned out.
TEST(ShippedStudies, TheDayCutToAFewHours) {
  const ScratchDir dir;
  const std::string models = PHS_SOURCE_DIR "/models/";
  fs::create_directory(dir.File("studies"));
  fs::create_directory(dir.File("sweeps"));
  dir.Write("studies/temperature_day.yaml", Read(models + "studies/temperature_day.yaml"));
  for (const std::string name :
       {"temperature_day", "temperature_day_loads", "temperature_fillings"}) {
    dir.Write("sweeps/" + name + ".yaml", Read(models + "sweeps/" + name + ".yaml"));
  }
  for (const std::string name : {"temperature_day", "temperature_fillings"}) {
    dir.Write("sweeps/" + name + ".csv", Thinned(models + "sweeps/" + name + ".csv", 9));
  }
  const Output made = ExecutePhs("study " + dir.File("studies/temperature_day.yaml") +
                                 " --quiet --format json --out " + dir.File("out"));
  ASSERT_EQ(made.code, 0) << made.text;
  const Json study = Json::parse(made.text);
  EXPECT_EQ(study["parts"].size(), 3u);
  EXPECT_GE(study["parts"][0]["plots"][1]["curves"].size(), 4u) << "of the reservoirs";
  for (const Json& part : study["parts"]) {
    for (const Json& spread : part["spreads"]) EXPECT_FALSE(spread["groups"].empty());
  }
}

TEST(ShippedStudies, AreShown) {
  EXPECT_THAT(ExecutePhs("show alarms").text, HasSubstr("question:"));
  EXPECT_THAT(ExecutePhs("list studies").text, HasSubstr("Which pair of line pressures"));
}

TEST(AlarmsTest, ACutFindsAPairForEveryHoseAndCountsFalseAlarms) {
  const ScratchDir dir;
  const std::string track = dir.Write(
      "t.yaml",
      "name: t\ngauge_m: 1.067\ngauge_height_m: 0.014\nsegments:\n  - {kind: tangent, length_m: "
      "900}\n"
      "irregularity: {psd: errib176_low, seed: 1, begin_s_m: 20, end_s_m: 900, fade_m: 10}\n");
  const std::string scenario = dir.Write(
      "s.yaml",
      "track: t.yaml\nbogie: phs\nphs: bo_bo_measured\nspeed_km_h: 80\nwheel: S1002\nrail: UIC60\n"
      "friction: 0.35\ncreep: kalker_table\ntimestep_s: 0.001\n");
  // Two kilometres cannot tell a threshold for one alarm in 10 000 km.
  const std::string command =
      "alarms " + scenario +
      " --learn-km 2 --test-km 2 --bursts 1 --block 100 --wanted 20 --quiet --format json";
  const Output made = ExecutePhs(command + " --workers 2 --out " + dir.File("out"));
  ASSERT_EQ(made.code, 0) << made.text;
  const Json all = Json::parse(Read(dir.File("out/alarms.json")));
  EXPECT_EQ(all["hoses"].size(), 4u);
  for (const Json& hose : all["hoses"]) {
    EXPECT_EQ(hose["alarmed"], hose["runs"]) << hose["name"];
    EXPECT_LT(hose["largest_seconds_to_alarm"].get<double>(), 5) << hose["name"];
    EXPECT_EQ(hose["name"], hose["bursts"][0]["lowest_line"]);
    EXPECT_GT(hose["until_alarm"]["sum_Y_N"].get<double>(), 0);
  }
  const double km = all["false_alarms"]["distance_km"].get<double>();
  EXPECT_GE(km, 2);
  EXPECT_EQ(all["false_alarms"]["count"], 0);
  EXPECT_NEAR(all["false_alarms"]["upper_per_1000_km"].get<double>(), 1e3 * -std::log(0.05) / km,
              1e-6);
  EXPECT_TRUE(fs::exists(dir.File("out/signals.csv")));
  EXPECT_EQ(ExecutePhs("report " + dir.File("out")).code, 0);
  const Output one = ExecutePhs(command + " --workers 1");
  EXPECT_EQ(Json::parse(one.text), all) << "the same for any number of workers";
  // A block is a whole run where nothing is said: 900 m less ten seconds at 80 km/h.
  const Output few = ExecutePhs("alarms " + scenario + " --learn-km 1 --test-km 1 --quiet");
  EXPECT_EQ(few.code, 3);
  EXPECT_THAT(few.text,
              HasSubstr("fewer than three blocks to learn from; allowed: blocks of 664 m"));
}

TEST(AlarmsTest, ATrackWithoutASpectrumOrTooShortIsRefused) {
  EXPECT_THAT(ExecutePhs("alarms straight").text, HasSubstr("no spectrum of irregularities"));
  const ScratchDir dir;
  dir.Write("t.yaml",
            "name: t\ngauge_m: 1.067\ngauge_height_m: 0.014\nsegments:\n"
            "  - {kind: tangent, length_m: 300}\nirregularity: {psd: errib176_low, seed: 1}\n");
  const std::string scenario = dir.Write("s.yaml", "track: t.yaml\nbogie: phs\nspeed_km_h: 80\n");
  const Output out = ExecutePhs("alarms " + scenario);
  EXPECT_EQ(out.code, 3);
  EXPECT_THAT(out.text, HasSubstr("too short to look at a run"));
}

}  // namespace
}  // namespace phs
