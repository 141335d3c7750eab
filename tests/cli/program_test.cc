// The program from outside: exit codes, one clear line per error, results complete or absent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "base/result_dir.h"
#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class ProgramTest : public testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text) const {
    return dir_.Write(name, text);
  }
  std::string Path(const std::string& name) const { return dir_.File(name); }
  /// A scenario that differs from a short straight run by the lines given.
  std::string Scenario(const std::string& lines) const {
    return Write("scenario.yaml", "speed_km_h: 60\nduration_s: 0.2\n" + lines);
  }
  /// Runs a scenario that must fail; nothing may be left of its result.
  void ExpectRefused(const std::string& scenario, int code, const std::string& words) const {
    const Output out = ExecutePhs("simulate " + scenario + " --quiet --out " + Path("out"));
    EXPECT_EQ(out.code, code) << out.text;
    EXPECT_THAT(out.text, HasSubstr(words));
    if (code == 3) {
      EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
      for (const auto& entry : fs::directory_iterator(dir_.path())) {
        EXPECT_THAT(entry.path().string(), testing::Not(HasSubstr("/out")));
      }
    }
  }
  ScratchDir dir_;
};

TEST_F(ProgramTest, WrongUsageIsExitCodeTwo) {
  EXPECT_EQ(ExecutePhs("").code, 2);
  EXPECT_EQ(ExecutePhs("simulat curve_r550").code, 2);
  EXPECT_EQ(ExecutePhs("simulate curve_r550 --no-such-option").code, 2);
  EXPECT_EQ(ExecutePhs("--help").code, 0);
  EXPECT_EQ(ExecutePhs("simulate --help").code, 0);
  EXPECT_THAT(ExecutePhs("--version").text, HasSubstr("phs "));
}

// "nan" was taken for "not given", and a step of a nanosecond ran for days.
TEST_F(ProgramTest, ANumberOfAnOptionIsFiniteAndWithinWhatItMayBe) {
  for (const char* step : {"nan", "inf", "0", "1e-9", "-1e-3", "1", "1ms"}) {
    for (const char* verb : {"simulate curve_r300", "stability --ramp", "modes"}) {
      const Output out = ExecutePhs(std::string(verb) + " --timestep " + step);
      EXPECT_EQ(out.code, 2) << verb << " " << step;
      EXPECT_THAT(out.text, HasSubstr(std::string("is ") + step + "; allowed: 1e-06 … 0.05"));
      EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
    }
  }
  EXPECT_THAT(ExecutePhs("compare curve_r300 --radii 300,0").text,
              HasSubstr("is 0; allowed: 1 … 1e+07"));
  EXPECT_EQ(ExecutePhs("alarms line_a --wanted nan").code, 2);
}

// They wrote their whole result some twenty seconds later, with exit code 0.
TEST_F(ProgramTest, CtrlCStopsWhatTakesLong) {
  for (const char* verb : {"curving --bogies phs,rigid_link,soft_link --time-run",
                           "identify steps_joint --quiet", "identify hidden_pair --quiet"}) {
    const Output out = Execute("timeout --preserve-status -s INT 2 " +
                               PhsCommand(std::string(verb) + " --out " + Path("stopped")));
    EXPECT_EQ(out.code, 130) << verb << "\n" << out.text;
    EXPECT_THAT(NamesIn(dir_.path()), testing::IsEmpty()) << verb;
  }
}

TEST_F(ProgramTest, AMistypedVerbIsAnsweredWithTheNearest) {
  for (const auto& [asked, meant] : {std::pair{"simulat curve_r550", "simulate"},
                                     {"Curving", "curving"},
                                     {"stabilty --bogie phs", "stability"}}) {
    const Output out = ExecutePhs(asked);
    EXPECT_EQ(out.code, 2) << asked;
    EXPECT_THAT(out.text, HasSubstr("did you mean '" + std::string(meant) + "'?"));
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
  }
  EXPECT_THAT(ExecutePhs("zzzzzzzz").text, HasSubstr("simulate, compare"));
}

