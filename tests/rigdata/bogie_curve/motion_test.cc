// The independent bogie as a whole: it stands by its weight, and takes the radial position.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "sensors.h"
#include "truth.h"

namespace bogie_curve {
namespace {

constexpr char kProfiles[] = PROFILES;

BogieReading After(const BogieMotion& bogie, double s) {
  MotionState state = bogie.Start();
  BogieReading reading = bogie.Read(state);
  while (reading.lead_s < s) {
    for (int i = 0; i < 20; ++i) bogie.Step(5e-4, &state);
    reading = bogie.Read(state);
  }
  return reading;
}

TEST(BogieMotion, StandsOnItsFourWheels) {
  Truth truth = DeclaredTruth("r550");
  truth.bogie.start = -80;
  const TrackLine track(truth.design);
  const BogieReading r = After(MakeBogie(truth, track, kProfiles), 20);
  double sum = 0;
  for (const auto& axle : r.Q) sum += axle[0] + axle[1];
  EXPECT_NEAR(sum, 52000 * 9.81, 0.005 * 52000 * 9.81);
  EXPECT_NEAR(r.Q[0][0], r.Q[0][1], 1);
  EXPECT_NEAR(r.lateral[0], 0, 1e-6);
}

// A box whose springs are stiffer carries more, and with it the corner across; a wheel that is
// larger, too.
TEST(BogieMotion, AStifferBoxAndALargerWheelCarryMore) {
  for (const char* hidden : {"box_spring", "wheel_larger"}) {
    Truth truth = DeclaredTruth("r550");
    truth.bogie.start = -80;
    Hide(hidden, std::string(hidden) == "box_spring" ? 1.3 : 1e-3, &truth);
    const TrackLine track(truth.design);
    const BogieReading r = After(MakeBogie(truth, track, kProfiles), 0);
    const double across = r.Q[0][0] + r.Q[1][1], other = r.Q[0][1] + r.Q[1][0];
    EXPECT_GT(across, other + 300) << hidden;
    EXPECT_NEAR(across + other, 52000 * 9.81, 0.005 * 52000 * 9.81) << hidden;
  }
}

// An uneven bogie comes to the measured place at rest: what it swings there the seals would keep.
TEST(Measure, AnUnevenBogieComesAtRest) {
  Truth truth = DeclaredTruth("r550");
  Hide("box_spring", 0.6, &truth);
  const TrackLine track(truth.design);
  RunWish wish;
  wish.last_s = 40;
  const MeasuredRun run = Measure(MakeBogie(truth, track, kProfiles), wish);
  const auto column = [&](const std::string& name) {
    const auto at = std::find(run.names.begin(), run.names.end(), name);
    return run.columns[static_cast<size_t>(at - run.names.begin())];
  };
  for (const auto& [name, most] : {std::pair{"lead_lateral_m", 3e-4}, {"piston1_m", 3e-5}}) {
    const std::vector<double> y = column(name);
    const auto [low, high] = std::minmax_element(y.begin(), y.end());
    EXPECT_LT(*high - *low, most) << name;
  }
}

// In the curve the axles take the radial position: the bending of 3.1 m on R = 550 m is 5.64 mrad,
// which is a piston's way of 0.9 m times half of it.
TEST(BogieMotion, TakesTheRadialPosition) {
  Truth truth = DeclaredTruth("r550");
  truth.bogie.start = 20;
  const TrackLine track(truth.design);
  const BogieReading r = After(MakeBogie(truth, track, kProfiles), 300);
  const double way = 0.9 * 3.1 / (2 * 550);
  EXPECT_NEAR(r.piston[0], -way, 0.1 * way);
  EXPECT_NEAR(r.piston[1], way, 0.1 * way);
  EXPECT_LT(std::abs(r.angle_of_attack[0]), 3e-4);
  EXPECT_LT(r.lateral[0], -0.003) << "to the outer rail";
  // Cant deficiency: m (v^2/R - g h/e) to the outside.
  const double v = 80 / 3.6;
  const double outward = 52000 * (v * v / 550 - 9.81 * 0.06 / 1.139);
  const double Y = r.Y[0][1] - r.Y[0][0] + r.Y[1][1] - r.Y[1][0];
  EXPECT_NEAR(Y, outward, 0.05 * outward);
}

TEST(Truth, SameSeedSameRecord) {
  Truth a = DeclaredTruth("r300"), b = DeclaredTruth("r300"), c = DeclaredTruth("r300");
  DrawOffDeclared(3, &a), DrawOffDeclared(3, &b), DrawOffDeclared(4, &c);
  EXPECT_EQ(TruthJson(a, ""), TruthJson(b, ""));
  EXPECT_NE(TruthJson(a, ""), TruthJson(c, ""));
  EXPECT_THROW(Hide("nothing_such", 1, &a), std::invalid_argument);
  EXPECT_THROW(DeclaredTruth("r1"), std::invalid_argument);
}

}  // namespace
}  // namespace bogie_curve
