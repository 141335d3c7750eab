// What the program adds to a bogie's file, what it finds beside it, and which step it takes; and
// the same bogie with its cylinders on slide joints.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "analysis/axle_modes.h"
#include "analysis/load_cases.h"
#include "phs_places.h"
#include "tests/base/scratch_dir.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr char kBogies[] = PHS_SOURCE_DIR "/tests/vehicle/bogies/";

Scenario On(const std::string& bogie, const std::string& track, double speed = 20) {
  Scenario s;
  s.name = "needs";
  s.bogie = bogie;
  s.track = track;
  s.speed_m_s = speed;
  s.friction.tread = 0.35;
  return s;
}

/// A test bogie's text with every `from` replaced by `to`, its includes found from anywhere.
std::string Changed(const std::string& name, const std::string& from, const std::string& to) {
  std::ifstream file(kBogies + name);
  std::stringstream text;
  text << file.rdbuf();
  std::string out = text.str();
  const auto replace = [&](const std::string& a, const std::string& b) {
    size_t at = out.find(a);
    EXPECT_NE(at, std::string::npos) << a;
    for (; at != std::string::npos; at = out.find(a, at + b.size())) out.replace(at, a.size(), b);
  };
  replace("shared/", PHS_SOURCE_DIR "/bogie_xml/shared/");
  if (!from.empty()) replace(from, to);
  return out;
}

double StepOf(const Scenario& s) {
  const auto simulation = Simulation::Create(s);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  if (!simulation.ok()) return 0;
  EXPECT_EQ(simulation.value().scenario().timestep_s, simulation.value().model()->opt.timestep);
  return simulation.value().model()->opt.timestep;
}

TEST(BogieNeedsTest, TheStepIsTheScenariosElseTheFilesElseOneMillisecond) {
  const ScratchDir dir;
  const std::string track = std::string(kBogies) + "standard_straight.yaml";
  Scenario s = On(std::string(kBogies) + "standard_gauge.xml", track);
  EXPECT_EQ(StepOf(s), 5e-4) << "the file's";
  s.timestep_s = 2e-4;
  EXPECT_EQ(StepOf(s), 2e-4) << "the scenario's";
  s.timestep_s = 0;
  s.bogie = dir.Write("no_step.xml", Changed("standard_gauge.xml", "timestep=\"0.0005\"", ""));
  EXPECT_EQ(StepOf(s), kDefaultStep_s) << "nobody's";
}

TEST(BogieNeedsTest, KeyRoomAndTrackThatTheFileLacksAreSuppliedByTheProgram) {
  // standard_gauge.xml has no key, no userdata, and names a track that lies beside it.
  Scenario s = On(std::string(kBogies) + "standard_gauge.xml", "");
  s.duration_s = 0.5;
  auto simulation = Simulation::Create(s);
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  EXPECT_EQ(simulation.value().binding().track().name(), "standard_straight");
  EXPECT_EQ(simulation.value().binding().wheel_rail().params().flange_back_distance, 1.360);
  EXPECT_GE(mj_name2id(simulation.value().model(), mjOBJ_KEY, "test"), 0);
  const auto run = simulation.value().Run();
  ASSERT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "ok") << run.value().reason;
  const auto& load = run.value().columns[static_cast<size_t>(run.value().Find("lead_left_Q_N"))];
  EXPECT_NEAR(load.back(), 34200 * 9.81 / 4, 100);
}

