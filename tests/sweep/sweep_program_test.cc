// phs sweep from outside: the same table whatever happens on the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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
    std::ofstream(dir_.File("short.yaml")) << "track: straight\nbogie: phs\nspeed_km_h: 60\n"
                                              "duration_s: 0.1\n";
    Study("short.yaml", "  - {key: scenario.speed_km_h, from: 40, to: 73, count: 12}\n");
  }
  void Study(const std::string& scenario, const std::string& axes) {
    std::ofstream(dir_.File("study.yaml")) << "scenario: " << scenario << "\naxes:\n" << axes;
  }
  static void ExpectOneLine(const Output& out, const std::string& words) {
    EXPECT_EQ(out.code, 3) << out.text;
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
  EXPECT_EQ(NamesIn(dir_.File("one")),
            (std::vector<std::string>{"index.sqlite", "report.html", "study.yaml", "sweep.csv"}));
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
  std::ofstream(dir_.File("study.yaml"), std::ios::app) << "outputs: [run.max_sum_Y_Nn]\n";
  const Output wrong = Sweep("mixed");
  EXPECT_EQ(wrong.code, 1) << wrong.text;  // every run says that there is no such output
  EXPECT_THAT(wrong.text, HasSubstr("did you mean 'run.max_sum_Y_N'?"));
  ASSERT_EQ(Execute("mv " + dir_.File("mixed") + " " + dir_.File("old.unfinished")).code, 0);
  ExpectOneLine(Sweep("old", "--resume"), "holds no unfinished sweep");
  std::ofstream(dir_.File("old.unfinished/plan.txt")) << "another\n";
  ExpectOneLine(Sweep("old", "--resume"), "belongs to another study");
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
  ASSERT_EQ(Sweep("whole", "--workers 1").code, 0);
  // Files may grow to 1 kB: records fit, the table does not.
  ExpectOneLine(Execute("trap '' XFSZ; ulimit -f 1; " + Command("full", "--workers 1")),
                "full.unfinished");
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
