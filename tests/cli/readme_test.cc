// The commands of the README, as written there: each runs from a folder that looks like the source
// tree after scripts/run. Those that take longest only with PHS_LONG_TESTS.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;

/// The lines of the first code block under `heading`.
std::vector<std::string> CommandsUnder(const std::string& heading) {
  std::ifstream file(PHS_SOURCE_DIR "/README.md");
  std::vector<std::string> lines;
  bool under = false;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == heading) under = true;
    if (!under) continue;
    if (line.starts_with("```")) {
      if (inside) break;
      inside = true;
    } else if (inside) {
      lines.push_back(line.substr(0, line.find("  #")));
    }
  }
  return lines;
}

/// Some seconds each, and tested elsewhere.
bool TakesLong(const std::string& command) {
  for (const char* word : {"--radii", "--ramp", " sweep "}) {
    if (command.find(word) != std::string::npos) return true;
  }
  return false;
}

TEST(ReadmeTest, ItsCommandsRunAsWritten) {
  const std::vector<std::string> commands = CommandsUnder("## Ten minutes");
  ASSERT_GT(commands.size(), 10u);
  ASSERT_TRUE(commands[0].starts_with("P=build/release/")) << commands[0];
  const ScratchDir dir;
  fs::create_directories(dir.File("build"));
  fs::create_directory_symlink(PHS_BINARY_DIR, dir.File("build/release"));
  for (const char* folder : {"models", "bogie_xml", "python"}) {
    fs::create_directory_symlink(std::string(PHS_SOURCE_DIR "/") + folder, dir.File(folder));
  }
  const bool all = std::getenv("PHS_LONG_TESTS") != nullptr;
  int ran = 0;
  for (size_t i = 1; i < commands.size(); ++i) {
    const bool preload = commands[i].starts_with("LD_PRELOAD");
#ifdef PHS_SANITIZED
    if (preload) continue;  // a program without the sanitizer's runtime cannot load the library
#endif
    if (preload && Execute("command -v mujoco-testspeed").code != 0) continue;
    if (commands[i].starts_with("PYTHONPATH") &&
        !fs::exists(PHS_BINARY_DIR "/python/phs/__init__.py")) {
      continue;  // built without the Python package
    }
    if (TakesLong(commands[i]) && !all) continue;
    const Output out = Execute("cd " + dir.path() + "; " + commands[0] + "; " + commands[i]);
    EXPECT_EQ(out.code, 0) << commands[i] << "\n" << out.text;
    if (preload) {
      EXPECT_EQ(out.text.find("cannot be preloaded"), std::string::npos) << out.text;
    }
    ++ran;
  }
  EXPECT_GE(ran, 8);
}

/// Every folder of the tree that is not hidden or built stands in the layout, src by its own folders.
TEST(ReadmeTest, TheLayoutNamesEveryFolder) {
  std::ifstream file(PHS_SOURCE_DIR "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const std::string layout = readme.substr(readme.find("## Layout"));
  int named = 0;
  for (const std::string under : {"", "src/"}) {
    for (const auto& entry : fs::directory_iterator(std::string(PHS_SOURCE_DIR "/") + under)) {
      const std::string name = entry.path().filename();
      const bool other = !entry.is_directory() || name.starts_with(".") || name == "src" ||
                         name == "build" || name == "out";
      if (other) continue;
      EXPECT_NE(layout.find("`" + under + name + "`"), std::string::npos) << under + name;
      ++named;
    }
  }
  EXPECT_GT(named, 15);
}

/// What the README says after scripts/run must be there after scripts/run.
TEST(ReadmeTest, TheFirstCommandBuildsWhatTheLaterOnesNeed) {
  const Output built =
      Execute("grep -c 'scripts/build\" release phs phs_mujoco' " PHS_SOURCE_DIR "/scripts/run");
  EXPECT_EQ(built.text, "1\n");
}

}  // namespace
}  // namespace phs
