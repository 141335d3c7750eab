// How models are bound: what is refused, what is left alone, what is undone.
#include "plugin/binding.h"

#include <gmock/gmock.h>

#include <thread>
#include <vector>

#include "plugin/observer.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

using testing::HasSubstr;

AttachOptions OnStraightTrack() {
  AttachOptions options;
  options.track = "straight";
  options.speed_m_s = 20;
  return options;
}

std::vector<double> Positions(const mjModel* m, const mjData* d) {
  return {d->qpos, d->qpos + m->nq};
}

std::vector<double> StepFromStart(const mjModel* m, int steps) {
  const DataPtr d(mj_makeData(m));
  ResetToStart(m, d.get());
  for (int i = 0; i < steps; ++i) mj_step(m, d.get());
  return Positions(m, d.get());
}

class BindingTest : public testing::Test {
 private:
  EngineGuard guard_;
};

TEST_F(BindingTest, StaticWheelLoadsSumToTheWeight) {
  const ModelPtr m = LoadFile(BogiePath("phs"));
  ASSERT_TRUE(Attach(m.get(), OnStraightTrack()).ok());
  const DataPtr d(mj_makeData(m.get()));
  ResetToStart(m.get(), d.get());
  mj_forward(m.get(), d.get());
  double up = 0;
  for (int i = 0; i < 2; ++i) up += Find(m.get())->CalcWheelset(m.get(), d.get(), i).force[2];
  const double weight = m->body_subtreemass[0] * 9.81;
  EXPECT_NEAR(up / weight, 1, 1e-6);
  EXPECT_NEAR(weight, 52000 * 9.81, 1e-6);
}

TEST_F(BindingTest, ModelsThatSayNothingAreLeftAlone) {
  const std::string xml =
      "<mujoco><worldbody><body><joint type='slide' axis='0 0 1'/><geom size='0.1'/></body>"
      "</worldbody></mujoco>";
  const ModelPtr plain = LoadText(xml);
  EXPECT_FALSE(Binding::Concerns(plain.get()));
  const DataPtr before(mj_makeData(plain.get()));
  for (int i = 0; i < 100; ++i) mj_step(plain.get(), before.get());
  const ModelPtr bogie = LoadFile(BogiePath("phs"));
  ASSERT_TRUE(Attach(bogie.get(), OnStraightTrack()).ok());
  const DataPtr after(mj_makeData(plain.get()));
  for (int i = 0; i < 100; ++i) mj_step(plain.get(), after.get());
  EXPECT_EQ(Positions(plain.get(), before.get()), Positions(plain.get(), after.get()));
}

TEST_F(BindingTest, AttachingChangesNothingButTheStartAndDetachingUndoesTheCallbacks) {
  const ModelPtr m = LoadFile(BogiePath("phs"));
  const std::vector<double> damping(m->dof_damping, m->dof_damping + m->nv);
  ASSERT_TRUE(Attach(m.get(), OnStraightTrack()).ok());
  EXPECT_EQ(damping, std::vector<double>(m->dof_damping, m->dof_damping + m->nv));
  EXPECT_NE(mjcb_passive, nullptr);
  Detach(m.get());
  EXPECT_EQ(damping, std::vector<double>(m->dof_damping, m->dof_damping + m->nv));
  EXPECT_EQ(mjcb_passive, nullptr);
  EXPECT_EQ(Find(m.get()), nullptr);
}

int foreign_calls = 0;

TEST_F(BindingTest, CallbacksOfOthersAreChainedNotReplaced) {
  foreign_calls = 0;
  mjcb_passive = [](const mjModel*, mjData*) { ++foreign_calls; };
  {
    const ModelPtr m = LoadFile(BogiePath("rigid_link"));
    ASSERT_TRUE(Attach(m.get(), OnStraightTrack()).ok());
    const DataPtr d(mj_makeData(m.get()));
    const int before = foreign_calls;
    mj_step(m.get(), d.get());
    EXPECT_EQ(foreign_calls, before + 1);
  }
  ASSERT_NE(mjcb_passive, nullptr);
  mjcb_passive = nullptr;
}

TEST_F(BindingTest, SeveralModelsInOneProcessDoNotDisturbEachOther) {
  const ModelPtr alone = LoadFile(BogiePath("phs"));
  ASSERT_TRUE(Attach(alone.get(), OnStraightTrack()).ok());
  const std::vector<double> expected = StepFromStart(alone.get(), 200);
  const ModelPtr other = LoadFile(BogiePath("rigid_link"));
  ASSERT_TRUE(Attach(other.get(), OnStraightTrack()).ok());
  const DataPtr a(mj_makeData(alone.get()));
  const DataPtr b(mj_makeData(other.get()));
  ResetToStart(alone.get(), a.get());
  ResetToStart(other.get(), b.get());
  for (int i = 0; i < 200; ++i) {
    mj_step(alone.get(), a.get());
    mj_step(other.get(), b.get());
  }
  EXPECT_EQ(Positions(alone.get(), a.get()), expected);
}

