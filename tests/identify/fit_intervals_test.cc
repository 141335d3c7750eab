// Intervals against drawn noise: how often do they hold the truth?
#include "identify/fit/fit_intervals.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <random>

namespace phs::identify::search {
namespace {

constexpr int kDrawnRows = 2000, kNumbers = 5;

/// An offset and slow waves, which a few coefficients of the slowest octaves tell.
Eigen::MatrixXd SlowColumns() {
  Eigen::MatrixXd columns(kDrawnRows, kNumbers);
  for (int i = 0; i < kDrawnRows; ++i) {
    const double t = static_cast<double>(i) / kDrawnRows;
    columns.row(i) << 1, std::sin(2 * M_PI * 4.2 * t), std::cos(2 * M_PI * 4.2 * t),
        std::sin(2 * M_PI * 11 * t), std::cos(2 * M_PI * 26 * t);
  }
  return columns;
}

/// Remembers three samples; seven times what its differences alone would say at slow frequencies.
Eigen::VectorXd ColouredNoise(std::mt19937* random) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd noise(kDrawnRows);
  double at = normal(*random);
  for (double& x : noise) x = at = 0.7 * at + std::sqrt(1 - 0.49) * normal(*random);
  return noise / 0.5;
}

/// Shares of 95 % intervals that hold the truth (0) in fits whose powers are found with the numbers.
struct Shares {
  double held = 0;
  /// 1.96 deviations of the inverse information, the powers as they are.
  double by_information = 0;
};

Shares Coverage(int draws) {
  const Likelihood likelihood({{0, kDrawnRows, 1.0}}, 0.1);
  const Eigen::MatrixXd columns = likelihood.Transform(SlowColumns());
  std::mt19937 random(4);
  Shares shares;
  for (int draw = 0; draw < draws; ++draw) {
    const Eigen::VectorXd y = likelihood.Transform(ColouredNoise(&random));
    Eigen::VectorXd numbers = Eigen::VectorXd::Zero(kNumbers);
    BandPowers powers = likelihood.Powers(y);
    Eigen::MatrixXd slopes;
    for (int round = 0; round < 8; ++round) {
      const Eigen::VectorXd weight = likelihood.Weights(powers);
      slopes = weight.asDiagonal() * columns;
      numbers =
          (slopes.transpose() * slopes).ldlt().solve(slopes.transpose() * weight.cwiseProduct(y));
      powers = likelihood.Powers(y - columns * numbers);
    }
    const std::vector<double> half = EvenHalfWidths(likelihood, powers, slopes);
    const Eigen::MatrixXd variance = (slopes.transpose() * slopes).inverse();
    for (int k = 0; k < kNumbers; ++k) {
      const double off = std::abs(numbers[k]), one = 1.0 / (draws * kNumbers);
      if (off <= half[static_cast<size_t>(k)]) shares.held += one;
      if (off <= 1.96 * std::sqrt(variance(k, k))) shares.by_information += one;
    }
  }
  return shares;
}

/// A wave over the record.
Eigen::VectorXd Wave(double rms, double periods, double phase) {
  Eigen::VectorXd wave(kDrawnRows);
  for (int i = 0; i < kDrawnRows; ++i) {
    wave[i] = rms * M_SQRT2 * std::sin(2 * M_PI * periods * i / kDrawnRows + phase);
  }
  return wave;
}

/// An error of the size that theory leaves open, and of another shape, is one draw for all that it
/// touches. Intervals that took the coefficients of an octave for so many samples held the truth in
/// 48 of 100; these do in 78: that octaves share the draw, too, is not in them.
TEST(FitIntervals, HoldTheTruthWhereTheoryIsOpen) {
  constexpr int kDraws = 400;
  const Likelihood likelihood({{0, kDrawnRows, 1.0}}, 0.1, {Wave(5, 5.8, 0)});
  Eigen::MatrixXd of_numbers(kDrawnRows, 2);
  of_numbers << Wave(1, 5.5, 0), Wave(1, 5.5, 0.5 * M_PI);
  const Eigen::MatrixXd columns = likelihood.Transform(of_numbers);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 2 * M_PI);
  double held = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    Eigen::VectorXd y = normal(random) * Wave(5, 5.2, phase(random));
    for (double& x : y) x += normal(random);
    const Eigen::VectorXd coefficients = likelihood.Transform(y);
    const BandPowers powers = likelihood.Powers(coefficients);
    const Eigen::VectorXd weight = likelihood.Weights(powers);
    const Eigen::MatrixXd slopes = weight.asDiagonal() * columns;
    const Eigen::VectorXd numbers =
        (slopes.transpose() * slopes)
            .ldlt()
            .solve(slopes.transpose() * weight.cwiseProduct(coefficients));
    const std::vector<double> half = EvenHalfWidths(likelihood, powers, slopes);
    for (const int k : {0, 1}) {
      if (std::abs(numbers[k]) <= half[static_cast<size_t>(k)]) held += 1.0 / (2 * kDraws);
    }
  }
  EXPECT_GT(held, 0.70);
  EXPECT_LT(held, 0.96);
}

/// Two thousand intervals. Not quite 95 %: within an octave the noise is not quite even.
TEST(FitIntervals, HoldTheTruthWhereFewCoefficientsTell) {
  const Shares shares = Coverage(400);
  EXPECT_GT(shares.held, 0.92);
  EXPECT_LT(shares.held, 0.97);
  EXPECT_LT(shares.by_information, 0.88);
}

