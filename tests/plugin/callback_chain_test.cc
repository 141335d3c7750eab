// Callbacks shared with others: each is called once per engine call, in any order of events.
#include "plugin/callback_chain.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

namespace phs::plugin {
namespace {

struct Model {};
struct Data {
  int ours = 0;
  int first = 0;     // a function that was there before
  int user = 0;      // a function that chains
  int other = 0;     // another one that chains
  int switched = 0;  // a function that replaces and does not chain
};
using Function = void (*)(const Model*, Data*);

/// One engine with one callback; a number makes engines that share nothing.
template <int number>
struct Engine {
  static inline Function slot = nullptr;
  struct Hook {
    using Function = phs::plugin::Function;
    static Function* Slot() { return &slot; }
    template <typename Previous>
    static void Serve(const Previous& previous, const Model*, Data* d) {
      previous();
      ++d->ours;
    }
  };
  using Chain = CallbackChain<Hook>;

  static Data Step() {
    Data d;
    const Model m;
    if (slot != nullptr) slot(&m, &d);
    return d;
  }

  static void First(const Model*, Data* d) { ++d->first; }
  static void Switched(const Model*, Data* d) { ++d->switched; }

  static inline Function user_saved = nullptr;
  static void User(const Model* m, Data* d) {
    ++d->user;
    if (user_saved != nullptr) user_saved(m, d);
  }
  static void InstallUser() {
    user_saved = slot;
    slot = &User;
  }

