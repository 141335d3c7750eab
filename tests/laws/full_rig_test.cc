// The full rig twice: the trailing beam by the rig's own equation, and as a body of the engine
// whose cylinders are tendons driven by the plugin. Two ways to the same motion.
#include <gtest/gtest.h>

#include <cmath>

#include "phs_model/phs_model.h"
#include "plugin/registry.h"
#include "rigs/rig_model.h"
#include "rigs/rig_signal.h"
#include "tests/plugin/attached_model.h"

namespace phs {
namespace {

// Cylinders 1 and 2 push carriages whose motion is prescribed (too heavy to be moved by them).
constexpr char kRig[] = R"(<mujoco model="full_rig">
  <compiler angle="radian" autolimits="false"/>
  <size nuserdata="160"/>
  <option timestep="1e-4" integrator="Euler" gravity="0 0 0"/>
  <worldbody>
    <body><joint name="x1" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="1e12" diaginertia="1 1 1"/></body>
    <body><joint name="x2" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="1e12" diaginertia="1 1 1"/></body>
    <body><joint name="beam" type="hinge" axis="0 0 1" damping="2000"/>
      <inertial pos="0 0 0" mass="100" diaginertia="60 60 60"/></body>
  </worldbody>
  <tendon>
    <fixed name="c1"><joint joint="x1" coef="1"/></fixed>
    <fixed name="c2"><joint joint="x2" coef="1"/></fixed>
    <fixed name="c3"><joint joint="beam" coef="1"/></fixed>
    <fixed name="c4"><joint joint="beam" coef="-1"/></fixed>
  </tendon>
  <default><general dyntype="user" gaintype="fixed" gainprm="0" biastype="user"/></default>
  <actuator>
    <general name="c1" tendon="c1"/><general name="c2" tendon="c2"/>
    <general name="c3" tendon="c3"/><general name="c4" tendon="c4"/>
  </actuator>
  <custom>
    <text name="phs:rig" data="bo_bo"/>
    <tuple name="phs:rig">
      <element objtype="actuator" objname="c1"/><element objtype="actuator" objname="c2"/>
      <element objtype="actuator" objname="c3"/><element objtype="actuator" objname="c4"/>
    </tuple>
  </custom>
</mujoco>)";

TEST(FullRig, HingedBeamAndEngineBodyAgree) {
  const plugin::EngineGuard guard;
  const double h = 1e-4;
  const int n = 40001;
  rigs::SignalParams signal;
  signal.amplitude = 2e-3;
  signal.frequency_Hz = 0.5;
  rigs::RigMotion motion;
  motion.step_s = h;
  motion.position_m = {rigs::GenerateSignal(signal, n, h)};
  signal.amplitude = 1.5e-3;
  signal.frequency_Hz = 0.8;
  motion.position_m.push_back(rigs::GenerateSignal(signal, n, h));
  const rigs::RigModel rig = std::move(
      rigs::RigModel::Create(rigs::RigKind::kFull, phs_model::FindPhsParams("bo_bo").value())
          .value());
  rigs::RigPrediction own;
  ASSERT_TRUE(rig.Run(motion, &own).ok());

  plugin::ModelPtr m = plugin::LoadText(kRig);
  ASSERT_NE(m, nullptr);
  const Status attached = plugin::Attach(m.get(), {});
  ASSERT_TRUE(attached.ok()) << attached.error().Line();
  plugin::DataPtr d(mj_makeData(m.get()));
  double most[3] = {}, worst[3] = {};
  for (int i = 0; i + 1 < n; ++i) {
    for (int k = 0; k < 2; ++k) {
      d->qpos[k] = motion.position_m[k][i];
      d->qvel[k] = (motion.position_m[k][i + 1] - motion.position_m[k][i]) / h;
    }
    if (i % 100 == 0) {
      mj_forward(m.get(), d.get());
      const plugin::PhsState at = plugin::Find(m.get())->CalcPhs(m.get(), d.get(), 0);
      const double engine[] = {at.piston[2], at.pressure[0], at.pressure[3]};
      const double ours[] = {own.channels[2][i], own.channels[8][i], own.channels[11][i]};
      for (int k = 0; k < 3; ++k) {
        most[k] = std::max(most[k], std::abs(ours[k]));
        worst[k] = std::max(worst[k], std::abs(engine[k] - ours[k]));
      }
    }
    mj_step(m.get(), d.get());
  }
  EXPECT_GT(most[0], 2e-4) << "the beam moves";
  EXPECT_LT(worst[0] / most[0], 0.01) << "beam";
  EXPECT_LT(worst[1] / 2e6, 0.01) << "L1 against its static pressure";
  EXPECT_LT(worst[2] / 2e6, 0.01) << "L4 against its static pressure";
}

}  // namespace
}  // namespace phs