/// Names under "Subcommands:" of phs --help.
std::vector<std::string> Verbs() {
  std::vector<std::string> verbs;
  std::istringstream lines(ExecutePhs("--help").text);
  bool begun = false;
  for (std::string line; std::getline(lines, line);) {
    if (begun && line.size() > 2 && line[2] != ' ') {
      verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    begun = begun || line == "Subcommands:";
  }
  return verbs;
}

TEST_F(ProgramTest, EveryVerbHasARowInItsDocument) {
  std::ifstream file(PHS_SOURCE_DIR "/docs/program.md");
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  EXPECT_GE(Verbs().size(), 13u);
  for (const std::string& verb : Verbs()) {
    EXPECT_THAT(document, HasSubstr("\n| `" + verb + " "));
    EXPECT_THAT(document, HasSubstr("\n### `phs " + verb + "`\n"));
  }
}

TEST_F(ProgramTest, UnknownNamesAreBadInput) {
  ExpectRefused("no_such_scenario", 3, "curve_r550");
  ExpectRefused(Scenario("track: straight\nbogie: rigid_lnk\n"), 3, "did you mean 'rigid_link'");
  ExpectRefused(Scenario("track: strait\n"), 3, "did you mean 'straight'");
  ExpectRefused(Scenario("track: straight\nwheel: S1003\n"), 3, "S1002");
  ExpectRefused(Scenario("track: straight\nspeeed: 3\n"), 3, "speeed");
  ExpectRefused(Scenario("track: straight\nphs: bo_bb\n"), 3, "bo_bo");
}

// A burst hose of a bogie that has none ran in silence, and so did a name written wrongly.
TEST_F(ProgramTest, WhatIsSaidOfAPhsThatNoBogieHasIsCheckedAndNamed) {
  const std::string rigid = "track: straight\nbogie: rigid_link\n";
  ExpectRefused(Scenario(rigid + "phs: bo_bb\n"), 3, "bo_bo");
  ExpectRefused(Scenario(rigid + "phs_parameters: {friction.scal: 1}\n"), 3, "friction.scale");
  ExpectRefused(Scenario(rigid + "failures: [{kind: line_burst, line: L9, at_s: 0.1}]\n"), 3, "L9");
  const std::string unused = Scenario(rigid +
                                      "phs_parameters: {friction.scale: 2}\n"
                                      "failures: [{kind: line_burst, line: L1, at_s: 0.1}]\n");
  const Output out = ExecutePhs("simulate " + unused + " --quiet --out " + Path("out"));
  EXPECT_EQ(out.code, 0) << out.text;
  EXPECT_THAT(out.text, HasSubstr("! no bogie of this run has a PHS: without effect here: "
                                  "phs_parameters, failures"));
  const Output both =
      ExecutePhs("compare " + unused + " --bogies phs,rigid_link --quiet --out " + Path("both"));
  EXPECT_EQ(both.code, 0) << both.text;
  EXPECT_THAT(both.text, testing::Not(HasSubstr("without effect")));
}

TEST_F(ProgramTest, BrokenFilesAreBadInputWithPlace) {
  const std::string profile = Write("broken.prw", "1 2\n3 x\n");
  ExpectRefused(Scenario("track: straight\nwheel: " + profile + "\n"), 3, "broken.prw");
  const std::string jump = Write("jump.yaml",
                                 "name: jump\nsegments:\n  - {kind: tangent, length_m: 50}\n"
                                 "  - {kind: curve, radius_m: 300, hand: left, length_m: 50}\n"
                                 "  - {kind: tangent, length_m: 50}\n");
  ExpectRefused(Scenario("track: " + jump + "\n"), 3, "jump.yaml");
  const std::string soft = Write("soft.yaml",
                                 "name: s\nsupport: {vertical_stiffness_N_per_m: -1}\n"
                                 "segments:\n  - {kind: tangent, length_m: 50}\n");
  ExpectRefused(Scenario("track: " + soft + "\n"), 3, "vertical_stiffness_N_per_m");
  const std::string bogie = Write("bogie.xml", "<mujoco><worldbody><bdy/></worldbody></mujoco>");
  ExpectRefused(Scenario("track: straight\nbogie: " + bogie + "\n"), 3, "bogie.xml");
}

TEST_F(ProgramTest, ACylinderThatTheModelLacksIsNamed) {
  const std::string bogie =
      Write("bogie.xml",
            "<mujoco><worldbody><body><joint name='j'/><geom size='1'/></body></worldbody><custom>"
            "<tuple name='phs:x'><element objtype='actuator' "
            "objname='cylinder_9'/></tuple></custom></mujoco>");
  ExpectRefused(Scenario("track: straight\nbogie: " + bogie + "\n"), 3, "cylinder");
}

TEST_F(ProgramTest, AStepTooLargeForTheStiffnessIsRefused) {
  ExpectRefused(Scenario("track: straight\nbogie: rigid_link\ntimestep_s: 0.02\n"), 3,
                "timestep_s");
}

TEST_F(ProgramTest, DerailingIsExitCodeOneAndTheResultSaysWhy) {
  const std::string scenario =
      Write("fast.yaml", "track: curve_r150\nbogie: rigid_link\nspeed_km_h: 160\n");
  const Output out = ExecutePhs("simulate " + scenario + " --quiet --out " + Path("out"));
  EXPECT_EQ(out.code, 1) << out.text;
  EXPECT_THAT(out.text, HasSubstr("derailed"));
  EXPECT_TRUE(fs::exists(Path("out/summary.json")));
}

TEST_F(ProgramTest, ResultsAreCompleteAndNeverOverwrittenSilently) {
  const std::string scenario = Scenario("track: straight\n");
  ASSERT_EQ(ExecutePhs("simulate " + scenario + " --quiet --csv --out " + Path("out")).code, 0);
  for (const char* file : {"summary.json", "timeseries.h5", "timeseries.csv", "report.html"}) {
    EXPECT_TRUE(fs::exists(Path(std::string("out/") + file))) << file;
  }
  const Output again = ExecutePhs("simulate " + scenario + " --quiet --out " + Path("out"));
  EXPECT_EQ(again.code, 3);
  EXPECT_THAT(again.text, HasSubstr("--force"));
  EXPECT_EQ(ExecutePhs("simulate " + scenario + " --quiet --force --out " + Path("out")).code, 0);
}

TEST_F(ProgramTest, TheSameInputsGiveTheSameBytes) {
  const std::string scenario = Scenario("track: curve_r250\nstart_s_m: 60\n");
  ASSERT_EQ(ExecutePhs("simulate " + scenario + " --quiet --csv --out " + Path("a")).code, 0);
  ASSERT_EQ(ExecutePhs("simulate " + scenario + " --quiet --csv --out " + Path("b")).code, 0);
  EXPECT_EQ(Execute("cmp " + Path("a/timeseries.csv") + " " + Path("b/timeseries.csv")).code, 0);
}

TEST_F(ProgramTest, TheHalfStepStandsBesideWhenAsked) {
  const std::string scenario = Scenario("track: straight\n");
  const Output verified =
      ExecutePhs("simulate " + scenario + " --verify --quiet --out " + Path("verified"));
  ASSERT_EQ(verified.code, 0) << verified.text;
  EXPECT_THAT(verified.text, HasSubstr("at 1 ms against 0.5 ms step"));
  EXPECT_THAT(verified.text, HasSubstr("of the largest magnitude in the run"));
  const auto with = Json::parse(ReadFile(Path("verified/summary.json")).value());
  ASSERT_EQ(
      ExecutePhs("simulate " + scenario + " --timestep 0.0005 --quiet --out " + Path("half")).code,
      0);
  const auto half = Json::parse(ReadFile(Path("half/summary.json")).value());
  const Json& change = with["discretisation"]["changes"]["run.T_gamma_total_J"];
  EXPECT_EQ(change["value"], with["run"]["T_gamma_total_J"]);
  EXPECT_EQ(change["half_step"], half["run"]["T_gamma_total_J"]);
  EXPECT_NE(change["value"], change["half_step"]);
  EXPECT_EQ(with["discretisation"]["timestep_s"], with["timestep_s"]);
  EXPECT_THAT(ReadFile(Path("verified/report.html")).value(), HasSubstr("What the step changes"));
  const Output compared =
      ExecutePhs("compare " + scenario + " --bogies phs,rigid_link --verify --quiet --format json");
  ASSERT_EQ(compared.code, 0) << compared.text;
  const auto both = Json::parse(compared.text);
  EXPECT_EQ(both["bogies"].size(), 2U);
  EXPECT_TRUE(
      both["bogies"]["rigid_link"]["discretisation"]["changes"].contains("run.max_sum_Y_N"));
  EXPECT_TRUE(
      both["discretisation"]["changes"].contains("phs_over_rigid_link.run.T_gamma_total_J"));
}

TEST_F(ProgramTest, FrictionIsANumberOrABlock) {
  const std::string head = "track: straight\nbogie: rigid_link\ncreep: polach\n";
  for (const char* good : {"friction: 0.3\n", "friction: {condition: wet}\n",
                           "friction: {condition: dry_traction, flange: 0.1}\n",
                           "friction: {tread: 0.4, falling_ratio: 0.5, falling_rate_s_m: 0.6}\n"}) {
    const Output out =
        ExecutePhs("simulate " + Scenario(head + good) + " --quiet --force --out " + Path("out"));
    EXPECT_EQ(out.code, 0) << good << out.text;
  }
  fs::remove_all(Path("out"));
  ExpectRefused(Scenario(head + "friction: {condition: damp}\n"), 3, "flange_lubricated");
  ExpectRefused(Scenario(head + "friction: {tread: 3}\n"), 3, "tread");
  ExpectRefused(Scenario(head + "friction: {wheel: 0.3}\n"), 3, "wheel");
}

TEST_F(ProgramTest, TractionAndJointsAreCheckedLikeEverythingElse) {
  const std::string head = "track: straight\n";
  const auto refused = [&](const std::string& lines, const std::string& words) {
    ExpectRefused(Scenario(head + lines), 3, words);
  };
  refused("running: {drive_torque_Nm: 2e6}\n", "running.drive_torque_Nm");
  refused("running: {drive_torque: 5e3}\n", "drive_torque_Nm");
  refused("running: {block_force_N: -1}\n", "block_force_N");
  refused("running: {block_friction: 0}\n", "block_friction");
  refused("running: {ramp_s: 0}\n", "ramp_s");
  refused("running: {begin_s: soon}\n", "begin_s");
  refused("running: {begin_s: 1, ramp_s: 2, end_s: 2.5}\n", "end_s");
  refused("running: 5\n", "running");
  refused("joints: {lead_yow: {stiffness: 1e6}}\n", "lead_yaw");
  refused("joints: {lead_yaw: {stiffness: -1}}\n", "lead_yaw.stiffness");
  refused("joints: {lead_yaw: {stifness: 1}}\n", "stiffness");
  refused("joints: {lead_yaw: {damping: .nan}}\n", "damping");
  refused("joints: lead_yaw\n", "joints");
  refused("joints: {frame_free: {damping: 1}}\n", "frame_free");
}

TEST_F(ProgramTest, TheGridOfACreepLawIsChosenByNumber) {
  EXPECT_EQ(
      ExecutePhs("simulate " + Scenario("track: straight\ncreep: fastsim:10\n") + " --quiet").code,
      0);
  for (const auto& [creep, words] : {std::pair{"fastsim:3", "4 … 200"},
                                     {"fastsim:4.5", "4 … 200"},
                                     {"polach:10", "4 … 200"},
                                     {"fastsims", "fastsim"},
                                     {"", "creep"}}) {
    ExpectRefused(Scenario(std::string("track: straight\ncreep: ") + creep + "\n"), 3, words);
  }
}

TEST_F(ProgramTest, BogiesOverRadiiGiveATableAndAReport) {
  const Output out = ExecutePhs(
      "compare curve_r800 --bogies phs,rigid_link --radii 800 --quiet --out " + Path("radii"));
  EXPECT_EQ(out.code, 0) << out.text;
  EXPECT_THAT(out.text, HasSubstr("R = 800 m, 80 km/h"));
  EXPECT_TRUE(fs::exists(Path("radii/bogies.json")));
  EXPECT_TRUE(fs::exists(Path("radii/report.html")));
  const Output none = ExecutePhs("compare curve_r800 --bogies phs --radii 801 --quiet");
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.text, HasSubstr("curve_r801"));
}

