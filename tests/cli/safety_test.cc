// The program from outside: nothing of the user's is lost, nothing half-done is given as a result.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/result_dir.h"
#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SafetyTest : public testing::Test {
 protected:
  SafetyTest() {
    dir_.Write("short.yaml", "track: straight\nbogie: phs\nspeed_km_h: 60\nduration_s: 0.05\n");
    dir_.Write("long.yaml", "track: straight\nbogie: phs\nspeed_km_h: 60\nduration_s: 4000\n");
  }
  std::string Path(const std::string& name) const { return dir_.File(name); }
  std::string Simulate(const std::string& scenario, const std::string& more) const {
    return "simulate " + Path(scenario) + " --quiet " + more;
  }
  /// Shell words after a command: once its folder stands and it has worked a while, `kill`.
  std::string Begun(const std::string& kill) const {
    return " & P=$!; for i in $(seq 3000); do ls -d " + Path("cut.partial.*") +
           " >/dev/null 2>&1 && break; sleep 0.02; done; sleep 1; " + kill + "; wait $P";
  }
  void ExpectNothingLeft() const {
    for (const std::string& name : NamesIn(dir_.path()))
      EXPECT_THAT(name, testing::Not(HasSubstr("cut")));
  }
  static void ExpectOneLine(const Output& out, int code, const std::string& words) {
    EXPECT_EQ(out.code, code) << out.text;
    EXPECT_THAT(out.text, HasSubstr(words));
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
  }
  ScratchDir dir_;
};

TEST_F(SafetyTest, ForceLeavesAForeignFolderAlone) {
  fs::create_directory(Path("mine"));
  dir_.Write("mine/thesis.tex", "ten years");
  ExpectOneLine(ExecutePhs(Simulate("short.yaml", "--force --out " + Path("mine"))), 3,
                "is no former result of phs: it holds 'thesis.tex'");
  EXPECT_EQ(ReadFile(Path("mine/thesis.tex")).value(), "ten years");
  EXPECT_EQ(NamesIn(Path("mine")).size(), 1u);
}

TEST_F(SafetyTest, AnEmptyNameIsNoResultFolder) {
  for (const char* call : {"--out ''", "--out=", "--junit ''"}) {
    EXPECT_EQ(ExecutePhs(Simulate("short.yaml", call)).code, 2) << call;
  }
  ExpectOneLine(ExecutePhs(Simulate("short.yaml", "--out ''")), 2,
                "is empty; name a file or folder");
}

TEST_F(SafetyTest, ACutRunIsNoResult) {
  const std::string begin = "simulate " + Path("long.yaml") + " --out " + Path("cut");
  const Output cut = Execute(PhsCommand(begin) + Begun("kill -TERM $P"));
  EXPECT_EQ(cut.code, 143) << cut.text;
  EXPECT_THAT(cut.text, HasSubstr("stopped; nothing written"));
  ExpectNothingLeft();
}

// timeout(1) sends its signal twice, a moment apart: one wish, and the folder goes. A second wish
// later ends the program at once.
TEST_F(SafetyTest, ASignalSentTwiceIsOneWish) {
  const std::string begin =
      "compare " + Path("long.yaml") + " --bogies phs,rigid_link --out " + Path("cut");
  const Output cut = Execute(PhsCommand(begin) + Begun("kill -INT $P; kill -INT $P"));
  EXPECT_EQ(cut.code, 130) << cut.text;
  ExpectNothingLeft();
}

TEST_F(SafetyTest, AFullDiskIsNoBadInput) {
  const Output full = Execute("trap '' XFSZ; ulimit -f 16; " +
                              PhsCommand(Simulate("short.yaml", "--out " + Path("full"))));
  EXPECT_EQ(full.code, 1) << full.text;
  EXPECT_THAT(full.text, HasSubstr("no room left on the disk"));
  EXPECT_FALSE(fs::exists(Path("full")));
  ExpectOneLine(Execute(PhsCommand(Simulate("short.yaml", "--format json")) + " >/dev/full"), 1,
                "stdout: cannot be written: no room left on the disk");
}

TEST_F(SafetyTest, AcceptedNoMoreThoughWrong) {
  const auto refused = [&](const std::string& lines, const std::string& words) {
    dir_.Write("wrong.yaml", "speed_km_h: 60\nduration_s: 0.05\n" + lines);
    ExpectOneLine(ExecutePhs(Simulate("wrong.yaml", "")), 3, words);
  };
  refused("trak: straight\n", "trak: unknown key");
  refused("track: straight\nfailures: [{kind: line_burst, line: L1, at_m: 1e5}]\n",
          "lies beyond the track");
  ExpectOneLine(ExecutePhs(Simulate("short.yaml", "--timestep 1")), 2,
                "is 1; allowed: 1e-06 … 0.05");
  // Three of its four cylinders would hang there without a force.
  ExpectOneLine(ExecutePhs(Simulate("short.yaml", "--phs bench_seal")), 3,
                "PHS model 'bench_seal' only 1");
  std::string model = ReadFile(std::string(PHS_SOURCE_DIR) + "/models/phs/bo_bo.yaml").value();
  const std::string from = "static_pressure_Pa: 1.8e6";
  model.replace(model.find(from), from.size(), "static_pressure_Pa: 1.8");
  dir_.Write("model.yaml", model);
  refused("track: straight\nphs: " + Path("model.yaml") + "\n",
          "static_pressure_Pa: 1.8 is out of range");
}

}  // namespace
}  // namespace phs
