// Manchester contact benchmark, case, left wheel, against CONTACT's printed result
// (github.com/eve70a/CONTACT, examples/mbench_a22_left, Apache-2.0): 21 positions, 10 kN per wheel.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/table.h"
#include "rail/wheel_rail.h"

namespace phs::rail {
namespace {

WheelRail Pair() {
  WheelRailParams p;
  p.wheel_profile = PHS_SOURCE_DIR "/models/profiles/S1002.prw";
  p.rail_profile = PHS_SOURCE_DIR "/models/profiles/UIC60.prr";
  p.gauge = 1.435;
  p.gauge_height = 0.014;
  p.flange_back_distance = 1.360;
  p.flange_back_position = -0.070;
  p.wheel_radius = 0.460;
  p.tread.coefficient = 0.3;
  p.flange.coefficient = 0.3;
  p.damping_ratio = 0;
  p.creep.method = "fastsim";
  auto pair = WheelRail::Create(p);
  EXPECT_TRUE(pair.ok());
  return std::move(pair).value();
}

/// One row of the reference in the canonical frame: the left wheel mirrored (frames.h).
struct Position {
  double y, roll, yaw, speed, pitch_rate;
  double rail_y, angle, xi, eta, phi, normal, fx, fy;
};

std::vector<Position> ReadPositions() {
  auto table = ReadCsv(PHS_TEST_DATA "/mbench_a22_left_ref.csv");
  EXPECT_TRUE(table.ok());
  const auto column = [&](const char* name) { return table.value().Column(name).value(); };
  const auto y = column("Y_WS"), roll = column("ROLL_WS"), yaw = column("YAW_WS"),
             vx = column("VX_WS"), pitch = column("VPITCH_WS"), ycp = column("YCP(R)"),
             angle = column("DELTCP(TR)"), xi = column("CKSI"), eta = column("CETA"),
             phi = column("CPHI"), fn = column("FN"), fx = column("FX"), fs = column("FS");
  std::vector<Position> rows;
  for (size_t i = 0; i < y.size(); ++i) {
    rows.push_back({-y[i] * 1e-3, -roll[i], -yaw[i], vx[i] * 1e-3, pitch[i], -ycp[i] * 1e-3,
                    angle[i], xi[i], -eta[i], -phi[i] * 1e3, fn[i], fx[i], -fs[i]});
  }
  return rows;
}

/// Forces with the wheelset lowered until the rail carries 10 kN.
WheelRailForces UnderLoad(const WheelRail& pair, const Position& p) {
  WheelsetMotion motion;
  motion.lateral = p.y;
  motion.roll = p.roll;
  motion.yaw = p.yaw;
  motion.velocity = {p.speed, 0, 0};
  // Pitch is about the wheelset's own, yawed and rolled axle.
  motion.rotation = {-p.pitch_rate * std::sin(p.yaw) * std::cos(p.roll),
                     p.pitch_rate * std::cos(p.yaw) * std::cos(p.roll),
                     p.pitch_rate * std::sin(p.roll)};
  motion.speed = p.speed;
  double high = pair.touching_height() - 0.01;
  double low = pair.touching_height() + 0.01;
  WheelRailForces out;
  for (int i = 0; i < 60; ++i) {
    motion.vertical = 0.5 * (high + low);
    pair.Calc(motion, Side::kRight, {}, {}, &out);
    (-out.force[2] < 10000 ? high : low) = motion.vertical;
  }
  return out;
}

const ContactPatch& MainPatch(const WheelRailForces& forces) {
  int main = 0;
  for (int k = 1; k < forces.count; ++k) {
    if (forces.patch[static_cast<size_t>(k)].normal >
        forces.patch[static_cast<size_t>(main)].normal) {
      main = k;
    }
  }
  return forces.patch[static_cast<size_t>(main)];
}

TEST(ManchesterTest, ContactPositionAngleCreepagesAndForcesAgainstContact) {
  const WheelRail pair = Pair();
  const std::vector<Position> positions = ReadPositions();
  ASSERT_EQ(positions.size(), 21u);
  // Row 1 lies where the contact jumps (two patches here, one wide patch in CONTACT), row 2 next to
  // it.
  for (size_t i = 1; i < positions.size(); ++i) {
    SCOPED_TRACE("row " + std::to_string(i + 1));
    const Position& p = positions[i];
    const WheelRailForces f = UnderLoad(pair, p);
    const ContactPatch& c = MainPatch(f);
    EXPECT_NEAR(c.rail_y, p.rail_y, i == 1 ? 0.45e-3 : 0.3e-3);
    EXPECT_NEAR(c.angle, p.angle, 1.5e-3);
    // CONTACT refers creepages to the mean of rolling and forward speed: 1.5 % at the largest slip.
    EXPECT_NEAR(c.xi, p.xi, 1e-4 + 0.013 * std::abs(p.xi));
    EXPECT_NEAR(c.eta, p.eta, 1e-4 + 0.013 * std::abs(p.eta));
    EXPECT_NEAR(c.phi, p.phi, 0.004);  // [1/m]
    EXPECT_NEAR(c.normal / p.normal, 1, 0.01);
    // As a vector, against the bound mu N.
    EXPECT_LT(std::hypot(c.creep.x - p.fx, c.creep.y - p.fy), 0.06 * 0.3 * p.normal);
  }
}

}  // namespace
}  // namespace phs::rail
