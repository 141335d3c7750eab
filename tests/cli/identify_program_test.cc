// `phs identify` from outside on poor data: one clear line on what cannot be identified and why,
// and no result left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

using testing::HasSubstr;

class IdentifyProgramTest : public testing::Test {
 protected:
  IdentifyProgramTest() {
    dir_.Write("manifest.yaml",
               "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n"
               "estimation: [0, 30]\nvalidation: [30, 50]\n");
  }

  /// Rows at 50 Hz of the motion `x` and a load cell that follows it.
  void Write(int rows, const std::function<double(double)>& x) const {
    std::ofstream out(dir_.File("run.csv"));
    out << "t_s,actuator_m,load_cell_N\n";
    for (int i = 0; i < rows; ++i) {
      const double t = 0.02 * i, noise = 1e-6 * std::sin(1e4 * i * i);
      out << t << ',' << x(t) + noise << ',' << 4e7 * x(t) + 1e8 * noise << '\n';
    }
  }
  void ExpectRefused(const std::string& words, const std::string& options = "") const {
    const Output out = ExecutePhs("identify " + dir_.File("manifest.yaml") + " --quiet --out " +
                                  dir_.File("out") + options);
    EXPECT_EQ(out.code, 3) << out.text;
    EXPECT_THAT(out.text, HasSubstr(words));
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
    EXPECT_FALSE(std::filesystem::exists(dir_.File("out")));
  }
  ScratchDir dir_;
};

TEST_F(IdentifyProgramTest, ConstantInput) {
  Write(2500, [](double) { return 1e-3; });
  ExpectRefused("nothing can be identified from a constant input");
}

TEST_F(IdentifyProgramTest, UnknownCandidate) {
  Write(2500, [](double t) { return 1e-3 * std::sin(t); });
  dir_.Write("manifest.yaml",
             "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n"
             "estimation: [0, 30]\nvalidation: [30, 50]\ncandidates: [backlsh]\n");
  ExpectRefused("did you mean 'backlash'?");
  ExpectRefused("manifest.yaml: candidates: backlsh");
  dir_.Write("manifest.yaml",
             "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n"
             "estimation: [0, 30]\nvalidation: [30, 50]\nfree: [fricton.scale]\n");
  ExpectRefused("manifest.yaml: free: fricton.scale");
}

TEST_F(IdentifyProgramTest, NumbersOfTheRule) {
  Write(2500, [](double t) { return 1e-3 * std::sin(t); });
  ExpectRefused("NAME=VALUE with false_alarms, least_share, noise_known",
                " --rule false_alarm=0.1");
  ExpectRefused("is out of range; allowed: false_alarms = 1e-12 … 0.5", " --rule false_alarms=2");
  ExpectRefused("is out of range", " --rule least_share=a_third");
}

TEST_F(IdentifyProgramTest, TheTwoEffectsOfAQuestion) {
  Write(2500, [](double t) { return 1e-3 * std::sin(t); });
  ExpectRefused("asks for two different effects", " --between backlash");
  ExpectRefused("asks for two different effects", " --between backlash,backlash");
  ExpectRefused("backlsh is no effect that is tried on this record",
                " --between mount_compliance,backlsh");
  ExpectRefused("did you mean 'backlash'?", " --between 'mount_compliance, backlsh'");
  for (const char* rig : {"hidden_bogie", "steps_setup2"}) {
    const Output out = ExecutePhs(std::string("identify ") + rig + " --quiet --out " +
                                  dir_.File("out") + " --between backlash,mount_compliance");
    EXPECT_EQ(out.code, 3) << out.text;
    EXPECT_THAT(out.text, HasSubstr("rigs cylinder, quarter, full, element"));
  }
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
  std::ofstream out(dir_.File("run.csv"));
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
}  // namespace phs