TEST(BogieNeedsTest, MeshesBesideTheFileAreStillFound) {
  const ScratchDir dir;
  std::filesystem::create_directory(dir.File("shapes"));
  std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  dir.Write("shapes/box.obj", tetrahedron + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string bogie = dir.Write(
      "mesh.xml", Changed("standard_gauge.xml", "autolimits=\"false\"/>",
                          "autolimits=\"false\" meshdir=\"shapes\"/><asset><mesh name=\"box\" "
                          "file=\"box.obj\"/></asset>"));
  const auto simulation =
      Simulation::Create(On(bogie, std::string(kBogies) + "standard_straight.yaml"));
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
}

TEST(BogieNeedsTest, WithoutWheelsetsOrOnAnotherGaugeItIsRefusedInOneLine) {
  const ScratchDir dir;
  const std::string bare =
      dir.Write("bare.xml",
                "<mujoco><worldbody><body name='frame'><freejoint/><geom size='1'/></body>"
                "</worldbody></mujoco>");
  const auto none = Simulation::Create(On(bare, "straight"));
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().Line(), AllOf(HasSubstr("bare.xml"), HasSubstr("names no wheelset")));
  const auto narrow =
      Simulation::Create(On(std::string(kBogies) + "standard_gauge.xml", "straight"));
  ASSERT_FALSE(narrow.ok());
  EXPECT_THAT(narrow.error().Line(), AllOf(HasSubstr("1.36 m"), HasSubstr("1.067 m")));
}

// MuJoCo reads it as a number; the vehicle had found no rest "with its wheel radius and gauge".
TEST(BogieNeedsTest, ANumberThatIsNoneIsNamed) {
  const ScratchDir dir;
  for (const auto& [from, what] :
       {std::pair{"stiffness=\"8.0e6\"", "stiffness"}, {"damping=\"4.0e4\"", "damping"}}) {
    const std::string key = std::string(from).substr(0, std::string(from).find('='));
    const std::string bad =
        dir.Write("bad.xml", Changed("standard_gauge.xml", from, key + "=\"nan\""));
    const auto simulation = Simulation::Create(On(bad, "straight"));
    ASSERT_FALSE(simulation.ok()) << from;
    EXPECT_THAT(simulation.error().Line(),
                AllOf(HasSubstr("bad.xml"), HasSubstr(what), HasSubstr("that is no number")));
  }
}

TEST(BogieNeedsTest, PathsOfAScenarioBeginInItsFolder) {
  const ScratchDir dir;
  dir.Write("t.yaml", "gauge_m: 1.067\nname: beside\nsegments: [{kind: tangent, length_m: 90}]\n");
  const std::string file =
      dir.Write("s.yaml", "track: t.yaml\nbogie: phs\nwheel: cone:1/40\nspeed_m_s: 20\n");
  const auto loaded = LoadScenario(file);
  ASSERT_TRUE(loaded.ok()) << loaded.error().Line();
  EXPECT_EQ(loaded.value().track, dir.File("t.yaml"));
  EXPECT_EQ(loaded.value().bogie, "phs") << "a bare name is a shipped one";
  EXPECT_EQ(loaded.value().wheel, "cone:1/40") << "not a file";
  const auto lost = LoadScenario(dir.Write("u.yaml", "track: none.yaml\nspeed_m_s: 20\n"));
  ASSERT_TRUE(lost.ok());
  EXPECT_EQ(lost.value().track, "none.yaml") << "looked up from the current folder next";
}

RunOutcome RunFinished(const Scenario& s) {
  auto simulation = Simulation::Create(s);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  if (!simulation.ok()) return {};
  auto run = simulation.value().Run();
  EXPECT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "ok") << run.value().reason;
  return std::move(run).value();
}

const std::vector<double>& Column(const RunOutcome& run, const std::string& name) {
  static const std::vector<double> none = {0};
  const int at = run.Find(name);
  EXPECT_GE(at, 0) << name;
  return at < 0 ? none : run.columns[static_cast<size_t>(at)];
}

double Largest(const std::vector<double>& a) {
  double largest = 0;
  for (const double x : a) largest = std::max(largest, std::abs(x));
  return largest;
}
double LargestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

