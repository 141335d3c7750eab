#include "plugin/active_steering.h"

#include <gmock/gmock.h>

#include "plugin/model_checks.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

using testing::HasSubstr;

class ActiveSteeringTest : public testing::Test {
 protected:
  /// A frame with an axle before and one behind its middle, each with a servo; `dynamics` of the
  /// leading one.
  static ModelPtr Frame(const std::string& dynamics = "filter") {
    std::string axles, servos, tuples;
    for (const auto& [name, x] : {std::pair{"lead", "1.5"}, std::pair{"trail", "-1.5"}}) {
      const std::string own = name;
      axles += "<body name='" + own + "' pos='" + x + " 0 0'><joint name='" + own +
               "_yaw' axis='0 0 1'/><inertial pos='0 0 0' mass='10' diaginertia='9 9 9'/></body>";
      servos += "<general name='" + own + "_servo' joint='" + own + "_yaw' dyntype='" +
                (own == "lead" ? dynamics : "filter") +
                "' dynprm='0.2' gainprm='1e5' biastype='affine' biasprm='0 -1e5 0'/>";
      tuples += "<tuple name='steering:" + own + "'><element objtype='actuator' objname='" + own +
                "_servo'/></tuple>";
    }
    return LoadText(
        "<mujoco><worldbody><body name='frame'><freejoint/><inertial pos='0 0 0' "
        "mass='100' diaginertia='90 90 90'/>" +
        axles + "</body></worldbody><actuator>" + servos + "</actuator><custom>" + tuples +
        "</custom></mujoco>");
  }

 private:
  EngineGuard guard_;
};

/// Demands while the frame turns to the left at 0.1 rad/s and runs at `speed` along itself, headed
/// `heading` from x [rad].
std::vector<double> Demands(const mjModel* m, double speed, double heading) {
  const DataPtr d(mj_makeData(m));
  const mjtNum up[3] = {0, 0, 1};
  mju_axisAngle2Quat(d->qpos + 3, up, heading);
  d->qvel[0] = speed * std::cos(heading);
  d->qvel[1] = speed * std::sin(heading);
  d->qvel[5] = 0.1;
  mj_forward(m, d.get());
  ControlSteering(m, d.get());
  SettleSteering(m, d.get());
  EXPECT_EQ(d->act[0], d->ctrl[0]);
  return {d->ctrl[0], d->ctrl[1]};
}

TEST_F(ActiveSteeringTest, AnAxleIsToldItsDistanceTimesTheCurvature) {
  const ModelPtr m = Frame();
  for (const double heading : {0.0, 1.0, -2.5}) {
    const auto told = Demands(m.get(), 20, heading);
    EXPECT_NEAR(told[0], 1.5 * 0.1 / 20, 1e-12);  // in front: to the left, where the curve goes
    EXPECT_NEAR(told[1], -1.5 * 0.1 / 20, 1e-12);
  }
  EXPECT_NEAR(Demands(m.get(), 0, 0)[0], 1.5 * 0.1, 1e-12) << "at rest: as at 1 m/s";
}

TEST_F(ActiveSteeringTest, WhatSteersNoAxleIsRefused) {
  EXPECT_TRUE(CheckModel(Frame().get(), {}).ok());
  const Status status = CheckModel(Frame("none").get(), {});
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().Line(), HasSubstr("steering:lead"));
  EXPECT_THAT(status.error().Line(), HasSubstr("dyntype=\"filter\""));
  const ModelPtr two = LoadText(
      "<mujoco><worldbody><body name='frame'><joint name='yaw'/><inertial pos='0 0 0' mass='1' "
      "diaginertia='1 1 1'/></body></worldbody><custom><tuple name='steering:x'><element "
      "objtype='body' objname='frame'/></tuple></custom></mujoco>");
  EXPECT_THAT(CheckModel(two.get(), {}).error().Line(), HasSubstr("does not name one actuator"));
}

}  // namespace
}  // namespace phs::plugin
