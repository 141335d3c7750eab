// Every verb on every kind of bogie: the product's, one of standard gauge with an undriven axle and
// nothing of the product's settings, one with cylinders on slide joints; and what cannot run is
// refused in one line, never by a crash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct BogieCase {
  const char* name;
  std::string bogie;
  std::string straight;  ///< track
  std::string curve;
};
void PrintTo(const BogieCase& c, std::ostream* out) { *out << c.name; }

const std::string kTests = PHS_SOURCE_DIR "/tests/vehicle/bogies/";

class EveryVerb : public testing::TestWithParam<BogieCase> {
 protected:
  std::string Path(const std::string& name) const { return dir_.File(name); }
  static Output Run(const std::string& arguments) {
    const Output out = ExecutePhs(arguments);
    EXPECT_EQ(out.code, 0) << arguments << "\n" << out.text;
    return out;
  }
  bool Holds(const std::string& file, const std::string& words) const {
    std::ifstream in(Path(file));
    std::stringstream text;
    text << in.rdbuf();
    return text.str().find(words) != std::string::npos;
  }
  std::string Scenario(const std::string& track) const {
    return dir_.Write("scenario.yaml", "track: " + track + "\nbogie: " + GetParam().bogie +
                                           "\nspeed_m_s: 15\nduration_s: 0.3\n");
  }
  ScratchDir dir_;
};

TEST_P(EveryVerb, SimulateAndReport) {
  Run("simulate " + Scenario(GetParam().straight) + " --quiet --out " + Path("out"));
  EXPECT_TRUE(Holds("out/summary.json", "\"status\": \"ok\""));
  std::filesystem::remove(Path("out/report.html"));
  Run("report " + Path("out"));
  EXPECT_TRUE(std::filesystem::exists(Path("out/report.html")));
}

TEST_P(EveryVerb, CompareWithTrackStepAndFrictionOfItsOwn) {
  Run("compare " + Scenario("straight") + " --quiet --bogies " + GetParam().bogie + " --track " +
      GetParam().straight + " --timestep 0.0004 --friction wet --out " + Path("out"));
  EXPECT_TRUE(Holds("out/compare.json", "\"timestep_s\": 0.0004"));
  EXPECT_TRUE(Holds("out/compare.json", "\"friction_condition\": \"wet\""));
}

TEST_P(EveryVerb, Modes) {
  const std::string modes = "modes --bogie " + GetParam().bogie;
  EXPECT_THAT(Run(modes).text, HasSubstr("bending"));
  Run(modes + " --track " + GetParam().curve + " --timestep 0.0005 --out " + Path("out"));
}

TEST_P(EveryVerb, Loads) {
  const std::string loads = "loads --bogie " + GetParam().bogie;
  EXPECT_THAT(Run(loads).text, HasSubstr("kN per box"));
  Run(loads + " --track " + GetParam().straight + " --timestep 0.0005");
}

TEST_P(EveryVerb, Stability) {
  const std::string stability =
      "stability --quiet --speeds 3 --from 10 --to 30 --bogie " + GetParam().bogie;
  EXPECT_THAT(Run(stability).text, HasSubstr("linear stability"));
  Run(stability + " --track " + GetParam().straight + " --friction dry");
}

TEST_P(EveryVerb, CurvingOnItsOwnGauge) {
  const std::string curving = "curving --quiet --bogies " + GetParam().bogie;
  Run(curving + " --radii 600 --friction 0.35 --out " + Path("family"));
  EXPECT_TRUE(Holds("family/curving.json", "\"status\": \"ok\""));
  const bool wide = GetParam().straight != "straight";
  EXPECT_TRUE(Holds("family/curving.json", wide ? "\"gauge_m\": 1.435" : "\"gauge_m\": 1.067"));
  Run(curving + " --track " + GetParam().curve + " --timestep 0.0005 --out " + Path("own"));
  EXPECT_TRUE(Holds("own/curving.json", wide ? "\"radius_m\": 400" : "\"radius_m\": 300"));
}

TEST_P(EveryVerb, Sweep) {
  const std::string study =
      dir_.Write("study.yaml", "scenario: " + Scenario(GetParam().straight) +
                                   "\naxes:\n  - {key: scenario.speed_m_s, values: [12, 15]}\n"
                                   "outputs: [run.max_sum_Y_N]\n");
  Run("sweep " + study + " --quiet --out " + Path("out"));
  EXPECT_TRUE(std::filesystem::exists(Path("out/sweep.csv")));
}

