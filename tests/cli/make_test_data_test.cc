// phs make-test-data: records with something hidden, and the score on them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Seed 2 draws a clean set first.
TEST(MakeTestData, ASeedGivesTheSameRecordsAndTheyAreScored) {
  const ScratchDir dir;
  const std::string one = dir.File("one"), two = dir.File("two"), drawn = " --sets 1";
  const Output made = ExecutePhs("make-test-data 2 " + one + drawn + " --score");
  EXPECT_EQ(made.code, 0) << made.text;
  EXPECT_THAT(made.text, HasSubstr("set_001"));
  EXPECT_TRUE(fs::exists(one + "/truth/index.json"));
  EXPECT_TRUE(fs::exists(one + "/results/set_001/result.json"));
  EXPECT_EQ(ExecutePhs("make-test-data 2 " + two + drawn).code, 0);
  EXPECT_FALSE(fs::exists(two + "/results"));
  EXPECT_EQ(Execute("cmp " + one + "/set_001/run.csv " + two + "/set_001/run.csv").code, 0);
}

TEST(MakeTestData, WhatItDoesNotKnowIsWrongUsage) {
  const ScratchDir dir;
  for (const char* suite : {"tun", "-1", "1.5", "1234567890"}) {
    const Output out = ExecutePhs("make-test-data -- " + std::string(suite) + " " + dir.File("d"));
    EXPECT_EQ(out.code, 2) << suite;
    EXPECT_THAT(out.text, HasSubstr("tune, score, holdout, or a seed")) << suite;
  }
  EXPECT_EQ(ExecutePhs("make-test-data tune " + dir.File("d") + " --only pairs").code, 2);
  EXPECT_TRUE(NamesIn(dir.path()).empty());
}

}  // namespace
}  // namespace phs
