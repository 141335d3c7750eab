// `phs identify` from outside on poor data: one clear line on what cannot be identified and why,
// and no result left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class IdentifyProgramTest : public testing::Test {
 protected:
  IdentifyProgramTest()
      : folder_(
            fs::path(testing::TempDir()) /
            ("phs_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "manifest.yaml")
        << "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n"
           "estimation: [0, 30]\nvalidation: [30, 50]\n";
  }
  ~IdentifyProgramTest() override { fs::remove_all(folder_); }

  /// Rows at 50 Hz of the motion `x` and a load cell that follows it.
  void Write(int rows, const std::function<double(double)>& x) const {
    std::ofstream out(folder_ / "run.csv");
    out << "t_s,actuator_m,load_cell_N\n";
    for (int i = 0; i < rows; ++i) {
      const double t = 0.02 * i, noise = 1e-6 * std::sin(1e4 * i * i);
      out << t << ',' << x(t) + noise << ',' << 4e7 * x(t) + 1e8 * noise << '\n';
    }
  }
  void ExpectRefused(const std::string& words) const {
    const std::string command = PHS_BINARY_DIR "/src/cli/phs identify " +
                                (folder_ / "manifest.yaml").string() + " --quiet --out " +
                                (folder_ / "out").string() + " 2>&1 </dev/null";
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::array<char, 4096> buffer{};
    while (const size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) {
      text.append(buffer.data(), n);
    }
    EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 3) << text;
    EXPECT_THAT(text, HasSubstr(words));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
  fs::path folder_;
};

TEST_F(IdentifyProgramTest, ConstantInput) {
  Write(2500, [](double) { return 1e-3; });
  ExpectRefused("nothing can be identified from a constant input");
}

TEST_F(IdentifyProgramTest, NoReversal) {
  Write(2500, [](double t) { return 1e-4 * t; });
  ExpectRefused("friction and stiffness cannot be told apart");
}

TEST_F(IdentifyProgramTest, TenSamples) {
  Write(10, [](double t) { return 1e-3 * std::sin(t); });
  ExpectRefused("10 samples: too few");
}

TEST_F(IdentifyProgramTest, NothingButHoles) {
  Write(2500, [](double) { return NAN; });
  ExpectRefused("actuator_m");
}

TEST_F(IdentifyProgramTest, NoOutput) {
  std::ofstream out(folder_ / "run.csv");
  out << "t_s,actuator_m\n";
  for (int i = 0; i < 2500; ++i) out << 0.02 * i << ',' << 1e-3 * std::sin(0.02 * i) << '\n';
  out.close();
  ExpectRefused("no channel to compare with");
}

TEST_F(IdentifyProgramTest, WindowOutsideTheRecord) {
  Write(400, [](double t) { return 1e-3 * std::sin(3 * t); });
  ExpectRefused("validation");
}

}  // namespace
