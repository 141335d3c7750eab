#include "base/axle_words.h"

#include <gtest/gtest.h>

#include <cmath>

namespace phs {
namespace {

TEST(RailPointedTo, AnAxleYawedToTheRightOfALeftCurvePointsToItsOuterRail) {
  EXPECT_STREQ(RailPointedTo(-4.6e-3, 1), "outer");
  EXPECT_STREQ(RailPointedTo(4.6e-3, 1), "inner");
}

TEST(RailPointedTo, TheMirrorImageReadsTheSame) {
  EXPECT_STREQ(RailPointedTo(4.6e-3, -1), RailPointedTo(-4.6e-3, 1));
  EXPECT_STREQ(RailPointedTo(-4.6e-3, -1), RailPointedTo(4.6e-3, 1));
}

TEST(RailPointedTo, OnStraightTrackItSaysLeftOrRight) {
  EXPECT_STREQ(RailPointedTo(1e-3, 0), "left");
  EXPECT_STREQ(RailPointedTo(-1e-3, 0), "right");
  EXPECT_STREQ(RailPointedTo(std::nan(""), 1), "");
}

}  // namespace
}  // namespace phs