/// The options reach the program that draws as they were given, also those that look like others.
TEST_P(EveryVerb, Video) {
  if (!std::filesystem::exists(PHS_BINARY_DIR "/src/screen/phs-view")) {
    GTEST_SKIP() << "phs-view is not built here";
  }
  const std::string picture = Path("a b.png");
  Run("video " + Scenario(GetParam().straight) + " '" + picture +
      "' --width 320 --height 180 --camera top --magnify-yaw 1e1 --no-forces --quiet");
  EXPECT_GT(std::filesystem::file_size(picture), 5000u);
}

INSTANTIATE_TEST_SUITE_P(Bogies, EveryVerb,
                         testing::Values(BogieCase{"shipped", "phs", "straight", "curve_r300"},
                                         BogieCase{"standard_gauge", kTests + "standard_gauge.xml",
                                                   kTests + "standard_straight.yaml",
                                                   kTests + "standard_r400.yaml"},
                                         BogieCase{"slide_joints", kTests + "phs_on_slides.xml",
                                                   "straight", "curve_r300"}),
                         [](const auto& info) { return std::string(info.param.name); });

/// One clear line, the right code, no crash.
void ExpectRefused(const std::string& arguments, const testing::Matcher<std::string>& says,
                   int code = 3) {
  const Output out = ExecutePhs(arguments);
  EXPECT_EQ(out.code, code) << arguments << "\n" << out.text;
  EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
  EXPECT_THAT(out.text, says) << arguments;
}

TEST(EveryVerbRefuses, ModelsWithoutWheelsets) {
  const ScratchDir dir;
  const std::string bare =
      dir.Write("bare.xml",
                "<mujoco><worldbody><body name='frame'><freejoint/><geom size='1'/></body>"
                "</worldbody></mujoco>");
  const std::string scenario =
      dir.Write("s.yaml", "track: straight\nspeed_m_s: 20\nduration_s: 0.1\nbogie: bare.xml\n");
  const auto says = AllOf(HasSubstr("bare.xml"), HasSubstr("names no wheelset"));
  ExpectRefused("simulate --quiet " + scenario, says);
  ExpectRefused("compare --quiet curve_r300 --bogies " + bare, says);
  for (const char* verb : {"modes --bogie ", "loads --bogie ", "stability --quiet --bogie ",
                           "curving --quiet --format json --bogies "}) {
    ExpectRefused(verb + bare, says);
  }
}

TEST(EveryVerbRefuses, ATrackOfAnotherGaugeWithBothNumbers) {
  const std::string wide = kTests + "standard_gauge.xml";
  const auto says = AllOf(HasSubstr("1.36 m"), HasSubstr("gauge of 1.067 m"));
  for (const char* verb : {"modes --bogie ", "loads --bogie ", "stability --quiet --bogie ",
                           "curving --quiet --format json --radii 400 --bogies ",
                           "compare --quiet curve_r300 --bogies "}) {
    ExpectRefused(verb + wide + " --track straight", says);
  }
}

TEST(EveryVerbRefuses, PicturesWhereTheProgramThatDrawsIsMissing) {
  const ScratchDir dir;
  std::filesystem::copy_file(PHS_BINARY_DIR "/src/cli/phs", dir.File("phs"));
  const Output out = Execute(dir.File("phs") + " video straight " + dir.File("x.png"));
  EXPECT_EQ(out.code, 3);
  EXPECT_THAT(out.text, AllOf(HasSubstr("phs-view"), HasSubstr("scripts/install_packages")));
  EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
}

TEST(EveryVerbRefuses, FrictionThatIsNeitherNumberNorCondition) {
  for (const char* verb : {"stability --bogie phs", "curving --bogies phs", "simulate straight"}) {
    ExpectRefused(std::string(verb) + " --friction damp",
                  AllOf(HasSubstr("--friction"), HasSubstr("dry, wet")), 2);
    ExpectRefused(std::string(verb) + " --friction 3", HasSubstr("0.01 … 1"), 2);
  }
}

