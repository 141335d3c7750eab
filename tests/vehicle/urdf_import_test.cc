// A bogie from URDF runs as the MJCF one.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "base/result_dir.h"
#include "phs_places.h"
#include "tests/base/scratch_dir.h"
#include "vehicle/bogie_import.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

using testing::HasSubstr;

const std::string kBogieFolder = std::string(PHS_SOURCE_DIR) + "/models/urdf/";

class UrdfImportTest : public testing::Test {
 protected:
  void SetUp() override {
    urdf_ = ReadFile(kBogieFolder + "bogie_19e.urdf").value();
    mapping_ = ReadFile(kBogieFolder + "bogie_19e_phs.yaml").value();
  }
  std::string Write(const std::string& name, const std::string& text) const {
    return folder_.Write(name, text);
  }
  /// Imports the shipped files with one text replaced.
  Result<std::string> Import(const std::string& from = "", const std::string& to = "") const {
    std::string urdf = urdf_;
    std::string mapping = mapping_;
    for (std::string* text : {&urdf, &mapping}) {
      if (const size_t at = text->find(from); !from.empty() && at != std::string::npos) {
        text->replace(at, from.size(), to);
      }
    }
    auto model = ReadUrdf(Write("bogie.urdf", urdf));
    if (!model.ok()) return model.error();
    auto map = LoadBogieMapping(Write("map.yaml", mapping));
    if (!map.ok()) return map.error();
    return ImportBogie(model.value(), map.value());
  }
  std::string ErrorOf(const std::string& from, const std::string& to) const {
    const auto result = Import(from, to);
    EXPECT_FALSE(result.ok()) << "nothing wrong with " << to;
    return result.ok() ? "" : result.error().Line();
  }

  ScratchDir folder_;
  std::string urdf_;
  std::string mapping_;
};

RunOutcome RunBogie(const std::string& bogie, const std::string& vehicle = "bogie",
                    double duration_s = 8) {
  Scenario s;
  s.name = "import";
  s.bogie = bogie;
  s.track = "curve_r550";
  s.speed_m_s = 80 / 3.6;
  s.vehicle = vehicle;
  s.duration_s = duration_s;
  auto sim = Simulation::Create(s);
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run();
  EXPECT_EQ(run.value().status, "ok");
  return std::move(run).value();
}

void ExpectSame(const RunOutcome& imported, const RunOutcome& own, const std::string& prefix) {
  for (const char* of_bogie : {"lead_lateral_m", "lead_angle_of_attack_rad", "lead_right_Y_N",
                               "trail_left_Q_N", "trail_right_T_gamma_N"}) {
    const std::string channel = prefix + of_bogie;
    const auto& a = imported.columns[static_cast<size_t>(imported.Find(channel))];
    const auto& b = own.columns[static_cast<size_t>(own.Find(channel))];
    ASSERT_EQ(a.size(), b.size());
    double largest = 0;
    double difference = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      largest = std::max(largest, std::abs(b[i]));
      difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    EXPECT_LT(difference, 1e-6 * largest) << channel;
  }
}

TEST_F(UrdfImportTest, NestedOrChainedWithoutLimitIsRefused) {
  std::string nested = "<robot name=\"r\">", chained = nested;
  for (int i = 0; i < 50000; ++i) {
    nested += "<link name=\"a\">";
    const std::string own = std::to_string(i), next = std::to_string(i + 1);
    chained += "<link name=\"l" + own + "\"/><joint name=\"j" + own +
               "\" type=\"fixed\"><parent link=\"l" + own + "\"/><child link=\"l" + next +
               "\"/></joint>";
  }
  EXPECT_THAT(ReadUrdf(Write("n.urdf", nested)).error().Line(),
              HasSubstr("nests elements too deep"));
  EXPECT_THAT(ReadUrdf(Write("c.urdf", chained + "</robot>")).error().Line(),
              HasSubstr("has too many links"));
  // Signs in remarks open nothing.
  std::string remarks = urdf_;
  for (int i = 0; i < 200; ++i) remarks.insert(remarks.find("<robot"), "<!-- <a> <b> -->");
  EXPECT_TRUE(ReadUrdf(Write("r.urdf", remarks)).ok());
}