TEST_F(BindingTest, ManyThreadsOnOneModelGiveIdenticalBits) {
  const ModelPtr m = LoadFile(BogiePath("phs"));
  AttachOptions options = OnStraightTrack();
  options.track = "curve_r400";
  options.start_s_m = 60;
  ASSERT_TRUE(Attach(m.get(), options).ok());
  const std::vector<double> expected = StepFromStart(m.get(), 1500);
  std::vector<std::vector<double>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) {
    threads.emplace_back([&result, &m] { result = StepFromStart(m.get(), 1500); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, expected);
}

TEST_F(BindingTest, StateCopiedWithMjDataContinuesIdentically) {
  const ModelPtr m = LoadFile(BogiePath("phs"));
  AttachOptions options = OnStraightTrack();
  options.track = "curve_r400";
  options.start_s_m = 60;
  ASSERT_TRUE(Attach(m.get(), options).ok());
  const DataPtr d(mj_makeData(m.get()));
  ResetToStart(m.get(), d.get());
  for (int i = 0; i < 700; ++i) mj_step(m.get(), d.get());
  const DataPtr copy(mj_copyData(nullptr, m.get(), d.get()));
  for (int i = 0; i < 300; ++i) {
    mj_step(m.get(), d.get());
    mj_step(m.get(), copy.get());
  }
  EXPECT_EQ(Positions(m.get(), d.get()), Positions(m.get(), copy.get()));
}

std::string Refusal(const std::string& xml) {
  const ModelPtr m = LoadText(xml);
  const Status status = Attach(m.get(), OnStraightTrack());
  return status.ok() ? "accepted" : status.error().Line();
}

const char kWheelsetBody[] =
    "<worldbody><body name='axle' pos='0 0 0.625'><freejoint/><inertial pos='0 0 0' mass='2000' "
    "diaginertia='1000 300 1000'/><body name='wheelset'><joint name='spin' axis='0 1 0'/>"
    "<inertial pos='0 0 0' mass='1500' diaginertia='800 150 800'/></body></body></worldbody>"
    "<keyframe><key name='test'/></keyframe>";

TEST_F(BindingTest, ErrorsNameTheElementAndTheMend) {
  const std::string body = kWheelsetBody;
  EXPECT_THAT(Refusal("<mujoco>" + body +
                      "<custom><tuple name='wheelset:one'><element objtype='body' "
                      "objname='wheelset'/><element objtype='joint' objname='spin'/></tuple>"
                      "</custom></mujoco>"),
              HasSubstr("nuserdata"));
  EXPECT_THAT(Refusal("<mujoco><size nuserdata='96'/>" + body +
                      "<custom><tuple name='wheelset:one'><element objtype='body' "
                      "objname='axle'/><element objtype='joint' objname='spin'/></tuple>"
                      "</custom></mujoco>"),
              HasSubstr("joint 'spin' is not a joint of body 'axle'"));
  EXPECT_THAT(Refusal("<mujoco><size nuserdata='96'/>" + body +
                      "<custom><tuple name='wheelset:one'><element objtype='body' "
                      "objname='wheelset'/></tuple></custom></mujoco>"),
              HasSubstr("wheelset:one"));
  EXPECT_THAT(Refusal("<mujoco><size nuserdata='96'/><worldbody><body><joint name='j'/>"
                      "<geom size='1'/></body></worldbody><actuator><motor name='a' joint='j'/>"
                      "</actuator><custom><tuple name='phs:x'><element objtype='actuator' "
                      "objname='a'/></tuple></custom></mujoco>"),
              HasSubstr("one actuator per cylinder"));
}

TEST_F(BindingTest, UnknownNamesListTheKnownOnes) {
  const ModelPtr m = LoadFile(BogiePath("phs"));
  AttachOptions options = OnStraightTrack();
  options.track = "curve_r55";
  const Status track = Attach(m.get(), options);
  ASSERT_FALSE(track.ok());
  EXPECT_THAT(track.error().Line(), HasSubstr("curve_r550"));
  options = OnStraightTrack();
  options.wheel_profile = "S1003";
  const Status wheel = Attach(m.get(), options);
  ASSERT_FALSE(wheel.ok());
  EXPECT_THAT(wheel.error().Line(), HasSubstr("S1002"));
  EXPECT_EQ(Find(m.get()), nullptr);
}

TEST_F(BindingTest, TwoPhsInOneModelActSeparately) {
  const std::string xml =
      "<mujoco><size nuserdata='96'/><default><default class='c'><general dyntype='user' "
      "gaintype='fixed' gainprm='0' biastype='user'/></default></default><worldbody>"
      "<site name='w' pos='0 0 0'/>"
      "<body name='a' pos='1 0 0'><joint name='ja' type='slide' axis='1 0 0'/><geom size='0.1' "
      "mass='100' contype='0'/><site name='sa'/></body>"
      "<body name='b' pos='2 0 0'><joint name='jb' type='slide' axis='1 0 0'/><geom size='0.1' "
      "mass='100' contype='0'/><site name='sb'/></body></worldbody>"
      "<tendon><spatial name='ta'><site site='w'/><site site='sa'/></spatial>"
      "<spatial name='tb'><site site='w'/><site site='sb'/></spatial></tendon>"
      "<actuator><general name='ca' class='c' tendon='ta'/><general name='cb' class='c' "
      "tendon='tb'/></actuator>"
      "<custom><text name='phs:one' data='quarter_setup2'/><tuple name='phs:one'>"
      "<element objtype='actuator' objname='ca'/></tuple>"
      "<text name='phs:two' data='quarter_setup2'/><tuple name='phs:two'>"
      "<element objtype='actuator' objname='cb'/></tuple></custom></mujoco>";
  const ModelPtr m = LoadText(xml);
  const Status status = Attach(m.get(), {});
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const DataPtr d(mj_makeData(m.get()));
  d->qpos[0] = 1e-3;  // the first piston is pulled out, the second stays
  mj_forward(m.get(), d.get());
  EXPECT_LT(d->actuator_force[0], -1000);
  EXPECT_NEAR(d->actuator_force[1], 0, 1e-6);
}

}  // namespace
}  // namespace phs::plugin
