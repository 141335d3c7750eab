// --check and --junit of every verb that yields numbers: kept is silent and 0, missed is one line
// and 1, wrong is 3 before anything runs; the XML says the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

struct VerbCase {
  const char* verb;
  std::string command;          ///< OUT stands for a result directory
  std::string quantity;         ///< a number of its result
  std::string name;             ///< of what it belongs to: a bogie, a run
  std::string bound = "1e-30";  ///< missed by at_most, kept by at_least
};
void PrintTo(const VerbCase& c, std::ostream* out) { *out << c.verb; }

class VerbChecks : public testing::TestWithParam<VerbCase> {
 protected:
  VerbChecks() {
    dir_.Write(
        "study.yaml",
        "scenario: " +
            dir_.Write("short.yaml", "track: curve_r550\nspeed_km_h: 60\nduration_s: 0.05\n") +
            "\noutputs: [run.max_sum_Y_N]\naxes:\n"
            "  - {key: scenario.speed_km_h, values: [50, 60]}\n");
  }
  /// What it says on stderr with this line as the only limit.
  Output Errors(const std::string& limit) {
    std::string command = GetParam().command;
    const auto put = [&](const std::string& mark, const std::string& value) {
      const size_t at = command.find(mark);
      if (at != std::string::npos) command.replace(at, mark.size(), value);
    };
    put("OUT", "--force --out " + dir_.File("out"));
    put("STUDY", dir_.File("study.yaml"));
    return Execute(PhsCommand(command + " --quiet --check " +
                              dir_.Write("limits.yaml", "limits:\n  - {" + limit + "}\n") +
                              " --junit " + dir_.File("junit.xml") + " 2>&1 >/dev/null"));
  }
  std::string Xml() const {
    std::ifstream file(dir_.File("junit.xml"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  ScratchDir dir_;
};

TEST_P(VerbChecks, KeptLimitsAreSilent) {
  const Output out = Errors("quantity: " + GetParam().quantity + ", at_least: " + GetParam().bound);
  EXPECT_EQ(out.code, 0);
  EXPECT_EQ(out.text, "");
  EXPECT_THAT(Xml(), HasSubstr("failures=\"0\""));
  EXPECT_THAT(Xml(), HasSubstr(GetParam().quantity + " at least"));
}

TEST_P(VerbChecks, AMissedLimitIsNamed) {
  const Output out = Errors("quantity: " + GetParam().quantity + ", bogie: " + GetParam().name +
                            ", at_most: " + GetParam().bound);
  EXPECT_EQ(out.code, 1);
  EXPECT_THAT(out.text, HasSubstr("phs: " + GetParam().name + ": " + GetParam().quantity + " is "));
  EXPECT_THAT(out.text, HasSubstr(" too much"));
  EXPECT_THAT(Xml(), HasSubstr("failures=\"1\""));
}

TEST_P(VerbChecks, AnUnknownQuantityNamesTheNearest) {
  const Output out = Errors("quantity: " + GetParam().quantity + "x, at_most: 1");
  EXPECT_EQ(out.code, 3);
  EXPECT_THAT(out.text, MatchesRegex(".*did you mean '.*run.max_sum_Y_N'.*|.*did you mean '" +
                                     GetParam().quantity + "'.*"));
}

TEST_P(VerbChecks, AWrongFileEndsItBeforeAnyWork) {
  const Output out = Errors("quantity: " + GetParam().quantity + ", atmost: 1");
  EXPECT_EQ(out.code, 3);
  EXPECT_THAT(out.text, HasSubstr("did you mean 'at_most'?"));
  EXPECT_FALSE(std::filesystem::exists(dir_.File("out")));
}

const std::string kRig = PHS_SOURCE_DIR "/models/rigs/quarter_sine.yaml";
const std::string kSteps = PHS_SOURCE_DIR "/models/rigs/steps_setup2.yaml";

INSTANTIATE_TEST_SUITE_P(
    Verbs, VerbChecks,
    testing::Values(
        VerbCase{"modes", "modes --bogie phs OUT", "bending.stiffness_Nm_per_rad", "phs"},
        VerbCase{"loads", "loads --bogie phs OUT", "cases.braking.largest_cylinder_N", "phs"},
        // Stable as far as was looked: the critical speed is at least the highest speed.
        VerbCase{"stability", "stability --bogie rigid_link --from 10 --to 20 --speeds 2 OUT",
                 "critical_speed_m_s", "rigid_link", "19.9"},
        VerbCase{"curving", "curving --bogies phs --radii 800 OUT", "curves.r800.T_gamma_N", "phs"},
        VerbCase{"rig", "rig " + kRig + " OUT", "extremes.load_cell_N.most", kRig},
        VerbCase{"identify", "identify " + kSteps + " OUT", "channels.p_end_Pa.after.nrmse",
                 kSteps},
        VerbCase{"sweep", "sweep STUDY --workers 1 OUT", "run.max_sum_Y_N", "run_1"},
        VerbCase{"sweep_as_a_whole", "sweep STUDY --workers 1 OUT", "largest.run.max_sum_Y_N",
                 "sweep"}),
    [](const auto& of) { return std::string(of.param.verb); });

TEST(WordLimit, AVerdictIsHeldToWords) {
  ScratchDir dir;
  const auto run = [&](const std::string& words) {
    return Execute(PhsCommand(
        "identify " + kSteps + " --quiet --force --out " + dir.File("out") + " --check " +
        dir.Write("limits.yaml", "limits:\n  - {quantity: rig, is: " + words + "}\n") +
        " 2>&1 >/dev/null"));
  };
  EXPECT_EQ(run("[steps, quarter]").code, 0);
  const Output missed = run("[quarter]");
  EXPECT_EQ(missed.code, 1);
  EXPECT_THAT(missed.text, HasSubstr("rig is 'steps', one of quarter allowed\n"));
}

TEST(RigByName, AManifestThatShipsNeedsNoPath) {
  ScratchDir dir;
  EXPECT_EQ(
      Execute("cd / && " + PhsCommand("rig quarter_sine --quiet --out " + dir.File("out"))).code,
      0);
  EXPECT_THAT(ExecutePhs("rig quarter_sin --out " + dir.File("none")).text,
              HasSubstr("did you mean 'quarter_sine'?"));
}

}  // namespace
}  // namespace phs
