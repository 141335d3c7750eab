// phs sweep from outside: the same table whatever happens on the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/result_dir.h"
#include "tests/sweep/sweep_folder.h"

namespace phs {
namespace {

using testing::HasSubstr;

class SweepProgram : public SweepFolder {
 protected:
  SweepProgram() {
    std::ofstream(dir_.File("track_text"))
        << "gauge_m: 1.067\ngauge_height_m: 0.014\nsegments:\n  - {kind: tangent, length_m: 100}\n";
    std::ofstream(dir_.File("short.yaml")) << "track: straight\nbogie: phs\nspeed_km_h: 60\n"
                                              "duration_s: 0.1\n";
    Study("short.yaml", "  - {key: scenario.speed_km_h, from: 40, to: 73, count: 12}\n");
  }
  void Study(const std::string& scenario, const std::string& axes) {
    std::ofstream(dir_.File("study.yaml")) << "scenario: " << scenario << "\naxes:\n" << axes;
  }
  static void ExpectOneLine(const Output& out, const std::string& words, int code = 3) {
    EXPECT_EQ(out.code, code) << out.text;
    EXPECT_THAT(out.text, HasSubstr(words));
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
  }
};

TEST_F(SweepProgram, SameTableForOneTwoAndFiveWorkers) {
  ASSERT_EQ(Sweep("one", "--workers 1").code, 0);
  ASSERT_EQ(Sweep("two", "--workers 2").code, 0);
  ASSERT_EQ(Sweep("five", "--workers 5").code, 0);
  const std::string table = Table("one");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 13);
  EXPECT_EQ(table, Table("two"));
  EXPECT_EQ(table, Table("five"));
  EXPECT_EQ(
      NamesIn(dir_.File("one")),
      (std::vector<std::string>{".phs_result", "index.sqlite", "origin.json", "plan.txt",
                                "report.html", "study.yaml", "sweep.csv", "sweep_report.json"}));
  // Drawn again from the folder alone, elsewhere and without the study, the page is the same.
  const std::string page = ReadFile(dir_.File("one/report.html")).value();
  std::filesystem::remove(dir_.File("one/report.html"));
  std::filesystem::rename(dir_.File("one"), dir_.File("moved"));
  std::filesystem::rename(dir_.File("study.yaml"), dir_.File("gone.yaml"));
  const Output drawn = Execute(PhsCommand("report " + dir_.File("moved")));
  EXPECT_EQ(drawn.code, 0) << drawn.text;
  EXPECT_TRUE(ReadFile(dir_.File("moved/report.html")).value() == page);
  std::filesystem::remove(dir_.File("moved/sweep_report.json"));
  ExpectOneLine(Execute(PhsCommand("report " + dir_.File("moved"))), "has no sweep_report.json");
}

TEST_F(SweepProgram, KilledHalfWayAndResumedTheTableIsTheSame) {
  ASSERT_EQ(Sweep("whole", "--workers 2").code, 0);
  const Output killed = SweepAndKill("killed", "--workers 2", 3);
  EXPECT_EQ(killed.code, 137) << killed.text;
  EXPECT_TRUE(!ReadFile(dir_.File("killed/sweep.csv")).ok());
  ExpectOneLine(Sweep("killed"), "--resume continues it");
  ASSERT_EQ(Sweep("killed", "--resume").code, 0);
  EXPECT_EQ(Table("whole"), Table("killed"));
}

TEST_F(SweepProgram, OneDirectoryServesOneSweepAtATime) {
  const Output both =
      Execute(Command("shared", "--workers 1") + " & P=$!; for i in $(seq 600); do [ -e " +
              dir_.File("shared.unfinished/plan.txt") + " ] && break; sleep 0.01; done; " +
              Command("shared", "--resume") + "; C=$?; wait $P; exit $C");
  EXPECT_EQ(both.code, 3) << both.text;
  EXPECT_THAT(both.text, HasSubstr("is in use by another sweep"));
  EXPECT_FALSE(Table("shared").empty());
}

TEST_F(SweepProgram, AnotherStudyIsNotMixedIn) {
  std::filesystem::create_directory(dir_.File("old.unfinished"));
  ExpectOneLine(Sweep("old", "--resume"), "holds no unfinished sweep");
  std::ofstream(dir_.File("old.unfinished/plan.txt")) << "another\n";
  ExpectOneLine(Sweep("old", "--resume"), "belongs to another study");
}

TEST_F(SweepProgram, AMisspeltOutputEndsBeforeAnythingRuns) {
  const auto with = [&](const std::string& output) {
    Study("short.yaml", "  - {key: scenario.bogie, values: [rigid_link, phs]}\n");
    std::ofstream(dir_.File("study.yaml"), std::ios::app) << "outputs: [" + output + "]\n";
  };
  with("run.max_sum_Y_Nn");
  ExpectOneLine(Sweep("none"),
                "outputs: run.max_sum_Y_Nn: is no number of the result; allowed: "
                "paths of numbers in summary.json; did you mean 'run.max_sum_Y_N'?");
  with("assessment.worst.sum_Y_max_Nn.value");
  ExpectOneLine(Sweep("none"), "assessment.worst.sum_Y_max_Nn.value");
  EXPECT_FALSE(std::filesystem::exists(dir_.File("none.unfinished")));
  // Only the second bogie has cylinders; the short run has no arc, and nothing is assessed of it.
  with("steady_curve.cylinders.1.force_N, assessment.gauge_m, assessment.nadal_Y_over_Q");
  const Output mixed = Sweep("mixed", "--workers 1");
  EXPECT_EQ(mixed.code, 1) << mixed.text;
  EXPECT_THAT(Table("mixed"), HasSubstr("0,rigid_link,error,"));
  EXPECT_THAT(Table("mixed"), HasSubstr("1,phs,ok,,1.067,"));
}

TEST_F(SweepProgram, ChangedInputsAreNotMixedIn) {
  std::ofstream(dir_.File("bend.yaml")) << Text("track_text");
  std::ofstream(dir_.File("short.yaml"))
      << "track: " + dir_.File("bend.yaml") + "\nbogie: phs\nspeed_km_h: 60\nduration_s: 0.1\n";
  EXPECT_EQ(SweepAndKill("changed", "--workers 1", 2).code, 137);
  const std::string plan = Text("changed.unfinished/plan.txt");
  for (const char* name : {"/bend.yaml\n", "/short.yaml\n", "/study.yaml\n", "/bogie_xml/phs.xml\n",
                           "/bogie_xml/shared/", "/models/phs/", "/models/profiles/S1002.prw\n"}) {
    EXPECT_THAT(plan, HasSubstr(name));
  }
  std::ofstream(dir_.File("bend.yaml"), std::ios::app) << "# another word\n";
  ExpectOneLine(Sweep("changed", "--resume"),
                "/bend.yaml: has changed since the sweep was begun: its runs would be mixed");
  std::ofstream(dir_.File("bend.yaml")) << Text("track_text");
  EXPECT_EQ(Sweep("changed", "--resume").code, 0);
}

TEST_F(SweepProgram, EndedWithTheResultInPlaceItIsFinished) {
  ASSERT_EQ(Sweep("whole", "--workers 2").code, 0);
  std::filesystem::create_directories(dir_.File("whole.unfinished/runs"));
  std::filesystem::copy(dir_.File("whole/plan.txt"), dir_.File("whole.unfinished/plan.txt"));
  std::ofstream(dir_.File("whole.unfinished/plan.txt.tmp.host.1.0")) << "killed while it was writ";
  const std::string table = Table("whole");
  const Output again = Sweep("whole", "--resume");
  EXPECT_EQ(again.code, 0) << again.text;
  EXPECT_THAT(again.text, HasSubstr("was finished already"));
  EXPECT_FALSE(std::filesystem::exists(dir_.File("whole.unfinished")));
  EXPECT_EQ(Sweep("whole", "--resume").code, 0);
  EXPECT_EQ(Table("whole"), table);
}

TEST_F(SweepProgram, ForceReplacesAFormerResultAlone) {
  ASSERT_EQ(Sweep("whole", "--workers 2").code, 0);
  const std::string table = Table("whole");
  // Ended half-way, the old result is still there.
  const Output killed = SweepAndKill("whole", "--force --workers 1", 2);
  EXPECT_EQ(killed.code, 137) << killed.text;
  EXPECT_EQ(Table("whole"), table);
  EXPECT_EQ(Sweep("whole", "--force --workers 2").code, 0);
  EXPECT_EQ(Table("whole"), table);
  std::ofstream(dir_.File("whole/notes.txt")) << "mine";
  ExpectOneLine(Sweep("whole", "--force"), "is no former result of phs: it holds 'notes.txt' too");
  std::filesystem::create_directories(dir_.File("work.unfinished"));
  std::ofstream(dir_.File("work.unfinished/thesis.tex")) << "mine";
  ExpectOneLine(Sweep("work", "--force"), "is no working directory of a sweep");
  EXPECT_EQ(Text("work.unfinished/thesis.tex") + Text("whole/notes.txt"), "minemine");
}

TEST_F(SweepProgram, AScratchThatFailsIsNoResultOfItsRun) {
  ASSERT_EQ(Sweep("whole", "--workers 1").code, 0);
  const Output killed = SweepAndKill("full", "--workers 1", 2);
  EXPECT_EQ(killed.code, 137) << killed.text;
  // A file where the folder of the runs' files belongs: no run can be laid out.
  Execute("rm -rf " + dir_.File("full.unfinished/scratch"));
  std::ofstream(dir_.File("full.unfinished/scratch")) << "in the way";
  const Output stopped = Sweep("full", "--resume --workers 2");
  EXPECT_EQ(stopped.code, 3) << stopped.text;
  EXPECT_THAT(stopped.text, HasSubstr("what is finished is kept"));
  Execute("rm " + dir_.File("full.unfinished/scratch"));
  ASSERT_EQ(Sweep("full", "--resume").code, 0);
  EXPECT_EQ(Table("whole"), Table("full"));
}

TEST_F(SweepProgram, CtrlCKeepsWhatIsFinished) {
  const Output out = Execute(Command("cut", "--workers 1") + " & P=$!; " + UntilRecords("cut", 2) +
                             "kill -TERM $P; wait $P");
  EXPECT_EQ(out.code, 143) << out.text;
  EXPECT_THAT(out.text, HasSubstr("of 12 runs are done; --resume continues"));
  EXPECT_EQ(Sweep("cut", "--resume").code, 0);
}

TEST_F(SweepProgram, AWrongRunIsAnErrorInItsRow) {
  Study("short.yaml", "  - {key: scenario.friction, values: [0.3, 7]}\n");
  const Output out = Sweep("errors");
  EXPECT_EQ(out.code, 1) << out.text;
  const std::string table = Table("errors");
  EXPECT_THAT(table, HasSubstr("0,0.3,ok,"));
  EXPECT_THAT(table, HasSubstr("1,7,error,"));
  EXPECT_THAT(table, HasSubstr("0.01 <= x <= 1"));
}

TEST_F(SweepProgram, AFullDiskLosesNothing) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the sanitizer itself needs larger files";
#endif
  ASSERT_EQ(Sweep("whole", "--workers 1").code, 0);
  // Files may grow to some kB: plan and records fit, the report does not.
  ExpectOneLine(Execute("trap '' XFSZ; ulimit -f 16; " + Command("full", "--workers 1")),
                "no room left on the disk", 1);
  EXPECT_FALSE(std::filesystem::exists(dir_.File("full")));
  ASSERT_EQ(Sweep("full", "--resume").code, 0);
  EXPECT_EQ(Table("whole"), Table("full"));
}

