#include "plugin/bogie_pairs.h"

#include <gtest/gtest.h>

#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// One free wheelset per name.
std::vector<BogiePair> PairsOf(const std::vector<std::string>& names) {
  std::string bodies, tuples;
  for (const std::string& name : names) {
    bodies += "<body name='" + name + "'><freejoint/><inertial pos='0 0 0' mass='100' " +
              "diaginertia='1 1 1'/><body name='" + name + "_axle'><joint name='" + name +
              "_spin' axis='0 1 0'/><inertial pos='0 0 0' mass='1500' diaginertia='800 150 800'/>" +
              "</body></body>";
    tuples += "<tuple name='wheelset:" + name + "'><element objtype='body' objname='" + name +
              "_axle'/><element objtype='joint' objname='" + name + "_spin'/></tuple>";
  }
  const ModelPtr m =
      LoadText("<mujoco><size nuserdata='300'/><worldbody>" + bodies + "</worldbody><custom>" +
               tuples + "</custom><keyframe><key name='test'/></keyframe></mujoco>");
  const Status attached = Attach(m.get(), {});
  EXPECT_TRUE(attached.ok()) << attached.error().Line();
  return FindBogies(*Find(m.get()));
}

TEST(BogiePairs, ABogieIsALeadingAndATrailingWheelsetOfOneName) {
  const EngineGuard guard;
  const auto pairs = PairsOf({"rear_trail", "front_lead", "middle", "rear_lead", "front_trail"});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].prefix, "front_");
  EXPECT_EQ(pairs[0].lead, 1);
  EXPECT_EQ(pairs[0].trail, 4);
  EXPECT_EQ(pairs[1].prefix, "rear_");
  EXPECT_EQ(pairs[1].lead, 3);
  EXPECT_EQ(pairs[1].trail, 0);
}

TEST(BogiePairs, ALeadingWheelsetAloneIsNone) {
  const EngineGuard guard;
  EXPECT_TRUE(PairsOf({"lead", "middle"}).empty());
}

}  // namespace
}  // namespace phs::plugin
