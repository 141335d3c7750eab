// What MuJoCo accepts and is wrong all the same: named in one line before anything is bound.
#include "plugin/model_checks.h"

#include <gmock/gmock.h>

#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ModelChecksTest : public testing::Test {
 protected:
  /// Two axles on one frame, with `custom` and `more` of the test.
  static std::string Model(const std::string& custom, const std::string& more = "",
                           const std::string& key = "<keyframe><key name='test'/></keyframe>") {
    std::string axles;
    for (const char* name : {"lead", "trail"}) {
      axles += std::string("<body name='") + name + "'><joint name='" + name +
               "_x' type='slide' axis='1 0 0'/><joint name='" + name +
               "_spin' axis='0 1 0'/><inertial pos='0 0 0' mass='1500' "
               "diaginertia='800 150 800'/></body>";
    }
    return "<mujoco><size nuserdata='96'/><worldbody><body name='frame'><freejoint/>"
           "<inertial pos='0 0 0' mass='2000' diaginertia='1000 300 1000'/>" +
           axles + "</body></worldbody>" + more + "<custom>" + custom + "</custom>" + key +
           "</mujoco>";
  }
  static std::string Wheelset(const std::string& name, const std::string& body) {
    return "<tuple name='wheelset:" + name + "'><element objtype='body' objname='" + body +
           "'/><element objtype='joint' objname='" + body + "_spin'/></tuple>";
  }
  static std::string Says(const std::string& xml, const AttachOptions& options = {}) {
    const ModelPtr m = LoadText(xml);
    const Status status = CheckModel(m.get(), options);
    return status.ok() ? "ok" : status.error().Line();
  }

 private:
  EngineGuard guard_;
};

TEST_F(ModelChecksTest, WhatIsRightPasses) {
  EXPECT_EQ(Says(Model(Wheelset("lead", "lead") + Wheelset("trail", "trail") +
                       "<text name='phs_track' data='straight'/>"
                       "<numeric name='phs_speed_m_s' data='20'/>"
                       "<numeric name='my_own' data='1'/><text name='author' data='me'/>"
                       "<tuple name='feet:left'><element objtype='body' objname='lead'/></tuple>")),
            "ok");
  for (const char* bogie : {"phs", "rigid_link", "phs_coco", "cooperrider", "emd_radial_coco"}) {
    const ModelPtr m = LoadFile(BogiePath(bogie));
    EXPECT_TRUE(CheckModel(m.get(), {}).ok()) << bogie;
  }
}

TEST_F(ModelChecksTest, MisspeltFieldsAreNamedWithTheNearest) {
  EXPECT_THAT(Says(Model("<text name='phs_trak' data='straight'/>")),
              AllOf(HasSubstr("text 'phs_trak'"), HasSubstr("did you mean 'phs_track'")));
  EXPECT_THAT(Says(Model("<numeric name='phs_flangeback_m' data='1.36'/>")),
              HasSubstr("did you mean 'phs_flange_back_m'"));
  EXPECT_THAT(Says(Model("<text name='phs_speed_m_s' data='20'/>")),
              AllOf(HasSubstr("wrong kind"), HasSubstr("<numeric name=\"phs_speed_m_s\"")));
  EXPECT_THAT(Says(Model("<numeric name='phs_track' data='1'/>")), HasSubstr("<text name="));
  EXPECT_THAT(Says(Model("<tuple name='wheelst:lead'><element objtype='body' objname='lead'/>"
                         "</tuple>")),
              AllOf(HasSubstr("wheelst:lead"), HasSubstr("did you mean 'wheelset'")));
  EXPECT_THAT(Says(Model("<text name='phs:bogy' data='bo_bo'/>")), HasSubstr("phs:bogy"));
}

