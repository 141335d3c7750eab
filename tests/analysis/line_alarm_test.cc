// The alarm for a lost hose: signals by closed form, Gumbel's law and its error against drawn
// samples, Poisson's bound against its published values.
#include "analysis/line_alarm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace phs::analysis {
namespace {

const PairSignal& Named(const std::vector<PairSignal>& all, int first, int second,
                        const std::string& form, bool above, bool against_mean = false) {
  for (const PairSignal& s : all) {
    if (s.first == first && s.second == second && s.form->name == form && s.above == above &&
        s.against_mean == against_mean)
      return s;
  }
  throw std::runtime_error("no such signal");
}

TEST(LineAlarmTest, FourLinesHaveSixPairsInEveryFormWithAndWithoutMeanAndTwoSides) {
  EXPECT_EQ(PairSignals(4).size(), 6u * PairForms().size() * 2 * 2);
}

TEST(LineAlarmTest, ASignalIsItsPairBehindALagOfFirstOrder) {
  const double h = 0.01, tau = 0.4;
  std::vector<std::vector<double>> p(2, std::vector<double>(200, 2e6));
  for (size_t i = 100; i < 200; ++i) p[1][i] = 0.1e6;
  const auto all = PairSignals(2);
  const auto difference = CalcSignal(Named(all, 0, 1, "difference", true), p, h, {.lag_s = tau});
  const auto sum = CalcSignal(Named(all, 0, 1, "sum", false), p, h, {.lag_s = tau});
  const auto ratio = CalcSignal(Named(all, 0, 1, "ratio", true), p, h, {.lag_s = 0});
  EXPECT_DOUBLE_EQ(difference[99], 0);
  EXPECT_DOUBLE_EQ(sum[99], -4e6) << "turned: it alarms above";
  for (const size_t i : {100u, 120u, 199u}) {
    const double share = 1 - std::exp(-static_cast<double>(i - 99) * h / tau);
    EXPECT_NEAR(difference[i], 1.9e6 * share, 1e-3) << i;
    EXPECT_NEAR(sum[i], -4e6 + 1.9e6 * share, 1e-3) << i;
    EXPECT_NEAR(ratio[i], std::log(20.0), 1e-12) << i;
  }
}

// Oil moved over gas of one temperature: p0/(1 - u/V) and p0/(1 + u/V).
TEST(LineAlarmTest, SumAndProductFeelMovedOilBySquareAndATornHoseAtOnce) {
  const double p0 = 2e6, share = 0.2;
  const std::vector<std::vector<double>> moved = {{p0 / (1 - share)}, {p0 / (1 + share)}};
  const auto all = PairSignals(2);
  const auto at = [&](const char* form, const std::vector<std::vector<double>>& p) {
    return CalcSignal(Named(all, 0, 1, form, true), p, 0.01, {.lag_s = 0})[0];
  };
  EXPECT_NEAR(at("product", moved), std::log(4.0) - std::log(1 - share * share), 1e-12);
  EXPECT_NEAR(at("sum", moved), 2 * p0 / (1 - share * share), 1e-3);
  EXPECT_NEAR(at("product", {{p0}, {101325}}), std::log(2 * 0.101325), 1e-12);
}

// Four lines that cool together keep it, traction that presses one cross line and frees the other
// moves it by the square, a torn hose lowers it by ln(p0/p_atm).
TEST(LineAlarmTest, OverTheRestTheLevelDoesNotCount) {
  const auto all = PairSignals(4);
  const auto at = [&](std::vector<std::vector<double>> p) {
    return CalcSignal(Named(all, 1, 2, "product over rest", true), p, 0.01, {.lag_s = 0})[0];
  };
  const double rest = at({{2.6e6}, {2.2e6}, {2.2e6}, {2.6e6}});
  EXPECT_NEAR(rest, 2 * std::log(2.2 / 2.6), 1e-12);
  EXPECT_NEAR(at({{0.65e6}, {0.55e6}, {0.55e6}, {0.65e6}}), rest, 1e-12);
  EXPECT_NEAR(at({{2.6e6 / 0.7}, {2.2e6}, {2.2e6}, {2.6e6 / 1.3}}), rest + std::log(0.91), 1e-12);
  EXPECT_NEAR(at({{2.6e6}, {101325}, {2.2e6}, {2.6e6}}), rest - std::log(2.2e6 / 101325), 1e-12);
}

TEST(LineAlarmTest, TwoLinesHaveNoRest) {
  EXPECT_EQ(PairSignals(2).size(), (PairForms().size() - 1) * 2 * 2);
}

TEST(LineAlarmTest, AgainstItsMeanASlowLevelIsForgottenAndAStepIsNot) {
  const double h = 0.1, T = 20;
  std::vector<std::vector<double>> p(2, std::vector<double>(4000, 1e6));
  for (size_t i = 3000; i < 4000; ++i) p[0][i] = 3e6;
  const auto x =
      CalcSignal(Named(PairSignals(2), 0, 1, "sum", true, true), p, h, {.lag_s = 0, .mean_s = T});
  EXPECT_NEAR(x[2999], 0, 1e-3);
  // After the step of 2 MPa: what a mean over T has not yet taken up.
  for (const size_t n : {1u, 100u, 200u}) {
    EXPECT_NEAR(x[2999 + n], 2e6 * std::exp(-static_cast<double>(n) * h / T), 10) << n;
  }
  EXPECT_NEAR(CalcSignal(Named(PairSignals(2), 0, 1, "sum", true, true), p, h,
                         {.lag_s = 0, .mean_s = 1e9})[3999],
              4e6 - (3000 * 2e6 + 1000 * 4e6) / 4000, 10)
      << "in the beginning the mean is that of all rows";
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

/// Drawn from a law of extremes by its quantile function, written out here once more.
std::vector<double> Drawn(double m, double s, double k, int n, std::mt19937_64* draw) {
  std::uniform_real_distribution<double> uniform(1e-12, 1);
  std::vector<double> x;
  for (int i = 0; i < n; ++i) {
    const double e = -std::log(uniform(*draw));
    x.push_back(k == 0 ? m - s * std::log(e) : m + s * (1 - std::pow(e, k)) / k);
  }
  return x;
}

TEST(LineAlarmTest, TheLawOfExtremesIsFoundAgain) {
  std::mt19937_64 draw(7);
  for (const double k : {0.0, -0.15}) {
    const Extremes law = FitExtremes(Drawn(3, 0.5, k, 200000, &draw));
    EXPECT_NEAR(law.location, 3, 0.01) << k;
    EXPECT_NEAR(law.scale, 0.5, 0.01) << k;
    EXPECT_NEAR(law.shape, k, 0.01) << k;
    const double r = 1e-3, e = -std::log(1 - r);
    const double level = k == 0 ? 3 - 0.5 * std::log(e) : 3 + 0.5 * (1 - std::pow(e, k)) / k;
    EXPECT_NEAR(law.Level(r), level, 0.1) << k;
  }
  EXPECT_EQ(FitExtremes(Drawn(3, 0.5, 0.3, 1000, &draw)).shape, 0) << "no lighter than Gumbel's";
}

// The true level lies below the upper end in 95 of 100 repetitions.
// A line with one place of twelve where the signal goes far beyond what it does elsewhere. Blocks of
// one place each are of two kinds, which the law takes for a heavy tail; blocks of the whole line are
// of one kind. Wanted is what one of 7000 lines passes (0.1 in 1000 km, four
// hoses, 5.7 km): of the far place's normal law 5 + 0.3 · 3.63.
TEST(LineAlarmTest, BlocksOfSeveralKindsLookLikeAHeavyTail) {
  std::mt19937_64 draw(3);
  std::normal_distribution<double> noise(0, 0.3);
  std::vector<double> places, lines;
  for (int line = 0; line < 30; ++line) {
    for (int place = 0; place < 12; ++place) places.push_back(noise(draw) + (place == 7 ? 5 : 0));
    lines.push_back(*std::max_element(places.end() - 12, places.end()));
  }
  const double of_lines = FitExtremes(lines).UpperLevel(1.43e-4);
  const double of_places = FitExtremes(places).UpperLevel(1.43e-4 / 12);
  EXPECT_GT(of_lines, 5 + 0.3 * 3.63);
  EXPECT_LT(of_lines, 15);
  EXPECT_GT(of_places, 3 * of_lines);
}

TEST(LineAlarmTest, TheUpperEndCoversTheTrueLevel) {
  std::mt19937_64 draw(11);
  const double r = 1e-3, level = 3 - 0.5 * std::log(-std::log(1 - r));
  int below = 0;
  const int repeats = 200;
  for (int i = 0; i < repeats; ++i) {
    below += FitExtremes(Drawn(3, 0.5, 0, 80, &draw)).UpperLevel(r) > level ? 1 : 0;
  }
  EXPECT_GT(below, 0.9 * repeats);
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
