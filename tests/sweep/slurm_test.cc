// phs sweep --engine slurm: against a real Slurm of one node where it can be started, and against
// a scheduler that lies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/result_dir.h"
#include "phs_places.h"
#include "sweep/slurm_client.h"
#include "tests/sweep/sweep_folder.h"

namespace phs {
namespace {

using testing::HasSubstr;
using testing::Not;

class SlurmSweep : public SweepFolder {
 protected:
  SlurmSweep() {
    WriteScenario(0.1);
    std::ofstream(dir_.File("study.yaml")) << "scenario: short.yaml\naxes:\n"
                                              "  - {key: scenario.speed_km_h, from: 40, to: 73, "
                                              "count: 12}\n";
  }
  void WriteScenario(double duration_s) const {
    std::ofstream(dir_.File("short.yaml"))
        << "track: straight\nbogie: phs\nspeed_km_h: 60\nduration_s: " << duration_s << "\n";
  }
  std::string LocalTable() const {
    const Output local = Sweep("local");
    EXPECT_EQ(local.code, 0) << local.text;
    return Table("local");
  }
};

// ---- A real Slurm ----

class RealSlurm : public SlurmSweep {
 protected:
  void SetUp() override {
    // Sockets need short paths.
    char pattern[] = "/tmp/phs_slurm_XXXXXX";
    ASSERT_NE(mkdtemp(pattern), nullptr);
    home_ = pattern;
    const Output start = Execute(Node("start " + home_ + " " + std::to_string(getpid())));
    constexpr int kSkipped = 77;
    if (start.code == kSkipped) {
      home_started_ = false;
      GTEST_SKIP() << start.text;
    }
    ASSERT_EQ(start.code, 0) << start.text;
    environment_ = "export " + start.text.substr(0, start.text.find('\n')) + "; ";
  }
  void TearDown() override {
    if (home_started_) Execute(Node("stop " + home_));
    std::error_code ignored;
    std::filesystem::remove_all(home_, ignored);
  }
  static std::string Node(const std::string& what) {
    return std::string(PHS_SOURCE_DIR) + "/tests/sweep/slurm_single_node " + what;
  }
  std::string home_;
  bool home_started_ = true;
};

// A task is killed with SIGKILL while it works: the table has the bytes of the local engine. Then
// submitted in two arrays (this Slurm allows five tasks in one) without waiting, and collected.
TEST_F(RealSlurm, ATaskKilledInTheMiddleIsMadeAgainAndTheTableIsThatOfTheLocalEngine) {
  WriteScenario(1.0);
  const std::string local = LocalTable();
  const Output killed = Execute(
      environment_ + Command("killed", "--engine slurm --chunk 6") + " & S=$!; " +
      UntilRecords("killed", 1) + "T=$(pgrep -f '[s]lurm-task " + dir_.File("killed.unfinished") +
      "' | head -n 1); kill -KILL $T && echo killed task $T; wait $S; C=$?; "
      "squeue --noheader --states=all --format='%T' | sort | uniq -c; exit $C");
  EXPECT_EQ(killed.code, 0) << killed.text;
  EXPECT_THAT(killed.text, HasSubstr("killed task"));
  EXPECT_THAT(killed.text, HasSubstr("FAILED")) << "Slurm saw no task die";
  EXPECT_EQ(Table("killed"), local);

  const Output submitted = Sweep("later", "--engine slurm --chunk 2 --no-wait");
  EXPECT_EQ(submitted.code, 0) << submitted.text;
  EXPECT_THAT(submitted.text, HasSubstr("--resume collects"));
  const Output collected = Sweep("later", "--engine slurm --resume");
  EXPECT_EQ(collected.code, 0) << collected.text;
  EXPECT_EQ(Table("later"), local);
}

// ---- A scheduler that lies ----

/// Commands named as Slurm's, put in front of the path. `sbatch` runs each task of an array at once
/// unless `lose` (a shell condition on $SLURM_ARRAY_TASK_ID and the number of the array $job) says
/// that it vanishes; whatever happens it says that all is well.
class LyingScheduler : public SlurmSweep {
 protected:
  void Install(const std::string& lose) {
    Script("scontrol", "echo 'MaxArraySize            = 3'");
    Script("sinfo", "echo 0/2/0/2");
    Script("squeue", "true");
    Script("sbatch", "job=$(($(cat " + dir_.File("count") + " 2>/dev/null || echo 0) + 1))\n" +
                         "echo $job >" + dir_.File("count") + "\n" +
                         "for a; do case $a in --array=*) last=${a#--array=0-};; esac; done\n"
                         "while [ $# -gt 2 ]; do shift; done\n"
                         "for i in $(seq 0 $last); do export SLURM_ARRAY_TASK_ID=$i\n"
                         "  if " +
                         lose +
                         "; then :; else sh $1 $2 >/dev/null; fi\n"
                         "done\necho $job");
    environment_ = "export PATH=" + dir_.path() + "/bin:$PATH; ";
  }
  void Script(const std::string& name, const std::string& text) {
    std::filesystem::create_directories(dir_.path() + "/bin");
    const std::string path = dir_.path() + "/bin/" + name;
    std::ofstream(path) << "#!/bin/bash\n" << text << "\n";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }
  int Arrays() const {
    const auto text = ReadFile(dir_.File("count"));
    return text.ok() ? std::stoi(text.value()) : 0;
  }
};

TEST_F(LyingScheduler, LostTasksAreFoundByTheirMissingRecordsAndSubmittedAgain) {
  const std::string local = LocalTable();
  Install("[ $SLURM_ARRAY_TASK_ID = 1 -a $job -le 2 ]");
  const Output out = Sweep("lost", "--engine slurm --chunk 2");
  EXPECT_EQ(out.code, 0) << out.text;
  EXPECT_EQ(Table("lost"), local);
  EXPECT_EQ(Arrays(), 3);  // 6 tasks in arrays of 3, then the two lost ones
}

TEST_F(LyingScheduler, ARunThatEndsItsTaskEveryTimeIsKilledAndTheOthersAreMade) {
  // The runs' second line of every task file that begins with run 4 never starts.
  Install("grep -q '^4\\b' <(sed -n $((SLURM_ARRAY_TASK_ID + 1))p $2)");
  const Output out = Sweep("poison", "--engine slurm --chunk 2");
  EXPECT_EQ(out.code, 1) << out.text;
  EXPECT_THAT(out.text, HasSubstr("11 ok, 1 killed"));
  EXPECT_THAT(Table("poison"), HasSubstr("4,52,killed,"));
  EXPECT_THAT(Table("poison"), HasSubstr("its Slurm task was lost 3 times, at last as "));
}

TEST_F(LyingScheduler, TasksThatNeverLeaveAResultEndTheSweepAndItCanBeResumed) {
  Install("true");
  const Output out = Sweep("futile", "--engine slurm --chunk 1");
  EXPECT_EQ(out.code, 3) << out.text;
  EXPECT_THAT(out.text, HasSubstr("10 tasks in a row left no result"));
  EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
  Install("false");
  const Output resumed = Sweep("futile", "--engine slurm --resume");
  EXPECT_EQ(resumed.code, 0) << resumed.text;
  EXPECT_THAT(Table("futile"), Not(HasSubstr("killed")));
}

TEST_F(LyingScheduler, ThePlanIsSaidAndNothingIsSubmitted) {
  Install("false");
  std::ofstream(dir_.File("study.yaml"), std::ios::app)
      << "slurm: {partition: rail, time_min: 30, options: [--account=x]}\n";
  const Output out = Sweep("plan", "--engine slurm --plan --chunk 3");
  EXPECT_EQ(out.code, 0) << out.text;
  EXPECT_THAT(out.text, HasSubstr("12 runs in 4 tasks of 3 runs, 2 job arrays"));
  EXPECT_THAT(out.text, HasSubstr("--array=0-2"));
  EXPECT_THAT(out.text, HasSubstr("--partition='rail' --time=30 '--account=x'"));
  EXPECT_EQ(Arrays(), 0);
}

TEST_F(LyingScheduler, WithoutSlurmOneLineSaysSo) {
  environment_ = "export PATH=" + dir_.path() + "/bin:/nowhere; ";
  const Output out = Sweep("none", "--engine slurm");
  EXPECT_EQ(out.code, 3) << out.text;
  EXPECT_THAT(out.text, HasSubstr("scontrol: was not found"));
  EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
}

TEST(SlurmClient, WordsOfAShellCommandAreSafe) {
  EXPECT_EQ(sweep::ShellWord("a'b c"), "'a'\\''b c'");
  EXPECT_TRUE(sweep::IsOver("NODE_FAIL"));
  EXPECT_FALSE(sweep::IsOver("COMPLETING"));
}

}  // namespace
}  // namespace phs