/// The slide leaves out that a tendon lengthens with y and z too, by 15 um here: 200 N of 3600.
TEST(SlideCylindersTest, TheSameBogieInACurveHasTheSameForces) {
  const auto curve = [](const std::string& bogie) {
    Scenario s = On(bogie, "curve_r300", 15);
    s.start_s_m = 60;
    s.duration_s = 8;
    return RunFinished(s);
  };
  const RunOutcome tendons = curve("phs");
  const RunOutcome slides = curve(std::string(kBogies) + "phs_on_slides.xml");
  for (const char* i : {"1", "2", "3", "4"}) {
    const std::string name = std::string("cylinder_") + i;
    const auto& force = Column(tendons, name + "_force_N");
    EXPECT_LT(LargestDifference(force, Column(slides, name + "_force_N")), 0.07 * Largest(force))
        << name;
    const auto& piston = Column(tendons, name + "_piston_m");
    EXPECT_LT(LargestDifference(piston, Column(slides, name + "_piston_m")), 0.01 * Largest(piston))
        << name;
  }
  for (const char* line : {"line_L1_pressure_Pa", "line_L2_pressure_Pa"}) {
    EXPECT_LT(LargestDifference(Column(tendons, line), Column(slides, line)), 2e4) << line;
  }
  const auto& q = Column(tendons, "lead_right_Q_N");
  EXPECT_LT(LargestDifference(q, Column(slides, "lead_right_Q_N")), 3e-3 * Largest(q));
  EXPECT_LT(std::abs(slides.energy.RelativeError()), 5e-3);
  EXPECT_GT(slides.energy.lost_phs, 0.5 * tendons.energy.lost_phs);
}

TEST(SlideCylindersTest, ModesLoadsFailuresAndTheLocomotiveReadThem) {
  const std::string bogie = std::string(kBogies) + "phs_on_slides.xml";
  const auto own = Simulation::Create(On(bogie, "straight"));
  const auto shipped = Simulation::Create(On("phs", "straight"));
  ASSERT_TRUE(own.ok()) << own.error().Line();
  const auto modes = analysis::MeasureAxleModes(own.value(), {});
  const auto reference = analysis::MeasureAxleModes(shipped.value(), {});
  ASSERT_TRUE(modes.ok()) << modes.error().Line();
  // Along the track both have the same coordinates.
  for (const size_t i : {2u, 3u}) {
    EXPECT_NEAR(modes.value().large[i].stiffness / reference.value().large[i].stiffness, 1, 1e-3);
    EXPECT_NEAR(
        modes.value().small[i].closed_form.total() / reference.value().small[i].closed_form.total(),
        1, 1e-3);
  }
  EXPECT_EQ(modes.value().plan.cylinders.size(), 4u);
  EXPECT_NEAR(modes.value().plan.cylinders[0].from[0], reference.value().plan.cylinders[0].from[0],
              1e-9);
  const auto loads = analysis::CalcLoadCases(own.value(), {{"pull", "traction", 10e3, ""}});
  ASSERT_TRUE(loads.ok()) << loads.error().Line();
  Scenario s = On(bogie, "straight");
  s.vehicle = "locomotive";
  s.duration_s = 0.6;
  s.phs_changes.failures = {
      {.kind = "line_burst", .line = "L1", .system = "rear_bogie", .at_s = 0.1}};
  const RunOutcome run = RunFinished(s);
  EXPECT_LT(Column(run, "rear_bogie_line_L1_pressure_Pa").back(), 5e5);
  EXPECT_GT(Column(run, "front_bogie_line_L1_pressure_Pa").back(), 1.9e6);
}

TEST(FailuresTest, ASystemThatTheVehicleDoesNotHaveIsRefusedWithTheNames) {
  Scenario s = On("phs", "straight");
  s.vehicle = "locomotive";
  s.phs_changes.failures = {{.kind = "air", .line = "L1", .system = "rear"}};
  const auto simulation = Simulation::Create(s);
  ASSERT_FALSE(simulation.ok());
  EXPECT_THAT(simulation.error().Line(),
              AllOf(HasSubstr("system 'rear'"), HasSubstr("front_bogie, rear_bogie")));
}

}  // namespace
}  // namespace phs::vehicle
