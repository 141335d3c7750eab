// Octaves of a residual and the likelihood made of them.
#include "identify/fit/likelihood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace phs::identify {
namespace {

Eigen::VectorXd White(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd out(n);
  for (double& x : out) x = normal(random);
  return out;
}

TEST(OctaveBands, WhiteNoiseHasTheSamePowerInEveryOctave) {
  for (const int n : {4096, 5000, 4999}) {
    const OctaveBands bands(n);
    std::vector<double> power(static_cast<size_t>(bands.num_bands()), 0.0);
    constexpr int kDraws = 60;
    for (unsigned seed = 0; seed < kDraws; ++seed) {
      const Eigen::VectorXd c = bands.Transform(White(n, seed));
      for (int k = 0; k < bands.num_bands(); ++k) {
        power[static_cast<size_t>(k)] +=
            c.segment(bands.begin(k), bands.end(k) - bands.begin(k)).squaredNorm() / kDraws;
      }
    }
    for (int k = 0; k < bands.num_bands(); ++k) {
      const int count = bands.end(k) - bands.begin(k);
      // 4 deviations of chance; mean and slope are taken off the slowest, and a zero may be added.
      EXPECT_NEAR(power[static_cast<size_t>(k)] / count, 1,
                  4 * std::sqrt(2.0 / (count * kDraws)) + (k > 5 ? 2.0 / count : 0))
          << n << ", octave " << k;
    }
  }
}

TEST(OctaveBands, KeepTheSquareOfWhatLiesInside) {
  constexpr int n = 1024;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
  y.segment(400, 200) = White(200, 3);
  const OctaveBands bands(n);
  // Mean and slope are there twice: as coefficients of their own, and not in the rest.
  EXPECT_NEAR(bands.Transform(y).squaredNorm(), y.squaredNorm(), 1e-9 * y.squaredNorm());
}

TEST(OctaveBands, ACubicIsSlow) {
  constexpr int n = 512;
  Eigen::VectorXd y(n);
  for (int i = 0; i < n; ++i) y[i] = 2 + 0.1 * i - 1e-4 * i * i + 3e-7 * std::pow(i, 3);
  const OctaveBands bands(n);
  const Eigen::VectorXd c = bands.Transform(y);
  EXPECT_LT(c.segment(4, n / 2 - 8).cwiseAbs().maxCoeff(), 1e-8 * y.maxCoeff());
}

TEST(OctaveBands, ASineLiesInItsOctave) {
  constexpr int n = 4096;
  Eigen::VectorXd y(n);
  for (int i = 0; i < n; ++i) y[i] = std::sin(2 * M_PI * 0.35 * i);  // of the sampling rate
  const OctaveBands bands(n);
  const Eigen::VectorXd c = bands.Transform(y);
  EXPECT_GT(c.head(bands.end(0)).squaredNorm(), 0.9 * y.squaredNorm());
}

TEST(Likelihood, IsTheClosedFormulaOfItsPowers) {
  constexpr double e = 0.1;
  const Likelihood likelihood({{0, 256, 1.0}, {256, 128, 0.5}}, e);
  BandPowers powers = likelihood.Powers(likelihood.Transform(White(384, 5)));
  double expected = 0, count = 0;
  for (size_t b = 0; b < 2; ++b) {
    for (int k = 0; k < likelihood.bands(b).num_bands(); ++k) {
      const double power = k == 0 ? 0.5 : 3.0 + k;
      powers.rows()[b][static_cast<size_t>(k)] = power;
      const int coefficients = likelihood.bands(b).end(k) - likelihood.bands(b).begin(k);
      const double n = (b == 0 ? 1 : 0.5) * coefficients, m = 1 / (1 / n + e * e / 2);
      expected += m * (k == 0 ? std::log(1.1) + 0.5 / 1.1 : std::log(power) + 1);
      count += m;
    }
  }
  EXPECT_NEAR(likelihood.MinusTwoLog(powers), expected, 1e-9 * std::abs(expected));
  EXPECT_NEAR(likelihood.Count(), count, 1e-9);
}

// What a fit minimises with the powers held has the slope of what it lowers: d(-2 ln L)/dP_b =
// m_b/P_b above the noise, and so has sum of (weight x coefficient)².
TEST(Likelihood, WeightsAreTheSlopeOfTheLikelihood) {
  const Likelihood likelihood({{0, 700, 1.0}}, 0.1);
  const Eigen::VectorXd c = likelihood.Transform(Eigen::VectorXd(3 * White(700, 7)));
  const Eigen::VectorXd direction = likelihood.Transform(White(700, 8));
  const Eigen::VectorXd weight = likelihood.Weights(likelihood.Powers(c));
  constexpr double h = 1e-5;
  const auto score = [&](double by) {
    return likelihood.MinusTwoLog(likelihood.Powers(c + by * direction));
  };
  const double slope = 2 * weight.cwiseProduct(c).dot(weight.cwiseProduct(direction));
  EXPECT_NEAR((score(h) - score(-h)) / (2 * h), slope, 1e-5 * std::abs(slope) + 1e-6);
}

TEST(Likelihood, OneOctaveCannotOutvoteTheOthers) {
  const Likelihood likelihood({{0, 65536, 1.0}}, 0.1);
  BandPowers powers = likelihood.Powers(likelihood.Transform(Eigen::VectorXd(2 * White(65536, 9))));
  const double before = likelihood.MinusTwoLog(powers);
  powers.rows()[0][0] *= 0.98;  // the fastest, with half of all coefficients: two per cent
  const double fast = before - likelihood.MinusTwoLog(powers);
  powers.rows()[0][0] /= 0.98;
  powers.rows()[0][9] *= 0.5;  // one with 64 of them: half of it gone
  EXPECT_GT(before - likelihood.MinusTwoLog(powers), 5 * fast);
}

// Two blocks, a theory that turns both by a slow wave: that wave costs the square of its amplitude,
// as a normal error's does, and a wave of another shape in these octaves hardly anything; white
// noise is what it was.
TEST(Likelihood, WhatTheoryLeavesOpenIsNoEvidence) {
  constexpr int n = 512;
  Eigen::VectorXd theory(2 * n), other(2 * n);
  for (int i = 0; i < 2 * n; ++i) {
    theory[i] = 4 * std::sin(2 * M_PI * i / 256.0);
    other[i] = 4 * std::cos(2 * M_PI * i / 256.0);
  }
  const std::vector<Block> blocks = {{0, n, 1.0}, {n, n, 1.0}};
  const Likelihood plain(blocks, 0.1), open(blocks, 0.1, {theory});
  const Eigen::VectorXd noise = White(2 * n, 11);
  const auto gain = [&](const Likelihood& of, const Eigen::VectorXd& residual) {
    return of.MinusTwoLog(residual) - of.MinusTwoLog(noise);
  };
  EXPECT_GT(gain(plain, noise + 3 * theory), 100);
  EXPECT_LT(std::abs(gain(open, noise + theory)), 2);
  EXPECT_NEAR(gain(open, noise + 3 * theory), 9, 2);
  EXPECT_NEAR(gain(open, noise + 6 * theory), 36, 4);
  EXPECT_LT(gain(open, noise + other), 0.1 * gain(plain, noise + other));
  EXPECT_GT(open.Worth(0, 0), 0.9 * plain.Worth(0, 0))
      << "the fastest octave is not governed by it";
  const int last = open.bands(0).num_bands() - 1;
  EXPECT_LT(open.Worth(0, last) + open.Worth(1, last), 1.1);
}

// Twenty channels that a theory turns by a slow wave, all at once. A residual of that size and of
// another shape is no evidence; ten times that in one channel is, however many share the octave. A
// fit steps by the slope of what it lowers on either side of three times.
TEST(Likelihood, WhatIsFarBeyondAllTheoryIsEvidenceAgain) {
  constexpr int kChannels = 20, n = 512;
  Eigen::VectorXd theory(kChannels * n);
  for (int i = 0; i < theory.size(); ++i) theory[i] = 4 * std::sin(2 * M_PI * i / 256.0);
  std::vector<Block> blocks;
  for (int c = 0; c < kChannels; ++c) blocks.push_back({c * n, n, 1.0});
  const Likelihood open(blocks, 0.1, {theory});
  const Eigen::VectorXd noise = White(kChannels * n, 12);
  const auto score = [&](double times) {
    Eigen::VectorXd residual = noise;
    for (int i = 0; i < n; ++i) residual[i] += 4 * times * std::cos(2 * M_PI * i / 256.0);
    return open.MinusTwoLog(residual);
  };
  EXPECT_LT(score(1) - score(0), 1);
  EXPECT_GT(score(10) - score(0), 10);
  constexpr double h = 1e-4;
  for (const double times : {1.5, 4.0}) {
    const auto spoilt = [&](double by) {
      Eigen::VectorXd residual = noise;
      for (int i = 0; i < n; ++i) residual[i] += 4 * by * std::cos(2 * M_PI * i / 256.0);
      return open.Transform(residual);
    };
    const Eigen::VectorXd c = spoilt(times), direction = (spoilt(times + h) - c) / h;
    const Eigen::VectorXd weight = open.Weights(open.Powers(c));
    const double slope = 2 * weight.cwiseProduct(c).dot(weight.cwiseProduct(direction));
    EXPECT_NEAR((score(times + h) - score(times - h)) / (2 * h), slope, 1e-2 * std::abs(slope));
  }
}

// Slow noise of what drives the model, of known power: a residual of just that is nothing to be
// explained, though white noise of the same weights hardly makes it. Twice as much still is.
TEST(Likelihood, ErrorsOfTheInputsAreNoiseOfTheirColour) {
  constexpr int n = 2048;
  const auto slow = [](unsigned seed) {
    Eigen::VectorXd y = White(n, seed);
    for (int i = 1; i < n; ++i) y[i] = 0.98 * y[i - 1] + 0.4 * y[i];
    return y;
  };
  const std::vector<Block> blocks = {{0, n, 1}};
  std::vector<Eigen::VectorXd> draws;
  for (unsigned k = 0; k < 8; ++k) draws.push_back(slow(10 + k) / std::sqrt(8.0));
  const Likelihood blind(blocks, 0.1), knows(blocks, 0.1, {}, draws);
  const auto most = [&](const Likelihood& likelihood, double size) {
    const Eigen::VectorXd residual = White(n, 1) + size * slow(2);
    return likelihood.MostGain(likelihood.Powers(likelihood.Transform(residual)));
  };
  EXPECT_GT(most(blind, 1), 100);
  EXPECT_LT(most(knows, 1), 0.1 * most(blind, 1));
  EXPECT_GT(most(knows, 3), 5 * most(knows, 1));
  EXPECT_EQ(knows.size(), blind.size());
  EXPECT_NEAR(knows.Count(), blind.Count(), 1e-9) << "what an octave is worth stays";
}

}  // namespace
}  // namespace phs::identify
