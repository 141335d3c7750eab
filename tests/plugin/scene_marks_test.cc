// What other programs' viewers are given: where track and arrows stand.
#include "plugin/scene_marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

class SceneMarksTest : public testing::Test {
 protected:
  void SetUp() override {
    m_ = LoadFile(BogiePath("phs"));
    AttachOptions options;
    options.track = "straight";
    options.speed_m_s = 15;
    options.start_s_m = 60;
    ASSERT_TRUE(Attach(m_.get(), options).ok());
    d_.reset(mj_makeData(m_.get()));
    ResetToStart(m_.get(), d_.get());
    mj_step(m_.get(), d_.get());
    mjv_defaultScene(&scene_);
    mjv_makeScene(m_.get(), &scene_, 2000);
    AddSceneMarks(m_.get(), d_.get(), *Find(m_.get()), &scene_);
  }
  void TearDown() override { mjv_freeScene(&scene_); }
  std::vector<const mjvGeom*> Of(int type) const {
    std::vector<const mjvGeom*> found;
    for (int i = 0; i < scene_.ngeom; ++i) {
      if (scene_.geoms[i].type == type) found.push_back(scene_.geoms + i);
    }
    return found;
  }

  EngineGuard guard_;
  ModelPtr m_;
  DataPtr d_;
  mjvScene scene_;
};

TEST_F(SceneMarksTest, RailsAndSleepersReachThirtyMetresBeyondTheWheelsets) {
  double front = -1e9, rear = 1e9;
  for (const WheelsetBinding& w : Find(m_.get())->wheelsets()) {
    front = std::max(front, d_->xpos[3 * w.body]);
    rear = std::min(rear, d_->xpos[3 * w.body]);
  }
  for (const int type : {static_cast<int>(mjGEOM_CAPSULE), static_cast<int>(mjGEOM_BOX)}) {
    double first = 1e9, last = -1e9;
    for (const mjvGeom* geom : Of(type)) {
      first = std::min(first, 1.0 * geom->pos[0]);
      last = std::max(last, 1.0 * geom->pos[0]);
    }
    EXPECT_NEAR(first, rear - 30, 1.01) << type;
    EXPECT_NEAR(last, front + 30, 1.01) << type;
  }
}

// Tape circles stand 992/2 + 70 = 566 mm from the middle (flange backs 992 mm apart, tape circle 70 mm
// from each), arrows 200 mm further out.
TEST_F(SceneMarksTest, ArrowsOfTheWheelsStandBesideThem) {
  int loads = 0;
  for (const mjvGeom* geom : Of(mjGEOM_ARROW)) {
    if (!(geom->rgba[2] > 0.8f && geom->rgba[0] < 0.3f)) continue;  // blue: loads
    ++loads;
    EXPECT_NEAR(std::abs(geom->pos[1]), 0.566 + 0.200, 1e-3);
  }
  EXPECT_EQ(loads, 4);
}

}  // namespace
}  // namespace phs::plugin
