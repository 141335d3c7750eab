// Intervals against drawn noise: how often do they hold the truth?
#include "identify/fit_intervals.h"

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

}  // namespace
}  // namespace phs::identify::search
