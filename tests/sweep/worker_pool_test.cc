#include "sweep/worker_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>

#include "tests/base/scratch_dir.h"

namespace phs::sweep {
namespace {

using testing::HasSubstr;

struct Tally {
  std::map<int, std::string> done;  ///< run -> reason if lost
};

PoolEvents Counting(Tally* tally, std::function<Status(int, int)> work) {
  PoolEvents events;
  events.work = std::move(work);
  events.done = [tally](int run, const LostRun* lost) -> Status {
    EXPECT_EQ(tally->done.count(run), 0u) << "made twice: " << run;
    tally->done[run] = lost == nullptr ? "" : lost->reason;
    return {};
  };
  events.go_on = [] { return true; };
  return events;
}

std::vector<int> Numbers(int count) {
  std::vector<int> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(i);
  return numbers;
}

TEST(WorkerPool, EachRunIsMadeOnceWhateverTheNumberOfWorkers) {
  for (int workers : {1, 2, 7, 60}) {
    const ScratchDir dir;
    Tally tally;
    const auto events = Counting(&tally, [&](int run, int) -> Status {
      std::ofstream(dir.File(std::to_string(run))) << run;
      return {};
    });
    const auto all = RunPool(Numbers(50), {.workers = workers}, events);
    ASSERT_TRUE(all.ok() && all.value());
    EXPECT_EQ(tally.done.size(), 50u);
    EXPECT_EQ(NamesIn(dir.path()).size(), 50u);
  }
}

// Every run waits for the others, so that they are only made if all workers work at once. The limit
// ends a pool that does not.
TEST(WorkerPool, AllWorkersWorkAtOnce) {
  constexpr int kWorkers = 4;
  const ScratchDir dir;
  Tally tally;
  const auto events = Counting(&tally, [&](int run, int) -> Status {
    std::ofstream(dir.File(std::to_string(run))) << run;
    while (NamesIn(dir.path()).size() < kWorkers) usleep(1000);
    return {};
  });
  const auto all = RunPool(Numbers(kWorkers), {.workers = kWorkers, .time_limit_s = 60}, events);
  ASSERT_TRUE(all.ok() && all.value());
  for (const auto& [run, reason] : tally.done) EXPECT_EQ(reason, "") << run;
}

TEST(WorkerPool, AWorkerThatDiesCostsItsRunAlone) {
  Tally tally;
  const auto events = Counting(&tally, [](int run, int) -> Status {
    if (run == 3) raise(SIGKILL);
    if (run == 5) std::_Exit(7);
    return {};
  });
  const auto all = RunPool(Numbers(10), {.workers = 2}, events);
  ASSERT_TRUE(all.ok() && all.value());
  ASSERT_EQ(tally.done.size(), 10u);
  EXPECT_THAT(tally.done[3], HasSubstr("signal 9"));
  EXPECT_THAT(tally.done[5], HasSubstr("exit code 7"));
  for (int run : {0, 1, 2, 4, 6, 7, 8, 9}) EXPECT_EQ(tally.done[run], "") << run;
}

TEST(WorkerPool, ARunThatHangsIsEndedAndNamed) {
  Tally tally;
  const auto events = Counting(&tally, [](int run, int) -> Status {
    if (run == 1) pause();
    return {};
  });
  const auto all = RunPool(Numbers(4), {.workers = 2, .time_limit_s = 0.3}, events);
  ASSERT_TRUE(all.ok() && all.value());
  EXPECT_THAT(tally.done[1], HasSubstr("time limit of 0.3 s"));
  EXPECT_EQ(tally.done.size(), 4u);
}

TEST(WorkerPool, AResultThatCannotBeKeptStopsThePool) {
  Tally tally;
  const auto events = Counting(&tally, [](int run, int) -> Status {
    if (run == 2) return Error{"runs/2", "no space left", "", ""};
    return {};
  });
  const auto all = RunPool(Numbers(1000), {.workers = 1}, events);
  ASSERT_FALSE(all.ok());
  EXPECT_THAT(all.error().Line(), HasSubstr("no space left"));
  EXPECT_EQ(tally.done.size(), 2u);
}

TEST(WorkerPool, StopsWhenTold) {
  Tally tally;
  auto events = Counting(&tally, [](int, int) -> Status {
    usleep(10000);
    return {};
  });
  events.go_on = [&] { return tally.done.size() < 3; };
  const auto all = RunPool(Numbers(1000), {.workers = 2}, events);
  ASSERT_TRUE(all.ok());
  EXPECT_FALSE(all.value());
  EXPECT_LT(tally.done.size(), 20u);
}

}  // namespace
}  // namespace phs::sweep
