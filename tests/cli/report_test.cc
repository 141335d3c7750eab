// phs report, --index, and where results say they come from: as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/origin.h"
#include "base/result_dir.h"
#include "base/sha256.h"
#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class ReportProgram : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return dir_.File(name); }
  std::string Text(const std::string& name) const { return ReadFile(Path(name)).value(); }
  Output Run(const std::string& arguments, const std::string& before = "") const {
    const Output out = Execute(before + PhsCommand(arguments));
    EXPECT_EQ(out.code, 0) << arguments << "\n" << out.text;
    return out;
  }
  std::string Rig() const {
    return dir_.Write(
        "rig.yaml",
        "rig: cylinder\nmodel: single_cylinder\nsignal:\n  duration_s: 5\n  sample_s: "
        "0.01\n  actuator_m: {kind: ramp, amplitude_m: 1.0e-4, speed_m_s: -5.0e-5, "
        "start_s: 1}\n");
  }
  /// Four steps of one setup: enough for a result with its page, and done in a second.
  std::string Steps() const {
    const std::string shipped = std::string(PHS_SOURCE_DIR) + "/models/rigs/lowe_table_b1.csv";
    const std::string table = ReadFile(shipped).value();
    dir_.Write("lowe_table_b1.csv", table.substr(0, table.find("\n11,") + 1));
    return dir_.Write("steps.yaml",
                      "rig: steps\nmodel: quarter_setup2\ndata: lowe_table_b1.csv\nsetup: 2\n");
  }
  ScratchDir dir_;
};

bool Names(const Origin& origin, const std::string& ending) {
  return std::any_of(origin.inputs.begin(), origin.inputs.end(),
                     [&](const InputFile& f) { return f.path.ends_with(ending); });
}

TEST_F(ReportProgram, ARunSaysWhatItCameFromAndItsPageShowsIt) {
  const std::string scenario =
      dir_.Write("s.yaml", "track: straight\nbogie: phs\nspeed_m_s: 15\nduration_s: 0.2\n");
  Run("simulate " + scenario + " --quiet --out " + Path("out"), "SOURCE_DATE_EPOCH=1700000000 ");
  const auto origin = ReadOrigin(Path("out"));
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->program,
            Execute(PhsCommand("--version")).text.substr(0, origin->program.size()));
  EXPECT_EQ(origin->command, "phs simulate " + scenario + " --quiet --out " + Path("out"));
  EXPECT_EQ(origin->date, "2023-11-14T22:13:20Z");
  for (const char* file : {"/s.yaml", "bogie_xml/phs.xml", "running_gear.xml", "S1002.prw",
                           "UIC60.prr", "tracks/straight.yaml"}) {
    EXPECT_TRUE(Names(*origin, file)) << file;
  }
  for (const InputFile& file : origin->inputs) {
    EXPECT_EQ(file.sha256, Sha256(ReadFile(file.path).value())) << file.path;
  }
  const std::string html = Text("out/report.html");
  EXPECT_TRUE(html.find("2023-11-14, 22:13:20 UTC") != std::string::npos);
  EXPECT_TRUE(html.find(Sha256(ReadFile(scenario).value())) != std::string::npos);
  EXPECT_TRUE(html.find("phs simulate s.yaml --quiet --out out") != std::string::npos);
  EXPECT_TRUE(html.find(dir_.path()) == std::string::npos) << "folders of the machine";
  // Drawn again on another day, the page is the same to the last byte.
  fs::remove(Path("out/report.html"));
  Run("report " + Path("out"));
  EXPECT_TRUE(Text("out/report.html") == html);
}

TEST_F(ReportProgram, TwoRunsDifferByTheirOriginAlone) {
  for (const char* out : {"a", "b"}) {
    Run("rig " + Rig() + " --quiet --out " + Path("same"), "SOURCE_DATE_EPOCH=86400 ");
    fs::rename(Path("same"), Path(out));
  }
  EXPECT_EQ(NamesIn(Path("a")), NamesIn(Path("b")));
  for (const std::string& name : NamesIn(Path("a"))) {
    EXPECT_TRUE(Text("a/" + name) == Text("b/" + name)) << name;
  }
  Run("rig " + Rig() + " --quiet --out " + Path("c"));
  for (const std::string& name : NamesIn(Path("a"))) {
    if (name == "report.html" || name == kOriginFile) continue;
    EXPECT_TRUE(Text("a/" + name) == Text("c/" + name)) << name;
  }
}

