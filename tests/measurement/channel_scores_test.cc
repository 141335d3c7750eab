// Errors of a channel.
#include "measurement/channel_scores.h"

#include <gtest/gtest.h>

#include <cmath>

namespace phs::measurement {
namespace {

TEST(ChannelScores, OverTheDeviationOfWhatWasMeasured) {
  const ChannelScore s = Score({0, 1, 2, 3}, {1, -1, 1, -1}, {2, 0, 2, 0}, {0, 10});
  EXPECT_DOUBLE_EQ(s.rmse, 1);
  EXPECT_DOUBLE_EQ(s.nrmse, 1);
  EXPECT_DOUBLE_EQ(s.bias, 1);
}

// A dead channel showed 0 beside an error of 33 kN, and passed every limit.
TEST(ChannelScores, OfOneValueAloneThereIsNoRelativeError) {
  EXPECT_TRUE(std::isnan(Score({0, 1, 2}, {0, 0, 0}, {5, 0, -5}, {0, 10}).nrmse));
  EXPECT_EQ(Score({0, 1, 2}, {3, 3, 3}, {3, 3, 3}, {0, 10}).nrmse, 0);
}

TEST(ChannelScores, AShareIsAtMostOne) {
  const std::vector<double> ones(50001, 1.0);
  std::vector<double> time(ones.size());
  for (size_t i = 0; i < time.size(); ++i) time[i] = 1e-3 * static_cast<double>(i);
  const ChannelScore s = Score(time, ones, std::vector<double>(ones.size(), 1.01), {0, 100});
  EXPECT_EQ(s.share_below_12_percent, 1);
}

}  // namespace
}  // namespace phs::measurement
