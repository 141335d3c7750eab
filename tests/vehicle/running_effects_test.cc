// Effects of track, wheel and suspension in a scenario, and a scenario written back.
#include "vehicle/running_effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/data_path.h"
#include "tests/base/scratch_dir.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

/// Runs for two seconds in a tight curve's transition.
RunOutcome Execute(Scenario s) {
  s.start_s_m = 70, s.duration_s = 2;
  auto simulation = Simulation::Create(s);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  return simulation.value().Run().value();
}

Scenario Curve() { return LoadScenario("curve_r300").value(); }

std::string Written(const std::string& text) {
  const std::string path = ScratchFile("running_effects.yaml");
  std::ofstream(path) << text;
  return path;
}

TEST(RunningEffectsTest, NothingByDefault) {
  const RunOutcome plain = Execute(Curve());
  Scenario same = Curve();
  for (const RunningEffect& row : RunningEffects()) {
    if (row.info.name == "wheel_rail_friction") continue;  // its default is a value of its own
    ASSERT_TRUE(AddEffect({row.info.name, {}, {}}, &same).ok());
  }
  const RunOutcome with = Execute(same);
  EXPECT_EQ(plain.columns, with.columns);
}

TEST(RunningEffectsTest, EachOneChangesTheRun) {
  const RunOutcome plain = Execute(Curve());
  const auto lateral = static_cast<size_t>(plain.Find("lead_lateral_m"));
  for (const auto& [name, key, value] : {std::tuple{"tread_wear", "depth_m", 4e-4},
                                         {"wheel_rail_friction", "coefficient", 0.1},
                                         {"cant_error", "cant_m", 0.03},
                                         {"gauge_error", "widening_m", 0.01},
                                         {"box_spring", "factor", 0.5}}) {
    Scenario s = Curve();
    ASSERT_TRUE(AddEffect({name, {}, {{key, value}}}, &s).ok());
    EXPECT_NE(Execute(s).columns[lateral], plain.columns[lateral]) << name;
  }
}

TEST(RunningEffectsTest, MoreCantPressesTheInnerWheel) {
  Scenario s = Curve();
  s.duration_s = 0;
  const auto inner = [](const Scenario& of) {
    auto simulation = Simulation::Create(of);
    const RunOutcome run = simulation.value().Run().value();
    const Json summary = SummaryJson(Summarise(simulation.value(), run));
    return summary["steady_curve"]["wheels"][1]["Q_N"].get<double>();
  };
  const double declared = inner(s);
  ASSERT_TRUE(AddEffect({"cant_error", {}, {{"cant_m", 0.03}}}, &s).ok());
  // Load transfer by statics: dQ = W/2 · h_cg · dh/e² per axle, some kilonewtons; here only the
  // sign and that it is no trifle.
  EXPECT_GT(inner(s), declared + 2e3);
}

TEST(RunningEffectsTest, MistakesAreNamed) {
  for (const auto& [text, word] :
       {std::pair{"tread_ware: {depth_m: 0.001}", "tread_wear"},
        {"tread_wear: {dept_m: 0.001}", "depth_m"},
        {"cant_error: {cant_m: 0.5}", "-0.1 to 0.1"},
        {"gauge_error: {targets: [L1]}", "no targets"},
        {"box_spring: {targets: [lead_left], factor: 0}", "0.02 to 50"}}) {
    const auto loaded = LoadScenario(
        Written(std::string("track: straight\nspeed_m_s: 20\neffects:\n  ") + text + "\n"));
    ASSERT_FALSE(loaded.ok()) << text;
    EXPECT_THAT(loaded.error().Line(), HasSubstr(word));
    EXPECT_THAT(loaded.error().Line(), HasSubstr("running_effects.yaml:"));
  }
}

TEST(RunningEffectsTest, ABoxThatIsNotThereIsNamed) {
  Scenario s = Curve();
  ASSERT_TRUE(AddEffect({"box_spring", {"lead_lefd"}, {{"factor", 0.6}}}, &s).ok());
  const auto simulation = Simulation::Create(s);
  ASSERT_FALSE(simulation.ok());
  for (const char* word :
       {"effects.box_spring.targets", "'lead_lefd'", "trail_right", "did you mean 'lead_left'"}) {
    EXPECT_THAT(simulation.error().Line(), HasSubstr(word));
  }
}

TEST(ScenarioYamlTest, EveryScenarioReadsBackEqual) {
  for (const std::string& name : ListData("models/scenarios", {".yaml"})) {
    const Scenario s = LoadScenario(name).value();
    const auto again = LoadScenario(Written(ToYaml(s)));
    ASSERT_TRUE(again.ok()) << name << ": " << again.error().Line();
    Json a = DescribeScenario(s), b = DescribeScenario(again.value());
    a.erase("name"), b.erase("name");
    EXPECT_EQ(a, b) << ToYaml(s);
  }
}

TEST(ScenarioYamlTest, EffectsAndChangesReadBackEqual) {
  Scenario s = Curve();
  s.phs_changes.parameters = {{"friction.scale", 0.1 + 0.2}, {"lines.oil_volume_m3", 1e-3 / 3}};
  s.joints.push_back({"lead_y", 6e6, 4e4});
  ASSERT_TRUE(AddEffect({"cant_error", {}, {{"cant_m", 0.1 / 7}}}, &s).ok());
  ASSERT_TRUE(AddEffect({"box_spring", {"trail_left"}, {{"factor", 0.7}}}, &s).ok());
  ASSERT_TRUE(
      AddEffect({"external_leakage", {"L2"}, {{"conductance_m3_per_Pas", 1e-13}}}, &s).ok());
  const auto again = LoadScenario(Written(ToYaml(s)));
  ASSERT_TRUE(again.ok()) << again.error().Line();
  EXPECT_EQ(again.value().track_errors.cant_m, 0.1 / 7);
  EXPECT_EQ(again.value().phs_changes.parameters, s.phs_changes.parameters);
  ASSERT_EQ(again.value().phs_changes.effects.size(), 1u);
  EXPECT_EQ(again.value().phs_changes.effects[0].targets, std::vector<std::string>{"L2"});
  EXPECT_EQ(Execute(s).columns, Execute(again.value()).columns);
}

TEST(UseBogieTest, AtSignGivesAnotherPhsModel) {
  Scenario s = Curve();
  UseBogie("phs@out/run/model.yaml", &s);
  EXPECT_EQ(s.bogie, "phs");
  EXPECT_EQ(s.phs, "out/run/model.yaml");
  EXPECT_EQ(BogieLabel("phs@out/run/model.yaml"), "phs@model");
  EXPECT_EQ(BogieLabel("mine/x.xml"), "x");
  EXPECT_EQ(BogieLabel("rigid_link"), "rigid_link");
}

}  // namespace
}  // namespace phs::vehicle