TEST_F(ProgramTest, CriticalSpeedsStandBesideTheCurves) {
  const Output alone = ExecutePhs("compare curve_r800 --bogies emd_radial --stability --quiet");
  EXPECT_EQ(alone.code, 3);
  EXPECT_THAT(alone.text, HasSubstr("--radii"));
  if (std::getenv("PHS_LONG_TESTS") == nullptr) GTEST_SKIP() << "PHS_LONG_TESTS is not set";
  const Output out = ExecutePhs(
      "compare curve_r800 --bogies emd_radial --radii 800 --stability --quiet --format json");
  EXPECT_EQ(out.code, 0) << out.text;
  const auto number = [&](const std::string& key) {
    const size_t at = out.text.find("\"" + key + "\": ");
    return at == std::string::npos ? 0 : std::atof(out.text.c_str() + at + key.size() + 4);
  };
  // Springs alone hold opposite yaw: hunting begins early, and lives on below where it begins.
  EXPECT_GT(number("linear_m_s"), 15);
  EXPECT_LT(number("linear_m_s"), 35);
  EXPECT_GT(number("nonlinear_m_s"), 10);
  EXPECT_LT(number("nonlinear_m_s"), number("linear_m_s"));
}

TEST_F(ProgramTest, AnImportedBogieCanBeSimulated) {
  const std::string urdf = PHS_SOURCE_DIR "/models/urdf/bogie_19e";
  const Output made =
      ExecutePhs("import " + urdf + ".urdf --mapping " + urdf + "_phs.yaml --out " + Path("made"));
  EXPECT_EQ(made.code, 0) << made.text;
  const Output run = ExecutePhs("compare " + Scenario("track: straight\n") + " --quiet --bogies " +
                                Path("made/bogie_19e_phs.xml") + ",phs --out " + Path("out"));
  EXPECT_EQ(run.code, 0) << run.text;
  EXPECT_TRUE(fs::exists(Path("out/bogie_19e_phs_timeseries.h5")));
  const Output wrong = ExecutePhs("import " + urdf + "_phs.yaml --mapping " + urdf +
                                  "_phs.yaml --out " + Path("none"));
  EXPECT_EQ(wrong.code, 3) << wrong.text;
  EXPECT_FALSE(fs::exists(Path("none")));
}

