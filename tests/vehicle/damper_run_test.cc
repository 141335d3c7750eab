// A damper between two sites in a whole run: the books know it, a locomotive has it on both bogies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "phs_places.h"
#include "tests/base/scratch_dir.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

constexpr char kFolder[] = PHS_SOURCE_DIR "/bogie_xml/";

/// The PHS bogie with a damper beside cylinder 1.
std::string DampedBogie(const ScratchDir& dir, const std::string& data) {
  std::ifstream file(std::string(kFolder) + "phs.xml");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::filesystem::create_directory_symlink(std::string(kFolder) + "shared", dir.File("shared"));
  const std::string custom = "<custom>";
  text.replace(
      text.find(custom), custom.size(),
      "<custom><tuple name=\"damper:box\"><element objtype=\"site\" "
      "objname=\"lead_left_bracket\"/><element objtype=\"site\" objname=\"lead_left_box\"/>"
      "</tuple><text name=\"damper:box\" data=\"" +
          data + "\"/>");
  return dir.Write("damped.xml", text);
}

RunOutcome Execute(const std::string& bogie, const std::string& vehicle, double duration,
                   double start_s_m = 70) {
  Scenario scenario = LoadScenario("curve_r300").value();
  scenario.bogie = bogie;
  scenario.vehicle = vehicle;
  scenario.start_s_m = start_s_m;
  scenario.duration_s = duration;
  auto simulation = Simulation::Create(scenario);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  return simulation.value().Run().value();
}

double Greatest(const RunOutcome& run, const std::string& channel) {
  double greatest = 0;
  for (const double x : run.columns.at(static_cast<size_t>(run.Find(channel)))) {
    greatest = std::max(greatest, std::abs(x));
  }
  return greatest;
}

TEST(DamperRunTest, TheBooksKnowWhatItLoses) {
  const ScratchDir dir;
  const std::string bogie =
      DampedBogie(dir, "damping_Ns_per_m=4e5 relief_N=1500 relief_damping_Ns_per_m=1e4");
  const RunOutcome without = Execute("phs", "bogie", 4);
  const RunOutcome with = Execute(bogie, "bogie", 4);
  EXPECT_EQ(without.Find("damper_box_force_N"), -1);
  EXPECT_GT(Greatest(with, "damper_box_force_N"), 300);
  const double lost = with.energy.lost_dampers - without.energy.lost_dampers;
  EXPECT_GT(lost, 4);
  // What the start in a transition leaves over is there without the damper, too.
  EXPECT_NEAR(with.energy.Error(), without.energy.Error(), 0.01 * lost);
}

TEST(DamperRunTest, ALocomotiveHasItOnBothBogies) {
  const ScratchDir dir;
  const RunOutcome run = Execute(DampedBogie(dir, "damping_Ns_per_m=4e5"), "locomotive", 0.5, 1);
  EXPECT_EQ(run.status, "ok");
  EXPECT_GT(Greatest(run, "damper_front_box_force_N"), 0);
  EXPECT_GT(Greatest(run, "damper_rear_box_force_N"), 0);
}

}  // namespace
}  // namespace phs::vehicle
