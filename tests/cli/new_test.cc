// phs new: each commented start runs as it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

class New : public testing::TestWithParam<const char*> {
 protected:
  static std::string Text(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  ScratchDir dir_;
};

TEST_P(New, RunsAsItIs) {
  const std::string folder = dir_.File("mine");
  const Output made = ExecutePhs(std::string("new ") + GetParam() + " " + folder);
  ASSERT_EQ(made.code, 0) << made.text;
  // The command that it prints, with the program of this build.
  const size_t at = made.text.find("&& phs ");
  ASSERT_NE(at, std::string::npos) << made.text;
  std::string command = made.text.substr(at + 7);
  command = command.substr(0, command.find('\n'));
  const Output run = Execute("cd " + folder + " && " + PhsCommand(command + " --quiet"));
  EXPECT_EQ(run.code, 0) << command << "\n" << run.text;
  EXPECT_TRUE(std::filesystem::exists(folder + "/result/report.html")) << run.text;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    // The schema that editors are told of is there.
    const std::string text = Text(entry.path().string());
    const std::string mark = "# yaml-language-server: $schema=";
    ASSERT_EQ(text.find(mark), 0u) << entry.path();
    const std::string schema = text.substr(mark.size(), text.find('\n') - mark.size());
    EXPECT_TRUE(std::filesystem::exists(schema)) << schema;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, New, testing::Values("bogie", "track", "scenario", "study", "rig"),
                         [](const auto& of) { return std::string(of.param); });

TEST(NewInFolder, NothingIsOverwritten) {
  ScratchDir dir;
  dir.Write("notes.txt", "mine");
  const Output refused = ExecutePhs("new track " + dir.File(""));
  EXPECT_EQ(refused.code, 3);
  EXPECT_EQ(refused.text.find("--force"), std::string::npos) << "it has none: " << refused.text;
  EXPECT_TRUE(std::filesystem::exists(dir.File("notes.txt")));
  EXPECT_EQ(ExecutePhs("new trak " + dir.File("x")).code, 2);
}

TEST(NewInFolder, WhatIsPrintedCanBePasted) {
  ScratchDir dir;
  const std::string out = dir.File("a rig's folder");
  const Output made = ExecutePhs("new rig \"" + out + "\"");
  ASSERT_EQ(made.code, 0) << made.text;
  const std::string quoted = dir.File("a rig") + "'\\''s folder'";
  EXPECT_NE(made.text.find("cd '" + quoted + " && "), std::string::npos) << made.text;
}

}  // namespace
}  // namespace phs