TEST_F(SweepProgram, AnUnreadableScenarioEndsBeforeAnythingRuns) {
  Study("nowhere.yaml", "  - {key: scenario.friction, values: [0.3]}\n");
  ExpectOneLine(Sweep("none"), "'nowhere.yaml' was not found");
  std::ofstream(dir_.File("short.yaml"), std::ios::app) << "speed_km_h: 70\n";
  Study("short.yaml", "  - {key: scenario.friction, values: [0.3]}\n");
  ExpectOneLine(Sweep("none"), "speed_km_h: is given twice");
  EXPECT_FALSE(ReadFile(dir_.File("none.unfinished/plan.txt")).ok());
}

TEST_F(SweepProgram, AWorkerKilledFromOutsideCostsItsRunAndNothingElse) {
  std::ofstream(dir_.File("short.yaml"))
      << "track: straight\nbogie: phs\nspeed_km_h: 60\nduration_s: 5\n";
  Study("short.yaml", "  - {key: scenario.speed_km_h, values: [40, 50, 60, 70]}\n");
  const Output out =
      Execute(Command("worker", "--workers 1") +
              " & S=$!; for i in $(seq 600); do W=$(pgrep -P $S | head -n 1); [ -n \"$W\" ] && "
              "[ -e " +
              dir_.File("worker.unfinished/runs/000000.json") +
              " ] && break; sleep 0.01; done; kill -KILL $W; wait $S");
  EXPECT_EQ(out.code, 1) << out.text;
  EXPECT_THAT(out.text, HasSubstr("3 ok, 1 killed"));
  EXPECT_THAT(Table("worker"), HasSubstr("its process was ended by signal 9 (Killed)"));
}

TEST_F(SweepProgram, OneRunLaidOutAloneRepeatsItsRow) {
  Study("short.yaml",
        "  - {key: model.friction.scale, values: [0.5, 1.5]}\n"
        "  - {key: scenario.speed_km_h, values: [50, 60]}\n");
  ASSERT_EQ(Sweep("all").code, 0);
  ASSERT_EQ(Sweep("alone", "--only 2").code, 0);
  const Output out =
      ExecutePhs("simulate " + dir_.File("alone/scenario.yaml") + " --format json --quiet");
  ASSERT_EQ(out.code, 0) << out.text;
  const std::string key = "\"T_gamma_total_J\": ";
  const std::size_t at = out.text.find(key);
  ASSERT_NE(at, std::string::npos);
  const std::size_t begin = at + key.size();
  const std::string number = out.text.substr(begin, out.text.find_first_of(",\n", begin) - begin);
  EXPECT_THAT(Table("all"), HasSubstr("," + number + ","));
}

}  // namespace
}  // namespace phs
