#include "screen/player.h"

#include <GLFW/glfw3.h>
#include <gmock/gmock.h>

#include <set>

namespace phs::screen {
namespace {

Player MakePlayer() { return Player(view::Request{}, 0, 10, 0.01, 2); }

TEST(Player, RunsPausesAndSteps) {
  Player player = MakePlayer();
  player.Advance(0.5);
  EXPECT_DOUBLE_EQ(player.time(), 0.5);
  player.Press(GLFW_KEY_UP, false);
  player.Advance(0.5);
  EXPECT_DOUBLE_EQ(player.time(), 1.5);
  player.Press(GLFW_KEY_RIGHT, false);
  EXPECT_FALSE(player.running());
  EXPECT_DOUBLE_EQ(player.time(), 1.51);
  player.Press(GLFW_KEY_LEFT, true);
  EXPECT_DOUBLE_EQ(player.time(), 1.41);
  player.Advance(1);
  EXPECT_DOUBLE_EQ(player.time(), 1.41);
  player.Press(GLFW_KEY_SPACE, false);
  player.Advance(100);
  EXPECT_DOUBLE_EQ(player.time(), 10);
  EXPECT_FALSE(player.running()) << "stops at the end";
}

TEST(Player, MagnificationGoesRoundAndBogiesToo) {
  Player player = MakePlayer();
  for (const double factor : {10.0, 20.0, 50.0, 1.0}) {
    player.Press(GLFW_KEY_Y, false);
    EXPECT_EQ(player.look().magnify.yaw, factor);
    EXPECT_EQ(player.look().magnify.lateral, 1);
  }
  player.Press(GLFW_KEY_N, false);
  EXPECT_EQ(player.vehicle(), 1);
  player.Press(GLFW_KEY_N, false);
  EXPECT_EQ(player.vehicle(), 0);
}

TEST(Player, EveryKeyIsThereOnceAndInTheHelp) {
  std::set<int> keys;
  for (const KeyRow& row : Keys()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.name;
    EXPECT_THAT(KeyHelp(), ::testing::HasSubstr(std::string(row.name) + ": " + row.text));
    Player player = MakePlayer();
    EXPECT_TRUE(player.Press(row.key, false));
  }
  Player player = MakePlayer();
  EXPECT_FALSE(player.Press(GLFW_KEY_F12, false));
}

}  // namespace
}  // namespace phs::screen
