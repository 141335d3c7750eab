#include "vehicle/bogie_values.h"

#include <gmock/gmock.h>

#include "vehicle/mjcf_document.h"

namespace phs::vehicle {
namespace {

using testing::HasSubstr;

/// The varied bogie as MuJoCo compiles it.
ModelPtr Compiled(const std::string& bogie, const BogieValues& values) {
  auto varied = VaryBogie(bogie, values);
  EXPECT_TRUE(varied.ok()) << varied.error().Line();
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(varied.value().text.c_str()), tinyxml2::XML_SUCCESS);
  auto model = CompileMjcf(document, bogie);
  EXPECT_TRUE(model.ok()) << model.error().Line();
  return std::move(model).value();
}

std::string Fault(const std::string& bogie, const BogieValues& values) {
  const auto varied = VaryBogie(bogie, values);
  return varied.ok() ? "no error" : varied.error().Line();
}

double TendonStiffness(const mjModel* m, const char* name) {
  return m->tendon_stiffness[mj_name2id(m, mjOBJ_TENDON, name)];
}

TEST(BogieValues, AValueIsSetInEveryElementOfThatName) {
  const ModelPtr m = Compiled("ge_coupling_shaft", {{"coupling_*.stiffness", "7.5e6"}});
  EXPECT_EQ(TendonStiffness(m.get(), "coupling_left"), 7.5e6);
  EXPECT_EQ(TendonStiffness(m.get(), "coupling_right"), 7.5e6);
}

TEST(BogieValues, AFactorMultipliesTheFilesOwnNumbers) {
  const ModelPtr m = Compiled("scheffel_cross_anchors",
                              {{"anchor_1.stiffness", "x2"}, {"lead_left_arm.pos", "x0.5"}});
  EXPECT_EQ(TendonStiffness(m.get(), "anchor_1"), 2 * 9.6e6);
  EXPECT_EQ(TendonStiffness(m.get(), "anchor_2"), 9.6e6);
  const mjtNum* arm = m->site_pos + 3 * mj_name2id(m.get(), mjOBJ_SITE, "lead_left_arm");
  EXPECT_EQ(arm[0], -0.4);
  EXPECT_EQ(arm[1], 0.2);
}

TEST(BogieValues, AClassStandsForItsElements) {
  const ModelPtr m = Compiled("rigid_link", {{"guidance_yaw.stiffness", "x2"}});
  for (const char* joint : {"lead_yaw", "trail_yaw"}) {
    EXPECT_EQ(m->jnt_stiffness[mj_name2id(m.get(), mjOBJ_JOINT, joint)], 2 * 66.42e6);
  }
  EXPECT_EQ(m->jnt_stiffness[mj_name2id(m.get(), mjOBJ_JOINT, "lead_x")], 82.0e6);
}

TEST(BogieValues, ATextIsSetByTheKeysOfItsData) {
  const auto varied = VaryBogie("phs_damped", {{"damper:yaw_*.relief_N", "x2"}});
  ASSERT_TRUE(varied.ok()) << varied.error().Line();
  EXPECT_THAT(varied.value().text, HasSubstr("relief_N=30000 "));
  EXPECT_THAT(varied.value().text, testing::Not(HasSubstr("relief_N=15000")));
}

TEST(BogieValues, ACarBodyThatTheFileNamesIsChangedBeside) {
  const auto varied = VaryBogie("forced_steering", {{"forced.stiffness", "1e6"}});
  ASSERT_TRUE(varied.ok()) << varied.error().Line();
  EXPECT_THAT(varied.value().car_body, HasSubstr("stiffness=\"1e6\""));
  EXPECT_THAT(varied.value().text, HasSubstr(varied.value().car_body_file));
  // Untouched it stays where it is.
  const auto own = VaryBogie("forced_steering", {{"guidance_x.stiffness", "1e6"}});
  ASSERT_TRUE(own.ok());
  EXPECT_EQ(own.value().car_body, "");
}

TEST(BogieValues, EachWrongKeyIsNamed) {
  EXPECT_THAT(Fault("ge_coupling_shaft", {{"couplin_left.stiffness", "1"}}),
              HasSubstr("couplin_left.stiffness: the bogie has no element 'couplin_left'"));
  EXPECT_THAT(Fault("ge_coupling_shaft", {{"couplin_left.stiffness", "1"}}),
              HasSubstr("did you mean 'coupling_left'?"));
  EXPECT_THAT(Fault("ge_coupling_shaft", {{"coupling_left.stifness", "1"}}),
              HasSubstr("'coupling_left' states no 'stifness'"));
  EXPECT_THAT(Fault("rigid_link", {{"lead_yaw.stiffness", "1"}}),
              HasSubstr("'lead_yaw' states no 'stiffness'"));  // its class does
  EXPECT_THAT(Fault("rigid_link", {{"lead_yaw.class", "x2"}}), HasSubstr("is no number"));
  EXPECT_THAT(Fault("rigid_link", {{"stiffness", "1"}}), HasSubstr("ELEMENT.ATTRIBUTE"));
  EXPECT_THAT(Fault("no_such_bogie", {}), HasSubstr("no_such_bogie"));
}

}  // namespace
}  // namespace phs::vehicle