/// Row k of `blocks` equal ones, one after the other.
std::vector<int> EvenBlocks(int blocks, int rows) {
  std::vector<int> out;
  for (int i = 0; i < rows; ++i) out.push_back(i * blocks / rows);
  return out;
}

/// Of a mean over B equal blocks it is the textbook's interval of the mean of B numbers: their
/// standard deviation over sqrt(B), Student with B - 1 = 19 degrees of freedom.
TEST(JackknifeHalfWidths, AreThoseOfTheBlocksMeans) {
  constexpr int kBlocks = 20, kRows = 1000;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(kRows, 1);
  const std::vector<int> block = EvenBlocks(kBlocks, kRows);
  Eigen::VectorXd r(kRows);
  for (int i = 0; i < kRows; ++i) r[i] = block[i] % 2 == 0 ? 3 : -3;
  const std::vector<double> half = JackknifeHalfWidths(one, r, block, kBlocks);
  ASSERT_EQ(half.size(), 1u);
  EXPECT_NEAR(half[0], 2.093 * 3 * std::sqrt(20.0 / 19) / std::sqrt(20.0), 0.01);
}

/// Least squares anew without each block: the closed form must give the same variance.
TEST(JackknifeHalfWidths, AreThoseOfFitsWithoutEachBlock) {
  constexpr int kBlocks = 12, kRows = 240;
  const std::vector<int> block = EvenBlocks(kBlocks, kRows);
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd columns(kRows, 2);
  Eigen::VectorXd y(kRows);
  for (int i = 0; i < kRows; ++i) {
    columns.row(i) << 1, i < 120 ? normal(random) : 0.1 * normal(random);
    y[i] = normal(random) + (block[i] % 3 == 0 ? 1 : 0);
  }
  const auto fit = [&](int without) {
    Eigen::MatrixXd a = columns;
    Eigen::VectorXd b = y;
    for (int i = 0; i < kRows; ++i) {
      if (block[i] == without) a.row(i).setZero(), b[i] = 0;
    }
    return Eigen::Vector2d((a.transpose() * a).ldlt().solve(a.transpose() * b));
  };
  const Eigen::Vector2d all = fit(-1);
  Eigen::Vector2d variance = Eigen::Vector2d::Zero(), quantile;
  for (int b = 0; b < kBlocks; ++b)
    variance += (fit(b) - all).cwiseAbs2() * (kBlocks - 1) / kBlocks;
  const std::vector<double> half = JackknifeHalfWidths(columns, y - columns * all, block, kBlocks);
  // The mean is told by twelve blocks alike (Student, 11 degrees of freedom: 2.201), the slope by
  // the first six (between 3 and 5: 3.182 to 2.571).
  EXPECT_NEAR(half[0], 2.201 * std::sqrt(variance[0]), 0.02 * half[0]);
  EXPECT_GT(half[1], 2.571 * std::sqrt(variance[1]));
  EXPECT_LT(half[1], 3.182 * std::sqrt(variance[1]));
}

/// Residuals that two channels share and that remember half a block; three of twenty blocks move
/// four times as much as the others and tell most of the number: 98 of 100 hold it. With N in the
/// place of N - N_b and B - 1 degrees of freedom it were 93, every sample for itself 35.
TEST(JackknifeHalfWidths, HoldTheTruthWhereFewBlocksTell) {
  constexpr int kBlocks = 20, kRows = 2000, kDraws = 1000;
  const std::vector<int> in_time = EvenBlocks(kBlocks, kRows);
  std::vector<int> block = in_time;
  block.insert(block.end(), in_time.begin(), in_time.end());
  Eigen::MatrixXd column(2 * kRows, 1);
  for (int i = 0; i < kRows; ++i) {
    const double lively = in_time[i] % 7 == 3 ? 4 : 1;
    column(i, 0) = column(kRows + i, 0) = lively * std::sin(0.07 * i);
  }
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int held = 0, even = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    Eigen::VectorXd y(2 * kRows);
    double at = normal(random);
    for (int i = 0; i < kRows; ++i) {
      at = 0.98 * at + 0.2 * normal(random);
      y[i] = y[kRows + i] = at;
    }
    const double number = column.col(0).dot(y) / column.squaredNorm();
    const Eigen::VectorXd r = y - number * column;
    held += std::abs(number) <= JackknifeHalfWidths(column, r, block, kBlocks)[0];
    even += std::abs(number) <= 1.96 * std::sqrt(r.squaredNorm() / (2 * kRows)) / column.norm();
  }
  EXPECT_GT(held, 0.95 * kDraws);
  EXPECT_LT(held, 0.99 * kDraws);
  EXPECT_LT(even, 0.45 * kDraws);
}

/// One block alone tells the number: the others cannot disagree with it.
TEST(JackknifeHalfWidths, SayNothingOfWhatOneBlockTells) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(400, 2);
  for (int i = 20; i < 400; ++i) columns(i, 1) = 0;
  Eigen::VectorXd r(400);
  for (int i = 0; i < 400; ++i) r[i] = i % 2 == 0 ? 1 : -1;
  const std::vector<double> half = JackknifeHalfWidths(columns, r, EvenBlocks(20, 400), 20);
  ASSERT_EQ(half.size(), 2u);
  EXPECT_EQ(half[1], 0);
}

}  // namespace
}  // namespace phs::identify::search
