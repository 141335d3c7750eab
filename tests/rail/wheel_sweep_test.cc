// A wheel moved across its rail and round closed ways: no jump, more force with depth, no energy gained.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "contact_pair.h"

namespace phs::rail {
namespace {

struct Sweep {
  double jump = 0;      ///< largest change of a force per step over the load
  double wander = 0;    ///< largest step of the load's centre on the rail [m]
  double backstep = 0;  ///< of the lateral elastic force, that should only grow
  double at = 0;        ///< where the largest jump is [m]
};
double CentreOnRail(const WheelRailForces& f) {
  double moment = 0, load = 0;
  for (int k = 0; k < f.count; ++k) {
    const ContactPatch& p = f.patch[static_cast<size_t>(k)];
    moment += p.normal * p.rail_y;
    load += p.normal;
  }
  return moment / load;
}
/// Wheel at constant load moved across the rail, from its field side to beyond flange contact.
Sweep Across(const WheelRail& pair, double load, double yaw, double from, double to, double step) {
  Sweep sweep;
  WheelRailForces before;
  for (double y = from; y <= to; y += step) {
    WheelsetMotion m = Rolling(pair, 20, y, 0, yaw);
    const WheelRailForces now = Load(pair, load, &m);
    EXPECT_NEAR(-now.force[2], load, 1) << "no unique height at " << y;
    if (y > from) {
      for (const size_t i : {size_t{0}, size_t{1}}) {
        const double jump = std::abs(now.force[i] - before.force[i]) / load;
        if (jump > sweep.jump) {
          sweep.jump = jump;
          sweep.at = y;
        }
      }
      sweep.wander = std::max(sweep.wander, std::abs(CentreOnRail(now) - CentreOnRail(before)));
      sweep.backstep =
          std::max(sweep.backstep, (now.elastic_force[1] - before.elastic_force[1]) / load);
    }
    before = now;
  }
  return sweep;
}

// The contact jumps from tread to flange within a few hundredths of a millimetre; followed in steps
// of 2 um, no step may move the force or the place by more than a share of that.
TEST(WheelSweep, SlowLateralSweepIsContinuousAndMonotone) {
  const WheelRail pair = Create(StandardPair());
  for (const double load : {1e4, 6e4, 1.3e5}) {
    for (const double yaw : {-8e-3, 0.0, 5e-3}) {
      SCOPED_TRACE("load " + std::to_string(load) + " yaw " + std::to_string(yaw));
      const Sweep tread = Across(pair, load, yaw, -10e-3, 4.5e-3, 10e-6);
      EXPECT_LT(tread.jump, 0.007) << tread.at;
      EXPECT_LT(tread.wander, 0.2e-3);
      EXPECT_LT(tread.backstep, 1e-3);
      const Sweep flange = Across(pair, load, yaw, 4.5e-3, 6.55e-3, 2e-6);
      EXPECT_LT(flange.jump, 0.03) << flange.at;
      EXPECT_LT(flange.wander, 0.3e-3);
      EXPECT_LT(flange.backstep, 1e-3);
    }
  }
}

TEST(WheelSweep, MoreDepthIsMoreForce) {
  const WheelRail pair = Create(StandardPair());
  for (double y = -9e-3; y < 8e-3; y += 0.13e-3) {
    WheelsetMotion m = Rolling(pair, 20, y, 1e-3, 4e-3);
    double before = 0;
    for (double sunk = -0.6e-3; sunk < 0.6e-3; sunk += 5e-6) {
      m.vertical = pair.touching_height() + sunk;
      const double force = -Calc(pair, m).elastic_force[2];
      EXPECT_GE(force, 0.99 * before) << y << " " << sunk;
      before = force;
    }
  }
}

/// Closed way in lateral and vertical position, roll and yaw.
struct Cycle {
  double amplitude[4][3];
  double lowest;
  WheelsetMotion At(double t) const {
    const auto wave = [&](int i) {
      return amplitude[i][0] * std::sin(t) + amplitude[i][1] * std::sin(2 * t + 1) +
             amplitude[i][2] * std::cos(t);
    };
    WheelsetMotion m;
    m.lateral = 3e-3 * wave(0);
    m.vertical = lowest + 3e-5 * wave(1);
    m.roll = 1e-4 * wave(2);
    m.yaw = 4e-3 * wave(3);
    m.speed = 20;
    return m;
  }
};

// Pressed, shifted, turned and released: the work of the elastic forces over a closed cycle is
// none.
TEST(WheelSweep, NoCycleDeliversEnergy) {
  const WheelRail pair = Create(StandardPair());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> pick(-1, 1);
  constexpr int kSteps = 4000;
  for (int trial = 0; trial < 8; ++trial) {
    Cycle cycle{};
    cycle.lowest = pair.touching_height() + 1.2e-4;
    for (auto& row : cycle.amplitude) {
      for (double& value : row) value = pick(random);
    }
    double work = 0, size = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double h = 2 * std::numbers::pi / kSteps;
      const WheelsetMotion a = cycle.At(i * h), m = cycle.At((i + 0.5) * h),
                           b = cycle.At((i + 1) * h);
      const WheelRailForces f = Calc(pair, m);
      const double roll = b.roll - a.roll;
      const Vec3 moved = {0, b.lateral - a.lateral, b.vertical - a.vertical};
      const Vec3 turned = {roll * std::cos(m.yaw), roll * std::sin(m.yaw), b.yaw - a.yaw};
      const double part = Dot(f.elastic_force, moved) + Dot(f.elastic_moment, turned);
      work += part;
      size += std::abs(part);
    }
    EXPECT_GT(size, 50);
    EXPECT_LT(std::abs(work), 2e-3 * size);
  }
}

}  // namespace
}  // namespace phs::rail