TEST_F(ProgramTest, LoadsSayWhichPartGivesFirst) {
  const Output out = ExecutePhs("loads --bogie phs");
  EXPECT_EQ(out.code, 0) << out.text;
  EXPECT_THAT(out.text, HasSubstr("line L4 blows off"));
  const Output rigid = ExecutePhs("loads --bogie rigid_link");
  EXPECT_EQ(rigid.code, 3);
  EXPECT_THAT(rigid.text, HasSubstr("has no PHS"));
}

/// What `identify` writes on a quarter rig serves every door as it is.
TEST_F(ProgramTest, ModelOfAQuarterRigRunsInTheBogie) {
  std::ifstream declared(PHS_SOURCE_DIR "/models/phs/quarter_setup2.yaml");
  std::stringstream text;
  text << declared.rdbuf();
  const std::string model =
      Write("model.yaml", text.str() +
                              "effects:\n  piston_leakage: {conductance_m3_per_Pas: 1.0e-11}\n"
                              "  viscous_friction: {extension_Ns_per_m: 1.0e5}\n"
                              "  sensor_gain: {load: 1.02}\n");
  const std::string scenario = Scenario("track: curve_r300\nstart_s_m: 75\n");
  const Output own = ExecutePhs("simulate " + scenario +
                                " --bogie phs_declared --quiet --format json --out " + Path("own"));
  const Output same = ExecutePhs(
      "simulate " + scenario + " --phs quarter_setup2 --quiet --format json --out " + Path("same"));
  const Output with = ExecutePhs("simulate " + scenario + " --phs " + model +
                                 " --quiet --format json --out " + Path("with"));
  ASSERT_EQ(own.code, 0) << own.text;
  ASSERT_EQ(same.code, 0) << same.text;
  ASSERT_EQ(with.code, 0) << with.text;
  // The declared quarter rig spread over four cylinders is the declared bogie's own model.
  const auto figure = [](const Output& out) {
    const size_t at = out.text.find("T_gamma_total_J");
    return out.text.substr(at, 40);
  };
  EXPECT_EQ(figure(own), figure(same));
  EXPECT_NE(figure(own), figure(with));
  const Output compared = ExecutePhs("compare " + scenario + " --quiet --bogies phs,phs@" + model +
                                     ",rigid_link --out " + Path("compared"));
  EXPECT_EQ(compared.code, 0) << compared.text;
  EXPECT_THAT(compared.text, HasSubstr("phs@model"));
  EXPECT_TRUE(fs::exists(Path("compared/report.html")));
  EXPECT_EQ(
      ExecutePhs("simulate " + Scenario("track: curve_r300\nphs: " + model + "\n") + " --quiet")
          .code,
      0);
  const std::string rig = Write("rig.yaml", "rig: quarter\nmodel: " + model +
                                                "\nsignal:\n  duration_s: 2\n  sample_s: 0.01\n"
                                                "  actuator_m: {kind: sine, amplitude_m: 1.0e-3, "
                                                "frequency_Hz: 1}\n");
  const Output run = ExecutePhs("rig " + rig + " --quiet --out " + Path("rig"));
  EXPECT_EQ(run.code, 0) << run.text;
#ifndef PHS_SANITIZED  // preloaded, a sanitizer's own library would have to come first
  // The plugin: an effect without a state of its own (states beyond the file's need carriers).
  const std::string plain = Write(
      "plain.yaml", text.str() + "effects:\n  viscous_friction: {extension_Ns_per_m: 1.0e5}\n");
  const Output plugin =
      Execute("LD_PRELOAD=" PHS_BINARY_DIR "/plugin/libphs_mujoco.so PHS_OPTIONS='phs=" + plain +
              "' " PHS_BINARY_DIR "/tests/foreign_host " PHS_SOURCE_DIR "/bogie_xml/phs.xml 20");
  EXPECT_EQ(plugin.code, 0) << plugin.text;
#endif
}

}  // namespace
}  // namespace phs