  static inline Function other_saved = nullptr;
  static void Other(const Model* m, Data* d) {
    ++d->other;
    if (other_saved != nullptr) other_saved(m, d);
  }
  static void InstallOther() {
    other_saved = slot;
    slot = &Other;
  }
};

TEST(CallbackChainTest, WhatWasThereBeforeIsCalledAndGivenBack) {
  using E = Engine<0>;
  E::slot = &E::First;
  ASSERT_TRUE(E::Chain::Install());
  EXPECT_EQ(E::Step().first, 1);
  EXPECT_EQ(E::Step().ours, 1);
  E::Chain::Uninstall();
  EXPECT_EQ(E::slot, &E::First);
}

TEST(CallbackChainTest, AUserThatChainsToOursAndASecondLoadMakeNoCircle) {
  using E = Engine<1>;
  E::slot = &E::First;
  ASSERT_TRUE(E::Chain::Install());
  E::InstallUser();
  ASSERT_TRUE(E::Chain::Install());
  E::InstallOther();
  ASSERT_TRUE(E::Chain::Install());
  const Data d = E::Step();
  EXPECT_EQ(d.ours, 1);
  EXPECT_EQ(d.first, 1);
  EXPECT_EQ(d.user, 1);
  EXPECT_EQ(d.other, 1);
}

TEST(CallbackChainTest, AUserThatTakesTheFrontAgainIsCalledOnce) {
  using E = Engine<2>;
  E::slot = &E::First;
  ASSERT_TRUE(E::Chain::Install());
  E::InstallUser();
  for (int i = 0; i < 100; ++i) {  // far more often than there are layers
    ASSERT_TRUE(E::Chain::Install());
    E::Step();
    E::InstallUser();  // it saves ours, which calls it: a circle
    const Data d = E::Step();
    EXPECT_EQ(d.ours, 1);
    EXPECT_EQ(d.first, 1);
    EXPECT_EQ(d.user, 1);
  }
  ASSERT_TRUE(E::Chain::Install());
  const Data d = E::Step();
  EXPECT_EQ(d.ours, 1);
  EXPECT_EQ(d.first, 1);
  EXPECT_EQ(d.user, 1);
}

TEST(CallbackChainTest, AUserThatPutsBackWhatItSavedIsCalledNoMore) {
  using E = Engine<3>;
  ASSERT_TRUE(E::Chain::Install());
  E::InstallUser();
  ASSERT_TRUE(E::Chain::Install());
  EXPECT_EQ(E::Step().user, 1);
  E::slot = E::user_saved;
  const Data d = E::Step();
  EXPECT_EQ(d.user, 0);
  EXPECT_EQ(d.ours, 1);
}

TEST(CallbackChainTest, AFunctionThatDoesNotChainIsSeenAndComesBehindOurs) {
  using E = Engine<4>;
  ASSERT_TRUE(E::Chain::Install());
  EXPECT_TRUE(E::Chain::Reached());
  E::slot = &E::Switched;
  EXPECT_EQ(E::Step().ours, 0);
  EXPECT_FALSE(E::Chain::Reached());
  ASSERT_TRUE(E::Chain::Install());
  const Data d = E::Step();
  EXPECT_EQ(d.ours, 1);
  EXPECT_EQ(d.switched, 1);
  E::InstallUser();
  EXPECT_FALSE(E::Chain::InFront());
  E::Step();
  EXPECT_TRUE(E::Chain::Reached());
  E::slot = nullptr;
  EXPECT_FALSE(E::Chain::Reached());
}

TEST(CallbackChainTest, AnExceptionOfAUserLeavesTheChainWhole) {
  using E = Engine<5>;
  E::slot = [](const Model*, Data* d) {
    if (++d->first == 1) throw std::runtime_error("of the user");
  };
  ASSERT_TRUE(E::Chain::Install());
  Data d;
  const Model m;
  EXPECT_THROW(E::slot(&m, &d), std::runtime_error);
  E::slot(&m, &d);
  EXPECT_EQ(d.ours, 1);
}

TEST(CallbackChainTest, AUserThatEvaluatesOtherDataInItsCallbackIsServedThereToo) {
  using E = Engine<6>;
  static Data inner;
  E::slot = [](const Model* m, Data* d) {
    if (d != &inner) E::slot(m, &inner);
  };
  ASSERT_TRUE(E::Chain::Install());
  EXPECT_EQ(E::Step().ours, 1);
  EXPECT_EQ(inner.ours, 1);
}

/// Users as they are: install once, take the front again, leave as they came if they can.
TEST(CallbackChainTest, AnyOrderOfEventsCallsEverybodyOnce) {
  using E = Engine<7>;
  std::mt19937 random(7);
  int longest = 0;
  for (int run = 0; run < 300; ++run) {
    E::Chain::Uninstall();
    const bool first = random() % 2 == 0;
    E::slot = first ? &E::First : nullptr;
    bool user = false;
    bool other = false;
    ASSERT_TRUE(E::Chain::Install());
    for (int event = 0; event < 12; ++event) {
      switch (random() % 5) {
        case 0:
          ASSERT_TRUE(E::Chain::Install());
          break;
        case 1:
          if (!user) E::InstallUser();
          user = true;
          break;
        case 2:
          if (!other) E::InstallOther();
          other = true;
          break;
        case 3:
          if (E::slot == &E::User) {
            E::slot = E::user_saved;
            user = false;
          }
          break;
        default:
          if (E::slot == &E::Other) {
            E::slot = E::other_saved;
            other = false;
          }
      }
      const Data d = E::Step();
      ASSERT_EQ(d.ours, 1) << run << " " << event;
      ASSERT_EQ(d.first, first ? 1 : 0) << run << " " << event;
      ASSERT_EQ(d.user, user ? 1 : 0) << run << " " << event;
      ASSERT_EQ(d.other, other ? 1 : 0) << run << " " << event;
      if (user && other) ++longest;
    }
  }
  EXPECT_GT(longest, 500);  // the runs did meet the long chains
}

template <int number>
void Numbered(const Model*, Data*) {}

template <int... number>
std::vector<Function> ManyFunctions(std::integer_sequence<int, number...>) {
  return {&Numbered<number>...};
}

TEST(CallbackChainTest, ThereIsAnEndToTheLayers) {
  using E = Engine<8>;
  int installed = 0;
  for (const Function f : ManyFunctions(std::make_integer_sequence<int, 40>())) {
    E::slot = f;
    if (E::Chain::Install()) ++installed;
  }
  EXPECT_EQ(installed, E::Chain::kLayers);
}

/// Under the thread sanitizer this finds unguarded reads and writes.
TEST(CallbackChainTest, ThreadsStepWhileOthersComeAndGo) {
  using E = Engine<9>;
  E::slot = &E::First;
  ASSERT_TRUE(E::Chain::Install());
  const Function front = E::slot;
  std::atomic<bool> stop{false};
  std::atomic<long> wrong{0};
  std::atomic<long> steps{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
      const Model m;
      while (!stop) {
        Data d;
        front(&m, &d);  // what an engine call under way has read
        if (d.ours != 1 || d.first != 1) ++wrong;
        ++steps;
      }
    });
  }
  for (int i = 0; i < 20000 || steps < 20000; ++i) {
    E::Chain::Uninstall();
    E::Chain::Install();
  }
  stop = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace phs::plugin
