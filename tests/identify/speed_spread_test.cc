// What the uncertainty of a measured speed makes of a model's outputs.
#include "identify/models/speed_spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "identify/models/rig_forward.h"
#include "rigs/rig_model.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

TEST(SpeedSpread, OfAParabolaIsThatOfNormalSpeeds) {
  // y = a x + b x² at x = v + s xi: E[(y - y(v))²] = (a + 2 b v)² s² + 3 b² s⁴.
  const double v = 0.7, s = 0.3, a = 2, b = -1.5;
  const auto run = [&](double deviations, Channels* out) {
    const double x = v + s * deviations;
    *out = {{a * x + b * x * x, a * x}};
    return Status();
  };
  Channels u;
  ASSERT_TRUE(SpreadOverSpeed(run, &u).ok());
  ASSERT_EQ(u.size(), 1u);
  EXPECT_NEAR(u[0][0], std::sqrt(std::pow((a + 2 * b * v) * s, 2) + 3 * b * b * std::pow(s, 4)),
              1e-12);
  EXPECT_NEAR(u[0][1], a * s, 1e-12);
}

TEST(SpeedSpread, AnErrorOfTheModelIsHandedOn) {
  Channels u;
  const auto fails = [](double deviations, Channels* out) {
    *out = {{0}};
    return deviations > 2 ? Status(Error{"model", "refuses", ""}) : Status();
  };
  EXPECT_FALSE(SpreadOverSpeed(fails, &u).ok());
}

/// Rms over the samples whose speed lies between two numbers of deviations.
struct Mean {
  double square = 0;
  int count = 0;
  void Add(double x) { square += x * x, ++count; }
  double Rms() const { return std::sqrt(square / count); }
};

// The declared friction turns within 0.2 mm/s. Where the speed is known to 0.15 mm/s, samples two and
// three deviations from rest may lie beyond the turn. Reference: 300 draws of normal speeds.
TEST(SpeedSpread, FrictionTwoDeviationsFromItsTurnIsAsUncertainAsDrawnSpeedsSay) {
  constexpr double kDeviation = 1.5e-4;
  constexpr int kDraws = 300;
  measurement::FitData data = Record(Declared());
  measurement::SmoothMotion& smooth = data.motion[0];
  smooth.speed_deviation.assign(smooth.speed.size(), kDeviation);
  const auto forward = RigForward::Create(data, Declared()).value();
  Channels u;
  ASSERT_TRUE(forward->Uncertainty(Declared(), ForwardModel::Span::kWhole, &u).ok());

  const auto rig = rigs::RigModel::Create(rigs::RigKind::kQuarter, Declared());
  rigs::RigMotion motion{0, data.step_s, {smooth.position}, {smooth.speed}, {}, {}, {}};
  rigs::RigPrediction plain, drawn;
  ASSERT_TRUE(rig.value().Run(motion, &plain).ok());
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Mean said[5], found[5];
  for (int draw = 0; draw < kDraws; ++draw) {
    for (size_t i = 0; i < smooth.speed.size(); ++i) {
      motion.speed_m_s[0][i] = smooth.speed[i] + kDeviation * normal(random);
    }
    ASSERT_TRUE(rig.value().Run(motion, &drawn).ok());
    for (size_t i = 0; i < smooth.speed.size(); ++i) {
      const int away = static_cast<int>(std::abs(smooth.speed[i]) / kDeviation);
      if (away < 5) found[away].Add(drawn.channels[1][i] - plain.channels[1][i]);
      if (away < 5 && draw == 0) said[away].Add(u[1][i]);
    }
  }
  for (int away = 0; away < 3; ++away) {
    EXPECT_NEAR(said[away].Rms() / found[away].Rms(), 1, 0.2) << away << " deviations from rest";
  }
  EXPECT_GT(found[2].Rms(), 100) << "newtons: as much as a load cell's noise";
  EXPECT_LT(said[4].Rms(), 100) << "and gone four deviations away";
}

}  // namespace
}  // namespace phs::identify::search
