// The balance of a step that a mass takes (src/rigs/implicit_move.h), against roots known beforehand.
#include "rigs/implicit_move.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace phs::rigs {
namespace {

/// Inertia, a spring, friction that turns over within `width`, and a stop at `stop` [m], less a pull.
struct Held {
  double mass, spring, friction, width, stop, pull;
  double operator()(double x) const {
    const double wall = x > stop ? 1e9 * (x - stop) : 0;
    return mass * x + spring * x + friction * std::clamp(x / width, -1.0, 1.0) + wall - pull;
  }
};

double Slope(const Held& held, double x) { return (held(x + 1e-9) - held(x - 1e-9)) / 2e-9; }

TEST(FindMove, FindsTheBalanceFromAnyGuessAndEndsThere) {
  std::mt19937 random(20261127);
  std::uniform_real_distribution<double> power(-1, 1), part(-1, 1);
  const auto draw = [&](double middle, double decades) {
    return middle * std::pow(10, decades * power(random));
  };
  int most = 0;
  for (int k = 0; k < 3000; ++k) {
    Held held{draw(1e5, 3), draw(1e6, 3), draw(1e3, 2), draw(1e-6, 3), draw(1e-3, 2), 0};
    const double root = 2e-3 * part(random) * std::abs(part(random));
    held.pull = held(root);
    MoveGuess guess{draw(held.mass, 6)};
    int calls = 0;
    double last = 0;
    const double found = FindMove(1e-3 * part(random), held.mass, &guess, [&](double x) {
      ++calls, last = x;
      return held(x);
    });
    EXPECT_EQ(last, found);
    // Within 1e-5 of the force, or 1e-11 of the move.
    EXPECT_NEAR(found, root, 1e-5 / held.mass + 2e-14 + 2e-11 * std::abs(root)) << k;
    most = std::max(most, calls);
  }
  EXPECT_LE(most, 80);
}

TEST(FindMove, AGuessThatHoldsTakesTwoCalls) {
  const Held held{4e5, 3e6, 0, 1, 1, 250};
  MoveGuess guess{Slope(held, 0)};
  int calls = 0;
  const double found = FindMove(0, held.mass, &guess, [&](double x) { return ++calls, held(x); });
  EXPECT_NEAR(found, 250 / 3.4e6, 1e-15);
  EXPECT_EQ(calls, 2);
  EXPECT_NEAR(guess.slope, 3.4e6, 1);
}

TEST(FindMove, ABalanceAtTheStartIsLeftThere) {
  MoveGuess guess;
  int calls = 0;
  EXPECT_EQ(FindMove(1e-4, 1e5, &guess, [&](double x) { return ++calls, 1e6 * (x - 1e-4); }), 1e-4);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(guess.slope, 1e5);  // nothing was learnt: what the mass alone holds
}

}  // namespace
}  // namespace phs::rigs