// Read under the address sanitizer: the parser used to step past the end.
TEST_F(UrdfImportTest, AFileThatEndsWithinALetterIsRefused) {
  const size_t at = urdf_.find("lead_boxes");
  ASSERT_NE(at, std::string::npos);
  for (const char* letter : {"\xe5", "\xf0", "\xc3"}) {
    const auto cut = ReadUrdf(Write("bogie.urdf", urdf_.substr(0, at + 1) + letter));
    ASSERT_FALSE(cut.ok());
    EXPECT_THAT(cut.error().Line(), HasSubstr("bogie.urdf"));
  }
}

TEST_F(UrdfImportTest, ANameCannotLeadOutOfTheResult) {
  for (const char* name : {"../evil", "a/b", ".hidden", "-o", "\"a b\""}) {
    const std::string error = ErrorOf("name: bogie_19e_phs", std::string("name: ") + name);
    EXPECT_THAT(error, HasSubstr("is no file name; allowed: letters, digits")) << name;
  }
}

TEST_F(UrdfImportTest, TheImportedBogieRunsAsTheOneInMjcf) {
  for (const char* name : {"phs", "rigid_link"}) {
    mapping_ = ReadFile(kBogieFolder + "bogie_19e_" + name + ".yaml").value();
    auto text = Import();
    ASSERT_TRUE(text.ok()) << text.error().Line();
    const RunOutcome imported = RunBogie(Write(std::string(name) + "_imported.xml", text.value()));
    const RunOutcome own = RunBogie(name);
    ExpectSame(imported, own, "");
  }
}

TEST_F(UrdfImportTest, TheImportedBogieCarriesALocomotiveToo) {
  auto text = Import();
  ASSERT_TRUE(text.ok()) << text.error().Line();
  const std::string file = Write("imported.xml", text.value());
  const RunOutcome imported = RunBogie(file, "locomotive", 5);
  const RunOutcome own = RunBogie("phs", "locomotive", 5);
  for (const char* prefix : {"front_", "rear_"}) ExpectSame(imported, own, prefix);
}

TEST_F(UrdfImportTest, ErrorsNameTheElement) {
  EXPECT_THAT(ErrorOf("<mass value=\"2600\"/>", "<mass value=\"none\"/>"),
              HasSubstr("lead_wheelset"));
  EXPECT_THAT(ErrorOf("type=\"continuous\"", "type=\"prismatic\""), HasSubstr("lead_axle"));
  EXPECT_THAT(ErrorOf("<axis xyz=\"0 1 0\"/>", "<axis xyz=\"1 0 0\"/>"),
              HasSubstr("joint 'lead_axle'"));
  EXPECT_THAT(ErrorOf("<parent link=\"frame\"/>", "<parent link=\"fram\"/>"), HasSubstr("fram"));
  EXPECT_THAT(ErrorOf("wheelset: lead_wheelset", "wheelset: lead_weelset"),
              HasSubstr("did you mean 'lead_wheelset'"));
  EXPECT_THAT(ErrorOf("frame: frame", "frame: half_body"), HasSubstr("link 'half_body'"));
  EXPECT_THAT(ErrorOf("      yaw: {", "      jaw: {"), HasSubstr("did you mean 'yaw'"));
  EXPECT_THAT(ErrorOf("from_m: [1.15, 0.9, 0]", "from_m: [1.15, 0.9]"),
              HasSubstr("three: x, y, z"));
  EXPECT_THAT(ErrorOf("<robot name", "<robbot name"), HasSubstr("bogie.urdf"));
  const std::string joint = "<joint name=\"secondary\" type=\"floating\">";
  EXPECT_THAT(ErrorOf(joint,
                      "<joint name=\"secondary\" type=\"revolute\"><limit effort=\"1\" "
                      "velocity=\"1\" lower=\"0\" upper=\"1\"/>"),
              HasSubstr("joint 'secondary'"));
}

}  // namespace
}  // namespace phs::vehicle
