// LD_PRELOAD: a program that knows MuJoCo alone runs the steered bogie, to the last bit as `phs
// simulate` does; Debian's own mujoco-testspeed runs it too.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "phs_places.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

// A program built without the sanitizer's runtime cannot load a library that needs it.
#ifdef PHS_SANITIZED
#define PHS_SKIP_UNDER_SANITIZERS() GTEST_SKIP() << "built with sanitizers"
#else
#define PHS_SKIP_UNDER_SANITIZERS() static_cast<void>(0)
#endif

const char kPreload[] = "LD_PRELOAD=" PHS_BINARY_DIR "/plugin/libphs_mujoco.so ";

std::vector<double> Numbers(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> numbers;
  for (double x = 0; in >> x;) numbers.push_back(x);
  return numbers;
}

TEST(PreloadTest, AForeignProgramFollowsTheSameTrajectoryBitForBit) {
  PHS_SKIP_UNDER_SANITIZERS();
  for (const char* bogie : {"phs", "rigid_link"}) {
    const Output foreign = Execute(std::string(kPreload) + PHS_BINARY_DIR + "/tests/foreign_host " +
                                   BogiePath(bogie) + " 3000");
    ASSERT_EQ(foreign.code, 0) << foreign.text;
    EngineGuard guard;
    const ModelPtr m = LoadFile(BogiePath(bogie));
    ASSERT_TRUE(Attach(m.get(), {}).ok());
    const DataPtr d(mj_makeData(m.get()));
    ResetToStart(m.get(), d.get());
    for (int i = 0; i < 3000; ++i) mj_step(m.get(), d.get());
    EXPECT_EQ(Numbers(foreign.text), std::vector<double>(d->qpos, d->qpos + m->nq)) << bogie;
  }
}

TEST(PreloadTest, CopiesAndCallbacksOfTheProgramChangeNoBit) {
  PHS_SKIP_UNDER_SANITIZERS();
  const std::string host =
      std::string(kPreload) + PHS_BINARY_DIR + "/tests/foreign_host " + BogiePath("phs") + " 500";
  const Output plain = Execute(host);
  ASSERT_EQ(plain.code, 0) << plain.text;
  for (const char* manner : {" copy", " save", " replace", " chain"}) {
    const Output out = Execute(host + manner);
    EXPECT_EQ(out.code, 0) << manner;
    EXPECT_EQ(out.text, plain.text) << manner;
  }
}

TEST(PreloadTest, ARunThatMuJoCoResetsIsTold) {
  PHS_SKIP_UNDER_SANITIZERS();
  const std::string host =
      std::string(kPreload) + PHS_BINARY_DIR + "/tests/foreign_host " + BogiePath("phs");
  EXPECT_NE(Execute(host + " 200 coarse").text.find("phs: the run diverged at t = "),
            std::string::npos);
  EXPECT_EQ(Execute(host + " 200").text.find("diverged"), std::string::npos);
}

TEST(PreloadTest, WithoutThePluginTheSameProgramFallsFreely) {
  const Output bare =
      Execute(std::string(PHS_BINARY_DIR) + "/tests/foreign_host " + BogiePath("phs") + " 1000");
  ASSERT_EQ(bare.code, 0) << bare.text;
  EXPECT_LT(Numbers(bare.text).at(2), -1);  // one second of free fall
}

TEST(PreloadTest, AModelThatCannotBeAttachedIsRefusedWithTheReason) {
  PHS_SKIP_UNDER_SANITIZERS();
  const Output out = Execute("PHS_OPTIONS=track=nowhere " + std::string(kPreload) + PHS_BINARY_DIR +
                             "/tests/foreign_host " + BogiePath("phs") + " 10");
  EXPECT_NE(out.code, 0);
  EXPECT_NE(out.text.find("track 'nowhere'"), std::string::npos) << out.text;
}

TEST(PreloadTest, FailuresOfTheHydraulicsAreOptions) {
  PHS_SKIP_UNDER_SANITIZERS();
  const std::string host =
      std::string(kPreload) + PHS_BINARY_DIR + "/tests/foreign_host " + BogiePath("phs");
  const Output whole = Execute(host + " 200");
  const Output failed = Execute("PHS_OPTIONS=failures=reservoir_gas_lost:L2 " + host + " 200");
  ASSERT_EQ(failed.code, 0) << failed.text;
  EXPECT_NE(Numbers(failed.text), Numbers(whole.text));
  // The flow of a burst line is a state: the plain model has no activation to carry it.
  const Output burst = Execute("PHS_OPTIONS=failures=line_burst:L1:0.5 " + host + " 10");
  EXPECT_NE(burst.code, 0);
  EXPECT_NE(burst.text.find("append 1 state carrier"), std::string::npos) << burst.text;
  const Output wrong = Execute("PHS_OPTIONS=failures=line_burst:L1:soon " + host + " 10");
  EXPECT_NE(wrong.text.find("'soon' is no time"), std::string::npos) << wrong.text;
}

TEST(PreloadTest, DebiansOwnTestspeedRunsTheSteeredBogie) {
  PHS_SKIP_UNDER_SANITIZERS();
  if (Execute("command -v mujoco-testspeed").code != 0)
    GTEST_SKIP() << "libmujoco-samples not installed";
  const std::string trace = ScratchFile("trace.csv");
  const Output out = Execute("PHS_TRACE=" + trace + " " + kPreload + "mujoco-testspeed " +
                             BogiePath("phs") + " 2000");
  ASSERT_EQ(out.code, 0) << out.text;
  EXPECT_NE(out.text.find("Simulation time"), std::string::npos) << out.text;
  // Its trajectory is the same one.
  EngineGuard guard;
  const ModelPtr m = LoadFile(BogiePath("phs"));
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  ResetToStart(m.get(), d.get());
  for (int i = 0; i < 2000; ++i) mj_step(m.get(), d.get());
  const Output last = Execute("tail -n 1 " + trace + " | tr ',' ' '");
  std::vector<double> expected = {d->time};
  expected.insert(expected.end(), d->qpos, d->qpos + m->nq);
  EXPECT_EQ(Numbers(last.text), expected);
  std::remove(trace.c_str());
}

}  // namespace
}  // namespace phs::plugin
