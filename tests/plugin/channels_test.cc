// What the output channels mean, held against each other and against MuJoCo's own numbers.
#include "plugin/channels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "plugin/observer.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// The PHS bogie in a curve, half a second after the start.
class ChannelsTest : public testing::Test {
 protected:
  void SetUp() override {
    m_ = LoadFile(BogiePath("phs"));
    AttachOptions options;
    options.track = "curve_r250";
    options.speed_m_s = 15;
    options.start_s_m = 80;
    ASSERT_TRUE(Attach(m_.get(), options).ok());
    d_.reset(mj_makeData(m_.get()));
    ResetToStart(m_.get(), d_.get());
    while (d_->time < 0.5) mj_step(m_.get(), d_.get());
    const InstantForces instant(m_.get());
    mj_forward(m_.get(), d_.get());
    const Observer observer(m_.get(), *Find(m_.get()));
    std::vector<double> row(observer.channels().size());
    observer.Observe(m_.get(), d_.get(), row.data());
    for (size_t i = 0; i < row.size(); ++i) {
      EXPECT_TRUE(value_.emplace(observer.channels()[i].name, row[i]).second)
          << observer.channels()[i].name << " stands twice";
    }
  }
  double At(const std::string& name) const { return value_.at(name); }
  int YawDof(const std::string& wheelset) const {
    for (const WheelsetBinding& w : Find(m_.get())->wheelsets()) {
      if (w.name == wheelset) return m_->jnt_dofadr[w.yaw_joint];
    }
    throw std::out_of_range(wheelset);
  }

  EngineGuard guard_;
  ModelPtr m_;
  DataPtr d_;
  std::map<std::string, double> value_;
};

TEST_F(ChannelsTest, ForcesOfAWheelsetAreThoseOfItsWheels) {
  for (const std::string w : {"lead", "trail"}) {
    EXPECT_GT(std::abs(At(w + "_sum_Y_N")), 100);
    EXPECT_EQ(At(w + "_sum_Y_N"), At(w + "_right_Y_N") - At(w + "_left_Y_N"));
    EXPECT_EQ(At(w + "_X_N"), At(w + "_left_X_N") + At(w + "_right_X_N"));
    for (const std::string& wheel : {w + "_left", w + "_right"}) {
      EXPECT_EQ(At(wheel + "_Y_over_Q"), At(wheel + "_Y_N") / At(wheel + "_Q_N"));
      EXPECT_GT(At(wheel + "_adhesion_used"), 0);
      EXPECT_LE(At(wheel + "_adhesion_used"), 1 + 1e-6);
      EXPECT_LE(At(wheel + "_flange_N"), 2 * At(wheel + "_Q_N"));
    }
  }
}

TEST_F(ChannelsTest, WheelLoadsCarryTheWeight) {
  double load = 0;
  for (const char* wheel : {"lead_left", "lead_right", "trail_left", "trail_right"}) {
    load += At(std::string(wheel) + "_Q_N");
  }
  EXPECT_NEAR(load / (m_->body_subtreemass[0] * 9.81), 1, 0.05);
}

TEST_F(ChannelsTest, BendingIsTheDifferenceOfTheYawsAndShearTheirMean) {
  EXPECT_GT(std::abs(At("lead_yaw_rad")), 1e-5);
  EXPECT_EQ(At("bending_rad"), At("lead_yaw_rad") - At("trail_yaw_rad"));
  EXPECT_EQ(At("shear_rad"), (At("lead_yaw_rad") + At("trail_yaw_rad")) / 2);
}

TEST_F(ChannelsTest, CylinderMomentsAreWhatMuJoCoPutsOnTheYawJoint) {
  for (const std::string w : {"lead", "trail"}) {
    const double sum = At(w + "_phs_pressure_moment_Nm") + At(w + "_phs_friction_moment_Nm");
    EXPECT_GT(std::abs(sum), 1);
    EXPECT_NEAR(sum, d_->qfrc_actuator[YawDof(w)], 1e-9 * std::abs(sum) + 1e-9);
  }
}

TEST_F(ChannelsTest, TheWheelsetsRunWhereTheTrackIs) {
  const double ahead =
      std::hypot(At("lead_x_m") - At("trail_x_m"), At("lead_y_m") - At("trail_y_m"));
  EXPECT_GT(ahead, 1.5);
  EXPECT_LT(ahead, 5);
  EXPECT_NEAR(At("s_m"), 80 + ahead + 0.5 * 15, 0.2);
  EXPECT_NEAR(At("speed_m_s"), 15, 0.2);
  EXPECT_NEAR(At("lead_slip"), 0, 0.02);
  EXPECT_NE(At("curvature_1_m"), 0);
  EXPECT_EQ(At("t_s"), d_->time);
}

// After mj_step qpos, qvel, act and time are those of the next step; what is shown belongs to the
// step's beginning, all of it.
TEST_F(ChannelsTest, AfterAStepEveryChannelIsThatOfItsBeginning) {
  const Observer observer(m_.get(), *Find(m_.get()));
  std::vector<double> begin(observer.channels().size()), after(begin.size());
  mj_step(m_.get(), d_.get());
  mj_forward(m_.get(), d_.get());
  observer.Observe(m_.get(), d_.get(), begin.data());
  mj_step(m_.get(), d_.get());
  observer.Observe(m_.get(), d_.get(), after.data());
  for (size_t i = 0; i < begin.size(); ++i) {
    EXPECT_EQ(begin[i], after[i]) << observer.channels()[i].name;
  }
}

}  // namespace
}  // namespace phs::plugin
