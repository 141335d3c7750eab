// What the measured motion leaves uncertain of a model's output.
#include "measurement/redrawn_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/models/rig_forward.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {

using measurement::DeviationOfDraws;
using measurement::FitData;
using measurement::RedrawnMotion;
using measurement::SmoothMotion;
namespace {

TEST(RedrawnMotion, IsAsFarOffAsTheSmootherSaysItself) {
  const FitData data = Record(Declared());
  RedrawnMotion redrawn(data);
  const SmoothMotion& smooth = data.motion[0];
  double drawn = 0, said = 0;
  for (const auto& draw : redrawn.Draws()) {
    for (size_t i = 0; i < smooth.position.size(); ++i) {
      drawn += std::pow(draw[0].position[i] - smooth.position[i], 2);
      said += std::pow(smooth.position_deviation[i], 2);
    }
  }
  EXPECT_NEAR(std::sqrt(drawn / said), 1, 0.3) << "its own estimate holds if the motion is lively";
  RedrawnMotion again(data);
  EXPECT_EQ(redrawn.Draws()[2][0].position, again.Draws()[2][0].position);
}

TEST(RedrawnMotion, DeviationIsARootMeanSquareOverDrawsAndNeighbours) {
  const std::vector<std::vector<double>> with = {{1, 2, 9}, {3, 2, 5}};
  const auto d = DeviationOfDraws(with, {2, 2, 5}, 0.1, 0.1);
  ASSERT_EQ(d.size(), 3u);
  EXPECT_NEAR(d[0], std::sqrt((1.0 + 0) / 2), 1e-12);
  EXPECT_NEAR(d[1], std::sqrt((1.0 + 0 + 8) / 3), 1e-12);
  EXPECT_NEAR(d[2], std::sqrt((0.0 + 8) / 2), 1e-12);
}

TEST(RedrawnMotion, AStiffBristleMakesTheForceUncertainWhereThePistonRests) {
  const FitData data = Record(Declared());
  hydraulics::PhsParams stiff = Declared();
  const double stiffness = 3e8;
  stiff.effects.push_back({"presliding", {}, {{"stiffness_N_per_m", stiffness}}});
  const auto forward = RigForward::Create(data, Declared()).value();
  Channels deviation;
  ASSERT_TRUE(forward->Uncertainty(stiff, ForwardModel::Span::kWhole, &deviation).ok());
  double resting = 0, sliding = 0;
  int rests = 0, slides = 0;
  for (size_t i = 0; i < data.time_s.size(); ++i) {
    const double phase = std::fmod(data.time_s[i], 20.0);
    const double square = deviation[1][i] * deviation[1][i];
    if (phase > 17.5 && phase < 19) resting += square, ++rests;
    if (std::abs(data.motion[0].speed[i]) > 2e-3) sliding += square, ++slides;
  }
  resting = std::sqrt(resting / rests), sliding = std::sqrt(sliding / slides);
  // At rest the bristle holds the difference of two positions, each uncertain by the smoother's
  // deviation there: sqrt(2) sigma0 s, less what they have in common.
  const double s = data.motion[0].position_deviation[1820];
  EXPECT_LT(resting, 5 * stiffness * s);
  EXPECT_GT(resting, 0.2 * stiffness * s);
  EXPECT_GT(resting, 4 * sliding);
}

}  // namespace
}  // namespace phs::identify::search
