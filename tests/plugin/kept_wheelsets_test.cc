// What KeptWheelsets gives back is what a search finds, to the last bit.
#include "plugin/kept_wheelsets.h"

#include <gtest/gtest.h>

#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

void ExpectSame(const WheelsetState& a, const WheelsetState& b) {
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.moment, b.moment);
  EXPECT_EQ(a.lateral, b.lateral);
  EXPECT_EQ(a.yaw, b.yaw);
  EXPECT_EQ(a.frame.s, b.frame.s);
  for (const int side : {0, 1}) {
    ASSERT_EQ(a.wheel[side].count, b.wheel[side].count);
    EXPECT_EQ(a.wheel[side].force, b.wheel[side].force);
    EXPECT_EQ(a.wheel[side].stored_energy, b.wheel[side].stored_energy);
    EXPECT_EQ(a.wheel[side].t_gamma, b.wheel[side].t_gamma);
  }
}

class KeptWheelsetsTest : public testing::Test {
 protected:
  KeptWheelsetsTest() : m_(LoadFile(BogiePath("phs"))) {
    AttachOptions options;
    options.track = "curve_r250";
    options.speed_m_s = 15;
    options.start_s_m = 60;
    EXPECT_TRUE(Attach(m_.get(), options).ok());
    d_.reset(mj_makeData(m_.get()));
    ResetToStart(m_.get(), d_.get());
  }
  /// With what is kept, and in a copy that nobody keeps.
  void ExpectSameAsSearched() {
    const DataPtr copy(mj_copyData(nullptr, m_.get(), d_.get()));
    const Binding& binding = *Find(m_.get());
    for (const int i : {0, 1}) {
      ExpectSame(binding.CalcWheelset(m_.get(), d_.get(), i),
                 binding.CalcWheelset(m_.get(), copy.get(), i));
    }
  }

  EngineGuard guard_;
  ModelPtr m_;
  DataPtr d_;
};

TEST_F(KeptWheelsetsTest, AfterStepsTheyAreThoseOfASearch) {
  const KeptWheelsets kept(*Find(m_.get()), d_.get());
  for (int row = 0; row < 20; ++row) {
    for (int i = 0; i < 25; ++i) mj_step(m_.get(), d_.get());
    EXPECT_NE(kept.Find(d_.get(), 0), nullptr);
    ExpectSameAsSearched();
  }
}

TEST_F(KeptWheelsetsTest, AWheelsetThatWasMovedSinceIsSearchedAnew) {
  const KeptWheelsets kept(*Find(m_.get()), d_.get());
  mj_step(m_.get(), d_.get());
  d_->qpos[1] += 1e-3;
  mj_kinematics(m_.get(), d_.get());
  mj_comPos(m_.get(), d_.get());
  EXPECT_EQ(kept.Find(d_.get(), 0), nullptr);
  ExpectSameAsSearched();
}

TEST_F(KeptWheelsetsTest, StepsTakeNoNoticeOfThem) {
  const DataPtr other(mj_copyData(nullptr, m_.get(), d_.get()));
  const KeptWheelsets kept(*Find(m_.get()), d_.get());
  for (int i = 0; i < 500; ++i) {
    mj_step(m_.get(), d_.get());
    mj_step(m_.get(), other.get());
  }
  for (int i = 0; i < m_->nq; ++i) EXPECT_EQ(d_->qpos[i], other->qpos[i]);
  for (int i = 0; i < m_->nv; ++i) EXPECT_EQ(d_->qvel[i], other->qvel[i]);
  for (int i = 0; i < m_->na; ++i) EXPECT_EQ(d_->act[i], other->act[i]);
}

}  // namespace
}  // namespace phs::plugin