TEST_F(ModelChecksTest, NothingIsBoundTwice) {
  EXPECT_THAT(Says(Model(Wheelset("lead", "lead") + Wheelset("trail", "lead"))),
              AllOf(HasSubstr("wheelset:trail"), HasSubstr("body 'lead' as 'wheelset:lead' does")));
  const std::string cylinders =
      "<actuator><general name='c1' joint='lead_x' dyntype='user' biastype='user'/>"
      "<general name='c2' joint='trail_x' dyntype='user' biastype='user'/></actuator>";
  const auto phs = [](const std::string& name, const std::string& a, const std::string& b) {
    return "<tuple name='phs:" + name + "'><element objtype='actuator' objname='" + a +
           "'/><element objtype='actuator' objname='" + b + "'/></tuple>";
  };
  EXPECT_EQ(Says(Model(phs("one", "c1", "c2"), cylinders)), "ok");
  EXPECT_THAT(Says(Model(phs("one", "c1", "c1"), cylinders)), HasSubstr("'c1' twice"));
  EXPECT_THAT(Says(Model(phs("one", "c1", "c2") + phs("two", "c2", "c2"), cylinders)),
              AllOf(HasSubstr("phs:two"), HasSubstr("'c2' as 'phs:one' does")));
}

TEST_F(ModelChecksTest, BackwardsIsRefused) {
  EXPECT_THAT(Says(Model("<numeric name='phs_speed_m_s' data='-20'/>")),
              AllOf(HasSubstr("phs_speed_m_s"), HasSubstr("-20"), HasSubstr("0 or more")));
  AttachOptions options;
  options.speed_m_s = -5;
  EXPECT_THAT(Says(Model(""), options), HasSubstr("speed_m_s: is -5"));
}

TEST_F(ModelChecksTest, ABogieLinkedToTheBodyAsksForALocomotive) {
  EXPECT_THAT(Says(Model("<text name='phs_vehicle' data='locomotive'/>")),
              HasSubstr("vehicle: locomotive"));
  EXPECT_THAT(Says(Model("<text name='phs_vehicle' data='tram'/>")),
              AllOf(HasSubstr("'tram'"), HasSubstr("allowed: locomotive")));
}

TEST_F(ModelChecksTest, TheKeyOfTheStartIsAskedFor) {
  EXPECT_THAT(Says(Model(Wheelset("lead", "lead"), "", "")),
              AllOf(HasSubstr("key 'test'"), HasSubstr("<key name=\"test\"/>")));
  EXPECT_EQ(Says(Model("", "", "")), "ok") << "without wheelsets nothing stands on a track";
}

TEST_F(ModelChecksTest, AFailureOfAPhsThatIsNotThereIsRefusedWithTheNames) {
  const ModelPtr m = LoadFile(BogiePath("phs"));
  AttachOptions options;
  options.phs_changes.failures = {{.kind = "air", .line = "L1", .system = "bogy"}};
  const Status wrong = CheckModel(m.get(), options);
  ASSERT_FALSE(wrong.ok());
  EXPECT_THAT(wrong.error().Line(), AllOf(HasSubstr("system 'bogy'"), HasSubstr("allowed: bogie"),
                                          HasSubstr("did you mean 'bogie'")));
  options.phs_changes.failures[0].system = "bogie";
  EXPECT_TRUE(CheckModel(m.get(), options).ok());
}

TEST_F(ModelChecksTest, ACylinderActsOnATendonOrASlideJoint) {
  const ModelPtr m =
      LoadText(Model("",
                     "<actuator><motor name='a' joint='lead_x'/><general name='b' joint='lead_x' "
                     "biastype='user'/><general name='c' joint='lead_spin' biastype='user'/>"
                     "</actuator>"));
  EXPECT_FALSE(IsCylinder(m.get(), 0)) << "a motor";
  EXPECT_TRUE(IsCylinder(m.get(), 1)) << "a slide joint";
  EXPECT_FALSE(IsCylinder(m.get(), 2)) << "a hinge has no length";
}

}  // namespace
}  // namespace phs::plugin