TEST_F(ReportProgram, EveryVerbWithAReportShowsItsOrigin) {
  const std::string study = dir_.Write(
      "study.yaml",
      "scenario: " +
          dir_.Write("s.yaml", "track: straight\nbogie: phs\nspeed_m_s: 15\nduration_s: 0.1\n") +
          "\naxes:\n  - {key: scenario.speed_m_s, values: [12, 15]}\n"
          "outputs: [run.max_sum_Y_N]\n");
  const std::vector<std::pair<std::string, std::string>> calls = {
      {"simulate", "simulate " + Path("s.yaml") + " --quiet"},
      {"compare", "compare " + Path("s.yaml") + " --quiet --bogies phs,rigid_link"},
      {"modes", "modes --bogie phs --quiet"},
      {"stability", "stability --bogie phs --quiet --speeds 3 --from 10 --to 30"},
      {"curving", "curving --bogies phs --quiet --radii 600"},
      {"rig", "rig " + Rig() + " --quiet"},
      {"steps", "identify " + Steps() + " --quiet"},
      {"sweep", "sweep " + study + " --quiet"}};
  for (const auto& [name, call] : calls) {
    Run(call + " --out " + Path(name));
    const std::string html = Text(name + "/report.html");
    const auto origin = ReadOrigin(Path(name));
    ASSERT_TRUE(origin) << name;
    ASSERT_FALSE(origin->inputs.empty()) << name;
    EXPECT_TRUE(html.find(origin->inputs[0].sha256) != std::string::npos) << name;
    EXPECT_TRUE(html.find("Where this comes from") != std::string::npos) << name;
    EXPECT_LT(html.size(), 5u << 20) << name;
    if (name == "sweep") {
      EXPECT_TRUE(Names(*origin, "/study.yaml") && Names(*origin, "/s.yaml"));
    } else if (name == "steps") {
      EXPECT_TRUE(Names(*origin, "lowe_table_b1.csv"));
    }
  }
  Run("loads --bogie phs --quiet --out " + Path("loads"));
  EXPECT_TRUE(ReadOrigin(Path("loads")));
  // One index of all of them, and again: nothing changes.
  EXPECT_THAT(Run("report --index " + dir_.path()).text, HasSubstr("9 results, 8 with a report"));
  const std::string index = Text("index.html");
  EXPECT_THAT(Run("report --index " + dir_.path()).text, HasSubstr("index.html"));
  EXPECT_TRUE(Text("index.html") == index);
  for (const auto& [name, call] : calls) {
    EXPECT_TRUE(index.find("href=\"" + name + "/report.html\"") != std::string::npos) << name;
    EXPECT_TRUE(Text(name + "/report.html").find("href=\"../index.html\"") != std::string::npos);
  }
  // A result that stands in the index is still replaced by --force.
  Run("modes --bogie phs --quiet --force --out " + Path("modes"));
  EXPECT_TRUE(Text("modes/report.html").find("href=\"../index.html\"") != std::string::npos);
}

TEST_F(ReportProgram, AStartOfOnesOwnHasNoOrigin) {
  Run("new scenario " + Path("mine"));
  EXPECT_FALSE(fs::exists(Path("mine/origin.json")));
}

TEST_F(ReportProgram, BadInputIsOneLine) {
  const auto refused = [&](const std::string& arguments, const std::string& words, int code) {
    const Output out = ExecutePhs(arguments);
    EXPECT_EQ(out.code, code) << out.text;
    EXPECT_THAT(out.text, HasSubstr(words));
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
  };
  fs::create_directory(Path("results"));
  refused("report --index " + Path("resuls"), "did you mean 'results'?", 3);
  refused("report --index " + Path("results"), "holds no result of phs", 3);
  refused("report --index", "dir is required", 2);
  refused("report --inde " + Path("results"), "did you mean '--index'?", 2);
  refused("report " + Path("results"), "holds no result that a report is drawn from", 3);
  EXPECT_TRUE(fs::is_empty(Path("results")));
}

}  // namespace
}  // namespace phs
