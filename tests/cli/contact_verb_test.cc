// phs contact: a wheelset on track, and the contact functions of a pair of profiles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ContactVerbTest : public testing::Test {
 protected:
  ScratchDir dir_;
};

TEST_F(ContactVerbTest, PlacesAWheelsetOnTrack) {
  const std::string cases = dir_.Write("cases.csv",
                                       "note,y_mm,Fz_N,roll_rad,yaw_rad,vs_mm_s,vpitch_rad_s\n"
                                       "a,5,10000,-0.00035540,0.012,2000,-4.33536370\n");
  const std::string out = dir_.File("out.csv");
  const std::string call =
      "contact --wheelset " + cases + " --wheel S1002 --rail UIC60 --out " + out;
  const Output done = ExecutePhs(call);
  EXPECT_EQ(done.code, 0) << done.text;
  std::ifstream file(out);
  std::string names;
  std::getline(file, names);
  EXPECT_THAT(names, HasSubstr("contact_angle_rad"));
  EXPECT_EQ(ExecutePhs(call).code, 3);  // the file is there already
  EXPECT_EQ(ExecutePhs(call + " --force").code, 0);
}

TEST_F(ContactVerbTest, RefusesBadInputInOneLine) {
  const std::string good =
      dir_.Write("c.csv", "y_mm,Fz_N,vs_mm_s,vpitch_rad_s\n0,10000,2000,-4.3\n");
  const std::string bad = dir_.Write("b.csv", "y_mm,Fz_N,vs_mm_s,vpitch_rad_s\n0,1e9,2000,-4.3\n");
  const auto refused = [&](const std::string& arguments, int code, const std::string& words) {
    const Output out = ExecutePhs("contact " + arguments + " --out " + dir_.File("o.csv"));
    EXPECT_EQ(out.code, code) << out.text;
    EXPECT_THAT(out.text, HasSubstr(words));
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1) << out.text;
    EXPECT_FALSE(fs::exists(dir_.File("o.csv")));
  };
  const std::string pair = " --wheel S1002 --rail UIC60";
  refused("", 2, "--wheelset");
  refused("--wheelset " + good + " --cases " + good, 2, "--wheelset");
  refused("--wheelset " + good + " --wheel S1002", 3, "--rail");
  refused("--wheelset " + good + " --wheel S1003 --rail UIC60", 3, "S1002");
  refused("--wheelset " + bad + pair, 3, "b.csv:2");
  refused("--wheelset " + good + pair + " --gauge_m 9", 3, "gauge");
  refused("--wheelset " + dir_.File("none.csv") + pair, 3, "none.csv");
  refused("--wheelset " + dir_.Write("e.inp", "% nothing\n") + pair, 3, "e.inp");
}

TEST_F(ContactVerbTest, FunctionsOfAPair) {
  const std::string call = "contact --functions --wheel S1002 --rail UIC60 --out " +
                           dir_.File("f.csv") + " --report " + dir_.File("f.html");
  const Output done = ExecutePhs(call);
  EXPECT_EQ(done.code, 0) << done.text;
  EXPECT_THAT(done.text, HasSubstr("equivalent conicity"));
  EXPECT_TRUE(fs::exists(dir_.File("f.csv")));
  EXPECT_TRUE(fs::exists(dir_.File("f.html")));
  EXPECT_EQ(ExecutePhs("contact --functions --wheel S1002 --out " + dir_.File("g.csv")).code, 3);
  const Output loaded =
      ExecutePhs("contact --functions --wheel S1002 --rail UIC60 --load_N 100e3 --step_m " +
                 std::string("0.001 --out ") + dir_.File("h.csv"));
  EXPECT_EQ(loaded.code, 0) << loaded.text;
  EXPECT_EQ(ExecutePhs("contact --functions --wheel S1002 --rail UIC60 --load_N -1 --out x").code,
            2);
}

}  // namespace
}  // namespace phs
