// Springs of one axle box: forces of the joints against those of a spring at the box, by hand.
#include "vehicle/box_springs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vehicle/compose.h"
#include "vehicle/engine.h"
#include "vehicle/running_effects.h"
#include "vehicle/scenario_file.h"

namespace phs::vehicle {
namespace {

using testing::ElementsAre;

/// Box beside the axle's middle [m] (bogie_xml/shared/running_gear.xml).
constexpr double kArm = 0.9;

ModelPtr WithBoxes(const std::vector<std::string>& boxes, double factor) {
  Scenario s = LoadScenario("curve_r300").value();
  if (factor != 1) EXPECT_TRUE(AddEffect({"box_spring", boxes, {{"factor", factor}}}, &s).ok());
  auto model = ComposeVehicle(s);
  EXPECT_TRUE(model.ok()) << model.error().Line();
  return std::move(model).value();
}

/// Where the leading boxes stand: along their joints x, y, z, yaw, roll [m, rad].
struct Place {
  double x, y, z, yaw, roll;
};
constexpr const char* kJoints[] = {"lead_x", "lead_y", "lead_z", "lead_yaw", "lead_roll"};

/// Forces of the springs on these joints at rest.
std::array<double, 5> Forces(const mjModel* m, const Place& at) {
  const DataPtr d(mj_makeData(m));
  const double q[] = {at.x, at.y, at.z, at.yaw, at.roll};
  for (int k = 0; k < 5; ++k) {
    d->qpos[m->jnt_qposadr[mj_name2id(m, mjOBJ_JOINT, kJoints[k])]] = q[k];
  }
  mj_fwdPosition(m, d.get());
  mj_fwdVelocity(m, d.get());
  std::array<double, 5> out;
  for (int k = 0; k < 5; ++k) {
    out[k] = d->qfrc_passive[m->jnt_dofadr[mj_name2id(m, mjOBJ_JOINT, kJoints[k])]];
  }
  return out;
}

double Of(const mjModel* m, const char* joint, const mjtNum* array) {
  return array[mj_name2id(m, mjOBJ_JOINT, joint)];
}

// Half of the stiffness of the two boxes sits in one; at the left box the axle's place is
// (x - b yaw, y, z + b roll), b = 0.9 m to the left. What it has beyond pulls with
// (f - 1) k/2 (u0 - u).
TEST(BoxSprings, OneBoxBeyondItsShareByHand) {
  InstallEngineHandlers();
  const ModelPtr plain = WithBoxes({}, 1);
  for (const double factor : {0.6, 2.0}) {
    for (const double side : {1.0, -1.0}) {
      const ModelPtr soft = WithBoxes({side > 0 ? "lead_left" : "lead_right"}, factor);
      const Place at{1e-3, -2e-3, 3e-3, 4e-3, -5e-3};
      const auto other = Forces(plain.get(), at), own = Forces(soft.get(), at);
      const double b = side * kArm, more = (factor - 1) / 2;
      const auto beyond = [&](const char* joint, double u) {
        const int id = mj_name2id(plain.get(), mjOBJ_JOINT, joint);
        const double free = plain->qpos_spring[plain->jnt_qposadr[id]];
        return more * Of(plain.get(), joint, plain->jnt_stiffness) * (free - u);
      };
      const double fx = beyond("lead_x", at.x - b * at.yaw);
      const double fy = beyond("lead_y", at.y);
      const double fz = beyond("lead_z", at.z + b * at.roll);
      const double expected[] = {fx, fy, fz, -b * fx, b * fz};
      ASSERT_GT(std::abs(fz), 1e4);  // the load that the box carries
      for (int k = 0; k < 5; ++k) {
        EXPECT_NEAR(own[k] - other[k], expected[k], 1e-6 * std::abs(expected[k])) << kJoints[k];
      }
    }
  }
}

/// Every box alike is a stiffer guidance; its own yaw and roll stiffness stay.
TEST(BoxSprings, AllBoxesAreTheGuidance) {
  InstallEngineHandlers();
  const ModelPtr plain = WithBoxes({}, 1), all = WithBoxes({}, 1.5);
  const Place at{1e-3, 0, 0, 0, 0};
  EXPECT_NEAR(Forces(all.get(), at)[0], 1.5 * Forces(plain.get(), at)[0], 1e-6);
  const Place turned{0, 0, 0, 1e-3, 0};
  const double shear = Of(plain.get(), "lead_x", plain->jnt_stiffness) * kArm * kArm;
  EXPECT_NEAR(Forces(all.get(), turned)[3] - Forces(plain.get(), turned)[3], -0.5 * shear * 1e-3,
              1e-6);
}

TEST(BoxSprings, BoxesAreKnownByTheirSites) {
  InstallEngineHandlers();
  EXPECT_THAT(BoxNames(WithBoxes({}, 1).get()),
              ElementsAre("lead_left", "lead_right", "trail_left", "trail_right"));
}

}  // namespace
}  // namespace phs::vehicle