/// The Cooperrider bogie runs on a slide, without drives, at 0.2 ms by its own file.
TEST(EveryVerbOnCooperrider, RunsAtItsOwnStepOrSaysWhyNot) {
  ExpectRefused("modes --bogie cooperrider", HasSubstr("no free joint"));
  const Output stability = ExecutePhs(
      "stability --quiet --speeds 3 --from 50 --to 80 "
      "--bogie cooperrider");
  EXPECT_EQ(stability.code, 0) << stability.text;
  const ScratchDir dir;
  const std::string scenario =
      dir.Write("s.yaml", "track: straight\nspeed_m_s: 20\nduration_s: 0.1\nbogie: cooperrider\n");
  const Output run = ExecutePhs("simulate --quiet --format json " + scenario);
  EXPECT_EQ(run.code, 0) << run.text;
  EXPECT_THAT(run.text, HasSubstr("\"timestep_s\": 0.0002"));
  const Output curving = ExecutePhs("curving --quiet --bogies cooperrider --radii 1000");
  EXPECT_EQ(curving.code, 1) << curving.text;
  EXPECT_THAT(curving.text, HasSubstr("no free joint at its root"));
}

/// Scenario, study and manifest name their files from their own folder, wherever phs is called.
TEST(EveryVerbPaths, BeginInTheFolderOfTheFileThatNamesThem) {
  const ScratchDir dir;
  namespace fs = std::filesystem;
  fs::create_directory(dir.File("own"));
  fs::copy_file(kTests + "standard_straight.yaml", dir.File("own/wide.yaml"));
  fs::copy_file(PHS_SOURCE_DIR "/models/phs/single_cylinder.yaml", dir.File("own/mine.yaml"));
  dir.Write("own/s.yaml", "track: wide.yaml\nbogie: " + kTests +
                              "standard_gauge.xml\nspeed_m_s: 15\nduration_s: 0.2\n");
  dir.Write("own/study.yaml",
            "scenario: s.yaml\naxes:\n  - {key: scenario.track, values: [wide.yaml]}\n"
            "  - {key: scenario.speed_m_s, values: [12, 15]}\noutputs: [run.max_sum_Y_N]\n");
  dir.Write("own/rig.yaml",
            "rig: cylinder\nmodel: mine.yaml\nsignal:\n  duration_s: 5\n  sample_s: 0.01\n"
            "  actuator_m: {kind: ramp, amplitude_m: 1.0e-4, speed_m_s: -5.0e-5, start_s: 1}\n");
  const std::string here = "cd / && ";
  for (const char* call :
       {"simulate own/s.yaml --quiet --out own/a", "sweep own/study.yaml --quiet --out own/b",
        "rig own/rig.yaml --quiet --out own/c"}) {
    std::string absolute = call;
    for (size_t at = 0; (at = absolute.find("own/", at)) != std::string::npos;
         at += dir.path().size() + 5) {
      absolute.insert(at, dir.path() + "/");
    }
    const Output out = Execute(here + PhsCommand(absolute));
    EXPECT_EQ(out.code, 0) << absolute << "\n" << out.text;
  }
}

TEST(EveryVerbImports, ABogieForStandardGauge) {
  const ScratchDir dir;
  std::ifstream file(PHS_SOURCE_DIR "/models/urdf/bogie_19e_phs.yaml");
  std::stringstream text;
  text << file.rdbuf();
  const std::string mapping = dir.Write("map.yaml", text.str() + "\nflange_back_m: 1.36\n");
  const std::string call = "import " PHS_SOURCE_DIR "/models/urdf/bogie_19e.urdf --mapping " +
                           mapping + " --out " + dir.File("made");
  ExpectRefused(call, AllOf(HasSubstr("1.36 m"), HasSubstr("gauge of 1.067 m")));
  const Output made =
      ExecutePhs(call + " --track " + kTests + "standard_straight.yaml --timestep 0.0005");
  EXPECT_EQ(made.code, 0) << made.text;
  std::stringstream written;
  written << std::ifstream(dir.File("made/bogie_19e_phs.xml")).rdbuf();
  EXPECT_THAT(written.str(), AllOf(HasSubstr("timestep=\"0.0005\""),
                                   HasSubstr("standard_straight.yaml"), HasSubstr("1.36")));
  const Output loads = ExecutePhs("loads --bogie " + dir.File("made/bogie_19e_phs.xml"));
  EXPECT_EQ(loads.code, 0) << loads.text;
}

}  // namespace
}  // namespace phs
