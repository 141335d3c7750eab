// The alarm for a lost hose: signals by closed form, Gumbel's law and its error against drawn
// samples, Poisson's bound against its published values.
#include "analysis/line_alarm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace phs::analysis {
namespace {

const PairSignal& Named(const std::vector<PairSignal>& all, int first, int second,
                        const std::string& form, bool above) {
  for (const PairSignal& s : all) {
    if (s.first == first && s.second == second && s.form->name == form && s.above == above)
      return s;
  }
  throw std::runtime_error("no such signal");
}

TEST(LineAlarmTest, FourLinesHaveSixPairsInThreeFormsAndTwoSides) {
  EXPECT_EQ(PairSignals(4).size(), 6u * 3 * 2);
}

TEST(LineAlarmTest, ASignalIsItsPairBehindALagOfFirstOrder) {
  const double h = 0.01, tau = 0.4;
  std::vector<std::vector<double>> p(2, std::vector<double>(200, 2e6));
  for (size_t i = 100; i < 200; ++i) p[1][i] = 0.1e6;
  const auto all = PairSignals(2);
  const auto difference = CalcSignal(Named(all, 0, 1, "difference", true), p, h, tau);
  const auto sum = CalcSignal(Named(all, 0, 1, "sum", false), p, h, tau);
  const auto ratio = CalcSignal(Named(all, 0, 1, "ratio", true), p, h, 0);
  EXPECT_DOUBLE_EQ(difference[99], 0);
  EXPECT_DOUBLE_EQ(sum[99], -4e6) << "turned: it alarms above";
  for (const size_t i : {100u, 120u, 199u}) {
    const double share = 1 - std::exp(-static_cast<double>(i - 99) * h / tau);
    EXPECT_NEAR(difference[i], 1.9e6 * share, 1e-3) << i;
    EXPECT_NEAR(sum[i], -4e6 + 1.9e6 * share, 1e-3) << i;
    EXPECT_NEAR(ratio[i], std::log(20.0), 1e-12) << i;
  }
}

TEST(LineAlarmTest, BlocksAreWholeAndKnowTheirLargest) {
  std::vector<double> place, signal;
  for (int i = 0; i <= 35; ++i) {
    place.push_back(100 + i);
    signal.push_back(i % 10 == 3 ? i : -1);
  }
  const auto maxima = BlockMaxima(place, signal, 10);
  EXPECT_EQ(maxima, (std::vector<double>{3, 13, 23}));
}

TEST(LineAlarmTest, GumbelIsFoundAgainAndItsErrorIsThatOfRepeatedDraws) {
  std::mt19937_64 draw(7);
  std::uniform_real_distribution<double> uniform(1e-12, 1);
  const double m = 3, s = 0.5, r = 1e-3, level = m - s * std::log(-std::log(1 - r));
  const int repeats = 4000, n = 60;
  double sum = 0, squares = 0, told = 0;
  for (int k = 0; k < repeats; ++k) {
    std::vector<double> x(n);
    for (double& value : x) value = m - s * std::log(-std::log(uniform(draw)));
    const Gumbel g = FitGumbel(x);
    sum += g.Level(r), squares += g.Level(r) * g.Level(r), told += g.LevelError(r);
  }
  const double mean = sum / repeats, spread = std::sqrt(squares / repeats - mean * mean);
  EXPECT_NEAR(mean, level, 0.02);
  EXPECT_NEAR(told / repeats, spread, 0.06 * spread);
}

TEST(LineAlarmTest, AlarmsThatComeAgainAtOnceAreOne) {
  const std::vector<double> x = {0, 2, 0, 2, 0, 0, 0, 0, 2, 2, 0};
  EXPECT_EQ(CountAlarms(x, 1, 1, 2), 2);
  EXPECT_EQ(CountAlarms(x, 1, 1, 10), 1);
  EXPECT_EQ(CountAlarms(x, 3, 1, 2), 0);
}

// Garwood (1936), one-sided 95 %: 3.00, 4.74, 6.30 for 0, 1, 2 counts.
TEST(LineAlarmTest, PoissonBoundIsGarwoods) {
  EXPECT_NEAR(PoissonUpper(0), 2.996, 5e-4);
  EXPECT_NEAR(PoissonUpper(1), 4.744, 5e-4);
  EXPECT_NEAR(PoissonUpper(2), 6.296, 5e-4);
}

}  // namespace
}  // namespace phs::analysis
