// phs simulate and compare --check: exit code 1 and the limit that is missed, by how much.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Output {
  int code = -1;
  std::string errors;
};

class CheckTest : public testing::Test {
 protected:
  CheckTest() : folder_(fs::path(testing::TempDir()) / ("phs_check_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    Write("short.yaml", "track: curve_r550\nspeed_km_h: 60\nduration_s: 0.05\n");
  }
  ~CheckTest() override { fs::remove_all(folder_); }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(Path(name)) << text;
    return Path(name);
  }
  Output Phs(const std::string& verb, const std::string& limits,
             const std::string& more = "") const {
    Output out;
    const std::string command = std::string(PHS_BINARY_DIR "/src/cli/phs ") + verb + " " +
                                Path("short.yaml") + " --quiet --check " +
                                Write("limits.yaml", limits) + " " + more +
                                " 2>&1 >/dev/null </dev/null";
    std::FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    while (const size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) {
      out.errors.append(buffer.data(), n);
    }
    out.code = WEXITSTATUS(pclose(pipe));
    return out;
  }
  fs::path folder_;
};

TEST_F(CheckTest, KeptLimitsAreSilent) {
  const Output out = Phs("simulate", "limits:\n  - {quantity: run.min_Q_N, at_least: 1e3}\n");
  EXPECT_EQ(out.code, 0);
  EXPECT_EQ(out.errors, "");
}

TEST_F(CheckTest, EveryMissedLimitIsOneLineAndJUnitHasIt) {
  const Output out = Phs("compare",
                         "limits:\n  - {quantity: run.min_Q_N, bogie: phs, at_least: 1e9}\n"
                         "  - {quantity: run.steps, at_most: 1}\n"
                         "  - {quantity: ratios.phs_over_rigid_link.run.steps, at_most: 1}\n",
                         "--bogies phs,rigid_link --junit " + Path("junit.xml"));
  EXPECT_EQ(out.code, 1);
  EXPECT_EQ(std::count(out.errors.begin(), out.errors.end(), '\n'), 3) << out.errors;
  EXPECT_THAT(out.errors, HasSubstr("phs: phs: run.min_Q_N is "));
  EXPECT_THAT(out.errors, HasSubstr(" too little"));
  EXPECT_THAT(out.errors, HasSubstr("rigid_link: run.steps is 51, at most 1 allowed: 50 too much"));
  std::ifstream file(Path("junit.xml"));
  const std::string xml{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(xml, HasSubstr("tests=\"6\" failures=\"3\""));
}

TEST_F(CheckTest, WrongLimitsAreBadInputBeforeAnyRun) {
  const Output out = Phs("simulate", "limits:\n  - {quantity: run.min_Q_N, atleast: 1}\n");
  EXPECT_EQ(out.code, 3);
  EXPECT_EQ(std::count(out.errors.begin(), out.errors.end(), '\n'), 1) << out.errors;
}

TEST_F(CheckTest, UnknownQuantityNamesTheNearest) {
  const Output out = Phs("simulate", "limits:\n  - {quantity: run.min_Q, at_least: 1}\n");
  EXPECT_EQ(out.code, 3);
  EXPECT_THAT(out.errors, HasSubstr("did you mean 'run.min_Q_N'?"));
}

}  // namespace
