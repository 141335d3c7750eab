#include "view/view_model.h"

#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>

#include "phs_places.h"
#include "vehicle/compose.h"
#include "vehicle/scenario_file.h"
#include "view/stage.h"
#include "view/view_shapes.h"

namespace phs::view {
namespace {

vehicle::Scenario ScenarioOf(const std::string& bogie, const std::string& vehicle) {
  vehicle::Scenario scenario;
  scenario.track = "curve_r550";
  scenario.speed_m_s = 20;
  scenario.bogie = bogie;
  scenario.vehicle = vehicle;
  return scenario;
}

bool SameBits(const mjtNum* a, const mjtNum* b, int count) {
  return std::memcmp(a, b, sizeof(mjtNum) * static_cast<size_t>(count)) == 0;
}

/// All that moves or weighs in a model with shapes is what moves or weighs without.
TEST(ViewModel, ShapesWeighNothingOnEveryShippedBogie) {
  for (const auto& entry : std::filesystem::directory_iterator(PHS_SOURCE_DIR "/bogie_xml")) {
    const std::string bogie = entry.path().stem().string();
    // The Cooperrider bogie is a set of published equations: it has no shape.
    if (entry.path().extension() != ".xml" || bogie == "cooperrider") continue;
    for (const std::string kind : {"bogie", "locomotive"}) {
      if (bogie == "forced_steering" && kind == "bogie") continue;  // linked to a whole car body
      SCOPED_TRACE(bogie + " as " + kind);
      const vehicle::Scenario scenario = ScenarioOf(bogie, kind);
      auto bare = vehicle::ComposeVehicle(scenario);
      ASSERT_TRUE(bare.ok()) << bare.error().Line();
      auto view = ViewModel::Create(scenario);
      ASSERT_TRUE(view.ok()) << view.error().Line();
      EXPECT_TRUE(view.value().has_shapes());
      const mjModel* a = bare.value().get();
      const mjModel* b = view.value().model();
      EXPECT_GT(b->ngeom, a->ngeom + 10);
      ASSERT_EQ(a->nbody, b->nbody);
      ASSERT_EQ(a->nv, b->nv);
      ASSERT_EQ(a->nq, b->nq);
      EXPECT_TRUE(SameBits(a->body_mass, b->body_mass, a->nbody));
      EXPECT_TRUE(SameBits(a->body_inertia, b->body_inertia, 3 * a->nbody));
      EXPECT_TRUE(SameBits(a->body_ipos, b->body_ipos, 3 * a->nbody));
      EXPECT_TRUE(SameBits(a->jnt_stiffness, b->jnt_stiffness, a->njnt));
      EXPECT_TRUE(SameBits(a->dof_damping, b->dof_damping, a->nv));
      EXPECT_TRUE(SameBits(a->qpos0, b->qpos0, a->nq));
      EXPECT_TRUE(SameBits(a->tendon_stiffness, b->tendon_stiffness, a->ntendon));
      for (int g = 0; g < b->ngeom; ++g) {
        EXPECT_EQ(b->geom_contype[g], 0);
        EXPECT_EQ(b->geom_conaffinity[g], 0);
      }
    }
  }
}

/// A picture before and between changes no bit of a run: a view has its own model and data.
TEST(ViewModel, PicturesLeaveRunsAsTheyAre) {
  auto scenario = vehicle::LoadScenario("curve_r550");
  ASSERT_TRUE(scenario.ok());
  scenario.value().duration_s = 6;
  const auto run = [&] {
    auto recording = Record(scenario.value(), "phs", {});
    EXPECT_TRUE(recording.ok());
    return std::move(recording).value();
  };
  const Recording before = run();
  auto stage = Stage::Create(before);
  ASSERT_TRUE(stage.ok()) << stage.error().Line();
  stage.value()->SetMoment(4.0, {.magnify = {20, 5}, .contacts = true});
  EXPECT_GT(stage.value()->scene()->ngeom, 300);
  const Recording after = run();
  ASSERT_EQ(before.columns.size(), after.columns.size());
  for (size_t i = 0; i < before.columns.size(); ++i) {
    ASSERT_EQ(before.columns[i].size(), after.columns[i].size());
    EXPECT_TRUE(SameBits(before.columns[i].data(), after.columns[i].data(),
                         static_cast<int>(before.columns[i].size())))
        << before.channels[i].name;
  }
}

/// On another gauge, too; the shapes of the shipped bogies are not looked for beside it.
TEST(ViewModel, ABogieWithoutShapesIsDrawnAsItsFileSays) {
  vehicle::Scenario scenario =
      ScenarioOf(PHS_SOURCE_DIR "/tests/vehicle/bogies/standard_gauge.xml", "bogie");
  scenario.track = PHS_SOURCE_DIR "/tests/vehicle/bogies/standard_r400.yaml";
  auto view = ViewModel::Create(scenario);
  ASSERT_TRUE(view.ok()) << view.error().Line();
  EXPECT_FALSE(view.value().has_shapes());
  int shown = 0;
  for (int g = 0; g < view.value().model()->ngeom; ++g) {
    shown += view.value().model()->geom_group[g] == kPhysicsGroup ? 1 : 0;
  }
  EXPECT_GT(shown, 0);
}

}  // namespace
}  // namespace phs::view
