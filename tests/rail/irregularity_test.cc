// Irregularities: splines, fading, spectra and their generation, records.
#include "rail/irregularity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "rail/irregularity_psd.h"
#include "rail/track.h"
#include "tests/base/scratch_dir.h"

namespace phs::rail {
namespace {

using ::testing::HasSubstr;

IrregularitySamples Sines(double step, double length) {
  IrregularitySamples samples;
  for (double s = 0; s <= length + 1e-9; s += step) {
    samples.s.push_back(s);
    samples.channel[kAlignment].push_back(0.004 * std::sin(2 * std::numbers::pi * s / 10));
    samples.channel[kLevel].push_back(0.003 * std::cos(2 * std::numbers::pi * s / 7));
    samples.channel[kCrossLevel].push_back(0.002 * std::sin(2 * std::numbers::pi * s / 13));
    samples.channel[kGauge].push_back(0.001 * std::sin(2 * std::numbers::pi * s / 5));
  }
  return samples;
}

TEST(Irregularity, SplineOfASineConvergesWithFourthOrderAndKeepsItsSlope) {
  double error[2] = {0, 0};
  double slope_error = 0;
  for (int i = 0; i < 2; ++i) {
    const double step = i == 0 ? 0.5 : 0.25;
    const Irregularity irregularity(Sines(step, 200), 20);
    for (double s = 50; s < 150; s += 0.0371) {
      const double w = 2 * std::numbers::pi / 7;
      const RailOffset left = irregularity.At(Side::kLeft, s);
      const RailOffset right = irregularity.At(Side::kRight, s);
      const double level = (left.vertical + right.vertical) / 2;
      error[i] = std::max(error[i], std::abs(level - 0.003 * std::cos(w * s)));
      const double slope = (left.vertical_slope + right.vertical_slope) / 2;
      slope_error = std::max(slope_error, std::abs(slope + 0.003 * w * std::sin(w * s)));
    }
  }
  EXPECT_LT(error[1], 1e-6);
  EXPECT_NEAR(error[0] / error[1], 16, 3);
  EXPECT_LT(slope_error, 3e-5);
}

TEST(Irregularity, ChannelsGoToTheRailsWithTheirSigns) {
  const Irregularity irregularity(Sines(0.25, 100), 10);
  for (double s : {33.3, 47.1, 60.0}) {
    const RailOffset left = irregularity.At(Side::kLeft, s);
    const RailOffset right = irregularity.At(Side::kRight, s);
    auto sine = [&](double amplitude, double wavelength) {
      return amplitude * std::sin(2 * std::numbers::pi * s / wavelength);
    };
    EXPECT_NEAR((left.lateral + right.lateral) / 2, sine(0.004, 10), 1e-6);
    EXPECT_NEAR(left.lateral - right.lateral, sine(0.001, 5), 1e-6);
    EXPECT_NEAR(right.vertical - left.vertical, sine(0.002, 13), 1e-6);
  }
}

TEST(Irregularity, IsContinuousToTheSecondDerivativeAndFadesOut) {
  const Irregularity irregularity(Sines(0.5, 100), 20);
  const double h = 1e-4;
  for (double s = -1; s < 101; s += 0.25) {  // every second point is a knot
    const RailOffset a = irregularity.At(Side::kRight, s - h);
    const RailOffset b = irregularity.At(Side::kRight, s);
    const RailOffset c = irregularity.At(Side::kRight, s + h);
    ASSERT_NEAR((c.lateral - a.lateral) / (2 * h), b.lateral_slope, 1e-7) << s;
    ASSERT_NEAR((c.vertical - a.vertical) / (2 * h), b.vertical_slope, 1e-7) << s;
    const double before = (b.lateral_slope - a.lateral_slope) / h;
    const double after = (c.lateral_slope - b.lateral_slope) / h;
    ASSERT_NEAR(before, after, 2e-5) << s;
  }
  EXPECT_EQ(irregularity.At(Side::kLeft, -0.001).lateral, 0);
  EXPECT_EQ(irregularity.At(Side::kLeft, 100.001).lateral, 0);
  EXPECT_LT(std::abs(irregularity.At(Side::kLeft, 2.5).lateral), 0.1 * 0.0045);
  EXPECT_TRUE(Irregularity().empty());
  EXPECT_EQ(Irregularity().At(Side::kLeft, 5).vertical_slope, 0);
}

TEST(Irregularity, UnevenSamplesAreInterpolatedExactly) {
  rc::check("the spline passes through the samples", [] {
    IrregularitySamples samples;
    double s = *rc::gen::inRange(-100, 100);
    const int n = *rc::gen::inRange(4, 60);
    for (int i = 0; i < n; ++i) {
      samples.s.push_back(s);
      s += 0.01 * *rc::gen::inRange(1, 800);
      for (auto& channel : samples.channel) channel.push_back(1e-5 * *rc::gen::inRange(-999, 999));
    }
    const Irregularity irregularity(samples, 0);
    for (int i = 1; i + 1 < n; ++i) {
      const RailOffset left = irregularity.At(Side::kLeft, samples.s[i]);
      const double want = samples.channel[kAlignment][i] + samples.channel[kGauge][i] / 2;
      RC_ASSERT(std::abs(left.lateral - want) < 1e-15);
    }
  });
}

// Integral over all frequencies in closed form: A pi Wc/(2 Wr (Wr + Wc)).
TEST(IrregularityPsd, VarianceOfTheGermanSpectrumEqualsClosedForm) {
  for (auto [name, a] : {std::pair{"errib176_low", 4.032e-7}, {"errib176_high", 1.08e-6}}) {
    double sum = 0;
    for (double log_w = -20; log_w < 7; log_w += 1e-3) {
      const double w = std::exp(log_w);
      sum += CalcPsd(name, kLevel, w) * w * 1e-3;
    }
    const double wc = 0.8246;
    const double wr = 0.0206;
    EXPECT_NEAR(sum / (a * std::numbers::pi * wc / (2 * wr * (wr + wc))), 1, 1e-5);
  }
}

// ERRI B176: gauge A_g Wc^2 w^2/((w^2 + Wr^2)(w^2 + Wc^2)(w^2 + Ws^2)), cross level likewise.
TEST(IrregularityPsd, GermanGaugeAndCrossLevelFallOffTowardsLongWaves) {
  const double wc = 0.8246, wr = 0.0206, ws = 0.4380;
  for (const double w : {0.03, 0.4, 3.0}) {
    const double shape =
        wc * wc * w * w / ((w * w + wr * wr) * (w * w + wc * wc) * (w * w + ws * ws));
    EXPECT_NEAR(
        CalcPsd("errib176_low", kGauge, w) / shape,
        CalcPsd("errib176_low", kGauge, 1) / CalcPsd("errib176_low", kCrossLevel, 1) * 4 * 4.032e-7,
        1e-12)
        << w;
    EXPECT_NEAR(CalcPsd("errib176_low", kCrossLevel, w) / shape, 4 * 4.032e-7, 1e-12) << w;
  }
}

TEST(IrregularityPsd, AmericanSpectraAtTheCornerAndInTheirOrder) {
  // S(Wc) = k A/(2 Wc^2) [m^2/(rad/m)], k = 0.25; class 6: Av = Aa = 0.0339 cm^2 rad/m.
  const double wc = 0.8245;
  EXPECT_NEAR(CalcPsd("fra_6", kLevel, wc) / (0.25 * 0.0339e-4 / (2 * wc * wc)), 1, 1e-12);
  EXPECT_NEAR(CalcPsd("fra_6", kAlignment, wc), CalcPsd("fra_6", kLevel, wc), 1e-20);
  const double ws = 0.4380;
  EXPECT_NEAR(CalcPsd("fra_6", kCrossLevel, wc) / (0.25 * 0.0339e-4 * 2 / (wc * wc + ws * ws)), 1,
              1e-12);
  for (double w : {0.06, 0.3, 2.0}) {
    for (int i = 1; i < 6; ++i) {
      const std::string worse = "fra_" + std::to_string(i);
      const std::string better = "fra_" + std::to_string(i + 1);
      EXPECT_GT(CalcPsd(worse, kLevel, w), CalcPsd(better, kLevel, w));
      EXPECT_GT(CalcPsd(worse, kAlignment, w), CalcPsd(better, kAlignment, w));
    }
  }
}

// One-sided density [m^2/(rad/m)] of a record at w: periodogram with a Hann window (mean
// square 1.5).
double Periodogram(const IrregularitySamples& samples, IrregularityChannel channel, double w) {
  const size_t n = samples.s.size() - 1;
  const double length = samples.s[n] - samples.s[0];
  double re = 0;
  double im = 0;
  for (size_t i = 0; i < n; ++i) {
    const double at = static_cast<double>(i) / static_cast<double>(n);
    const double x = (1 - std::cos(2 * std::numbers::pi * at)) * samples.channel[channel][i];
    re += x * std::cos(w * samples.s[i]);
    im += x * std::sin(w * samples.s[i]);
  }
  const double step = length / static_cast<double>(n);
  return (re * re + im * im) * step * step / (1.5 * length * std::numbers::pi);
}

TEST(IrregularityPsd, GeneratedSamplesHaveTheTargetDensityWithin10Percent) {
  struct Band {
    double low, high, measured, target;
  };
  std::vector<std::vector<Band>> bands(4, {{0.15, 0.25, 0, 0}, {0.5, 0.6, 0, 0}, {1.2, 1.3, 0, 0}});
  for (std::uint64_t seed = 1; seed <= 160; ++seed) {
    IrregularityPsdParams params;
    params.seed = seed;
    params.end_s = 500;
    const IrregularitySamples samples = GenerateIrregularity(params);
    for (int c = 0; c < kNumIrregularityChannels; ++c) {
      const auto channel = static_cast<IrregularityChannel>(c);
      for (Band& band : bands[static_cast<size_t>(c)]) {
        for (double w = band.low; w < band.high; w += 2 * std::numbers::pi / 500) {
          band.measured += Periodogram(samples, channel, w);
          band.target += CalcPsd("errib176_low", channel, w);
        }
      }
    }
  }
  for (const auto& channel : bands) {
    for (const Band& band : channel) {
      EXPECT_NEAR(band.measured / band.target, 1, 0.1) << band.low << " rad/m";
    }
  }
}

TEST(IrregularityPsd, VarianceEqualsTheIntegralOverTheBand) {
  IrregularityPsdParams params;
  params.end_s = 4000;
  const IrregularitySamples samples = GenerateIrregularity(params);
  for (int c = 0; c < kNumIrregularityChannels; ++c) {
    double want = 0;
    const int n = 20000;
    const double low = 2 * std::numbers::pi / 100;
    const double high = 2 * std::numbers::pi / 3;
    for (int i = 0; i < n; ++i) {
      const double w = low + (i + 0.5) * (high - low) / n;
      want += CalcPsd("errib176_low", static_cast<IrregularityChannel>(c), w) * (high - low) / n;
    }
    double got = 0;
    for (double x : samples.channel[c]) got += x * x / static_cast<double>(samples.s.size());
    EXPECT_NEAR(got / want, 1, 0.12) << c;
    EXPECT_GT(std::sqrt(got), 0.2e-3);  // millimetres, as on real track
    EXPECT_LT(std::sqrt(got), 5e-3);
  }
}

TEST(IrregularityPsd, StandsWhereItIsWanted) {
  IrregularityPsdParams params;
  params.begin_s = 300;
  params.end_s = 700;
  const IrregularitySamples samples = GenerateIrregularity(params);
  EXPECT_NEAR(samples.s.front(), 300, 1e-9);
  EXPECT_NEAR(samples.s.back(), 700, 1e-9);
}

TEST(IrregularityPsd, SeedsAreReproducibleAndDifferentAndScaleIsLinear) {
  IrregularityPsdParams params;
  const IrregularitySamples a = GenerateIrregularity(params);
  const IrregularitySamples b = GenerateIrregularity(params);
  EXPECT_EQ(a.channel, b.channel);
  params.scale = 2;
  const IrregularitySamples twice = GenerateIrregularity(params);
  EXPECT_EQ(twice.channel[kLevel][77], 2 * a.channel[kLevel][77]);
  params.scale = 1;
  params.seed = 2;
  const IrregularitySamples other = GenerateIrregularity(params);
  EXPECT_NE(a.channel[kLevel][50], other.channel[kLevel][50]);
}

TEST(IrregularityPsd, WavesGoDownToTwentyHertzOfTheRunUnlessTheFileSaysOtherwise) {
  EXPECT_NEAR(FinestWavelength(0), 80 / 3.6 / 20, 1e-12);
  EXPECT_NEAR(FinestWavelength(30), 1.5, 1e-12);
  EXPECT_EQ(FinestWavelength(200), 3);
  EXPECT_EQ(FinestWavelength(2), 0.5);
  const auto track = [](const std::string& more, double speed) {
    const std::string path = ScratchFile("waves.yaml");
    std::ofstream(path) << "segments: [{kind: tangent, length_m: 400}]\nirregularity: {psd: "
                           "errib176_high, fade_m: 1"
                        << more << "}\n";
    auto loaded = Track::Load(path, false, {}, speed);
    EXPECT_TRUE(loaded.ok()) << loaded.error().Line();
    return std::move(loaded).value();
  };
  // Power of the level between two wavelengths, by projection on many cosines and sines.
  const auto power = [](const Track& t, double shortest, double longest) {
    double sum = 0;
    for (double w = 2 * M_PI / longest; w < 2 * M_PI / shortest; w += M_PI / 190) {
      double c = 0, s = 0;
      for (double x = 10; x < 390; x += 0.1) {
        const double window = 1 - std::cos(2 * M_PI * (x - 10) / 380);
        const double z = window * t.Rail(Side::kLeft, x).vertical;
        c += z * std::cos(w * x), s += z * std::sin(w * x);
      }
      sum += c * c + s * s;
    }
    return sum;
  };
  const Track fast = track("", 60), usual = track("", 80 / 3.6);
  const Track said = track(", shortest_wavelength_m: 3", 80 / 3.6);
  EXPECT_LT(power(said, 1.2, 2.6), 0.02 * power(usual, 1.2, 2.6)) << "the file's 3 m hold";
  EXPECT_LT(power(fast, 1.2, 2.6), 0.02 * power(usual, 1.2, 2.6)) << "60 m/s reach 20 Hz at 3 m";
  EXPECT_NEAR(power(fast, 8, 50) / power(usual, 8, 50), 1, 0.01) << "the long waves are the same";
}

std::string WrittenWave(const std::string& text) {
  const std::string path = ScratchFile("irregularity_record.csv");
  std::ofstream(path) << text;
  return path;
}

TEST(IrregularityRecord, IsReadWithMissingChannelsAsZero) {
  const auto read =
      ReadIrregularity(WrittenWave("s_m,level_m\n0,0.001\n0.5,0.002\n1.2,-0.001\n2,0\n"));
  ASSERT_TRUE(read.ok()) << read.error().Line();
  EXPECT_EQ(read.value().s, (std::vector<double>{0, 0.5, 1.2, 2}));
  EXPECT_EQ(read.value().channel[kLevel][2], -0.001);
  EXPECT_EQ(read.value().channel[kGauge], std::vector<double>(4, 0.0));
}

TEST(IrregularityRecord, ErrorsNameFileLineAndMend) {
  auto failure = [](const std::string& text) {
    const auto read = ReadIrregularity(WrittenWave(text));
    return read.ok() ? std::string("ok") : read.error().Line();
  };
  EXPECT_THAT(failure("s_m,level_mm\n0,1\n1,1\n2,1\n3,1\n"),
              AllOf(HasSubstr("unknown column level_mm"), HasSubstr("cross_level_m")));
  EXPECT_THAT(failure("level_m\n0\n0\n0\n0\n"), HasSubstr("s_m"));
  EXPECT_THAT(failure("s_m,level_m\n0,0\n1,0\n"), HasSubstr("only 2 samples"));
  EXPECT_THAT(failure("s_m,level_m\n0,0\n2,0\n1,0\n3,0\n"),
              AllOf(HasSubstr("irregularity_record.csv:4"), HasSubstr("s_m does not increase")));
  EXPECT_THAT(failure("s_m,level_m\n0,0\n1,3.5\n2,0\n3,0\n"),
              AllOf(HasSubstr(":3"), HasSubstr("not millimetres")));
  EXPECT_THAT(failure("s_m,level_m\n0,0\n1,x\n2,0\n3,0\n"), HasSubstr(":3"));
}

}  // namespace
}  // namespace phs::rail
