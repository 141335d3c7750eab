// Loops inside loops share their threads: all work done once, never more threads than allowed.
#include "identify/fit/thread_budget.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace phs::identify::search {
namespace {

/// Waits until `there`; false after so long that only a budget without threads can be the reason.
bool WaitFor(const std::function<bool()>& there) {
  for (int i = 0; i < 60000 && !there(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return there();
}

TEST(ThreadBudget, DoesAllOnceAndKeepsTheLimit) {
  constexpr int kThreads = 3, kOuter = 7, kInner = 11;
  ThreadBudget threads(kThreads);
  std::vector<std::atomic<int>> done(kOuter * kInner);
  std::atomic<int> running{0}, most{0};
  for (int repeat = 1; repeat <= 3; ++repeat) {
    threads.ForEach(kOuter, [&](int i) {
      threads.ForEach(kInner, [&](int k) {
        const int now = ++running;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
        }
        // The first to come waits for company, however slow the machine.
        WaitFor([&] { return most > 1; });
        ++done[static_cast<size_t>(i) * kInner + static_cast<size_t>(k)];
        --running;
      });
    });
    for (const auto& count : done) EXPECT_EQ(count, repeat);
  }
  EXPECT_LE(most, kThreads);
  EXPECT_GT(most, 1);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(ThreadBudget, WithoutThreadsTheCallerDoesItAll) {
  const pid_t child = fork();
  if (child == 0) {
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t bytes = static_cast<rlim_t>(pages) * static_cast<rlim_t>(getpagesize());
    const rlimit no_more_stacks{bytes + (1 << 20), bytes + (1 << 20)};
    setrlimit(RLIMIT_AS, &no_more_stacks);
    ThreadBudget threads(4);
    std::atomic<int> done{0};
    for (int repeat = 0; repeat < 3; ++repeat) threads.ForEach(10, [&](int) { ++done; });
    _exit(done == 30 ? 0 : 1);
  }
  int how = 0;
  waitpid(child, &how, 0);
  EXPECT_EQ(how, 0);
}
#endif

TEST(ThreadBudget, WhoWaitsForAHelperLendsItItsPlace) {
  ThreadBudget threads(2);
  const auto caller = std::this_thread::get_id();
  const auto a_while = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  std::atomic<bool> helper_is_busy{false}, both{false};
  std::atomic<int> inside{0};
  threads.ForEach(2, [&](int) {
    if (std::this_thread::get_id() == caller) {  // has no more work than this
      WaitFor([&] { return helper_is_busy.load(); });
      return;
    }
    helper_is_busy = true;
    // Until the caller has nothing left to do; the limit is for a budget that never lends.
    for (int attempt = 0; attempt < 3000 && !both; ++attempt) {
      threads.ForEach(2, [&](int) {
        ++inside;
        for (int i = 0; i < 20 && !both; ++i) {
          if (inside == 2) both = true;
          a_while();
        }
        --inside;
      });
    }
  });
  EXPECT_TRUE(both);
}

TEST(ThreadBudget, WhoBecomesFreeJoinsALoopThatRuns) {
  ThreadBudget threads(2);
  std::atomic<bool> running{false}, both{false};
  std::atomic<int> inside{0};
  threads.ForEach(2, [&](int i) {
    if (i == 1) {  // has no more work than this
      WaitFor([&] { return running.load(); });
      return;
    }
    threads.ForEach(3000, [&](int) {  // begins with no thread free
      running = true;
      if (++inside == 2) both = true;
      if (!both) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      --inside;
    });
  });
  EXPECT_TRUE(both);
}

TEST(ThreadBudget, WhatAHelperThrowsIsThrownWhereItIsWaitedFor) {
  ThreadBudget threads(2);
  std::atomic<bool> helps = false;
  const std::thread::id caller = std::this_thread::get_id();
  const auto work = [&](int) {
    if (std::this_thread::get_id() == caller) {
      WaitFor([&] { return helps.load(); });
      return;
    }
    helps = true;
    throw std::runtime_error("of a helper");
  };
  EXPECT_THROW(threads.ForEach(1000, work), std::runtime_error);
  std::atomic<int> done = 0;
  threads.ForEach(10, [&](int) { ++done; });
  EXPECT_EQ(done, 10) << "and the budget is as before";
}

TEST(ThreadBudget, OneThreadIsTheCallersOwn) {
  ThreadBudget threads(1);
  const auto caller = std::this_thread::get_id();
  int sum = 0;
  threads.ForEach(5, [&](int i) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    sum += i;
  });
  EXPECT_EQ(sum, 10);
  threads.ForEach(0, [&](int) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace phs::identify::search
