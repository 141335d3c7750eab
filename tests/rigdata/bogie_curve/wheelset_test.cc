// A lone wheelset of the independent bogie's contact, rolling without mass: at every place the
// speeds at which no force or moment is left. Klingel's wave and the rolling line in a curve.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "wheel_on_rail.h"

namespace bogie_curve {
namespace {

constexpr double kCone = 0.05, kHead = 0.3, kSpeed = 10, kLoad = 120e3;

using Five = Eigen::Matrix<double, 5, 1>;

WheelOnRail ConeOnArc() {
  WheelRailPair pair;
  pair.wheel = Section::Cone(kCone);
  pair.rail = Section::Arc(kHead);
  return WheelOnRail(pair);
}

// What a cone feels like on arcs: as the axle shifts it rolls, and both the cone's foot and the
// place of contact go with it (A. H. Wickens, Fundamentals of Rail Vehicle Dynamics, 2003, conicity
// of circular sections, wheel's radius infinite).
double Conicity(double half_base, double radius) {
  return kCone * (half_base + kHead * kCone) / (half_base - radius * kCone);
}

// Where a cone touches an arc, from the track's middle; and the radius there.
double TouchHalfBase(const WheelOnRail& w) {
  return w.rail_place() - kHead * std::sin(std::atan(kCone));
}
double TouchRadius(const WheelOnRail& w) {
  return w.pair().radius - kCone * (TouchHalfBase(w) - w.pair().half_tape);
}

struct Wheels {
  const WheelOnRail &left, &right;
};

struct Rolling {
  double z, roll, side_speed, yaw_speed, spin;
};

// What is left of the forces on an axle: vertical, roll, lateral, yaw, about the axle.
Five Left(const Wheels& w, double y, double yaw, const Rolling& r) {
  AxleInTrack axle;
  axle.y = y, axle.z = r.z, axle.roll = r.roll, axle.yaw = yaw;
  axle.speed = {kSpeed, r.side_speed, 0};
  const Vector3d e(-std::sin(yaw), std::cos(yaw) * std::cos(r.roll), std::sin(r.roll));
  axle.turn = r.spin * e + Vector3d(0, 0, r.yaw_speed);
  const AxleLoad load = LoadAxle(w.left, w.right, axle);
  Five left;
  left << load.force.z() - kLoad, load.moment.x(), load.force.y(), load.moment.z(),
      load.moment.dot(e);
  return left;
}

// Newton on five of the numbers of a rolling axle, named by pointers.
void Solve(const Wheels& w, double* y, double* yaw, Rolling* r,
           const std::array<double*, 5>& unknown, const std::array<double, 5>& step) {
  for (int i = 0; i < 30; ++i) {
    const Five left = Left(w, *y, *yaw, *r);
    Eigen::Matrix<double, 5, 5> slope;
    for (int k = 0; k < 5; ++k) {
      const double keep = *unknown[k];
      *unknown[k] = keep + step[k];
      slope.col(k) = (Left(w, *y, *yaw, *r) - left) / step[k];
      *unknown[k] = keep;
    }
    const Five change = slope.fullPivLu().solve(left);
    for (int k = 0; k < 5; ++k) *unknown[k] -= change[k];
    if (left.cwiseAbs().maxCoeff() < 1e-3) return;
  }
  ADD_FAILURE() << "no equilibrium at y = " << *y;
}

Rolling FirstGuess(const WheelOnRail& w) {
  const double down = kHead * (1 - std::cos(std::atan(kCone)));
  return {TouchRadius(w) - down - 6e-5, 0, 0, 0, kSpeed / TouchRadius(w)};
}

TEST(LoneWheelset, RunsOnKlingelsWave) {
  const WheelOnRail w = ConeOnArc();
  Rolling r = FirstGuess(w);
  double y = 0, yaw = 8e-4, s = 0, crossed = -1, half_wave = 0;
  const double h = 0.2;  // [m]
  const auto rate = [&](double at_y, double at_yaw) {
    Solve({w, w}, &at_y, &at_yaw, &r, {&r.z, &r.roll, &r.side_speed, &r.yaw_speed, &r.spin},
          {1e-7, 1e-7, 1e-5, 1e-5, 1e-5});
    return std::array<double, 2>{r.side_speed / kSpeed, r.yaw_speed / kSpeed};
  };
  while (half_wave == 0 && s < 30) {
    const auto k = rate(y, yaw);
    const auto m = rate(y + h / 2 * k[0], yaw + h / 2 * k[1]);
    const double next = y + h * m[0];
    if (y * next < 0) {
      const double at = s + h * y / (y - next);
      if (crossed >= 0) half_wave = at - crossed;
      crossed = at;
    }
    y = next, yaw += h * m[1], s += h;
  }
  const double radius = TouchRadius(w), base = TouchHalfBase(w);
  const double klingel = 2 * std::numbers::pi * std::sqrt(radius * base / Conicity(base, radius));
  EXPECT_NEAR(2 * half_wave / klingel, 1, 0.01);
}

TEST(LoneWheelset, RollsFreelyRoundACurveAtItsLine) {
  const WheelOnRail w = ConeOnArc();
  for (const double radius : {3000.0, -3000.0, 6000.0}) {
    Rolling r = FirstGuess(w);
    r.yaw_speed = kSpeed / radius;
    double y = 0, yaw = 0;
    Solve({w, w}, &y, &yaw, &r, {&r.z, &r.roll, &y, &yaw, &r.spin}, {1e-7, 1e-7, 1e-6, 1e-7, 1e-5});
    // A left curve: to the right.
    const double r0 = TouchRadius(w), base = TouchHalfBase(w);
    const double line = -r0 * base / (Conicity(base, r0) * radius);
    EXPECT_NEAR(y / line, 1, 0.01) << radius;
    EXPECT_NEAR(yaw, 0, 1e-5);
  }
}

// An axle with a larger left wheel rolls straight where both radii are alike, to the right by
// d/(2 conicity); and as it leans to the right by d/(2 b), its treads lie to the left by r times
// that.
TEST(LoneWheelset, RunsOffTheMiddleOnUnlikeWheels) {
  const WheelOnRail w = ConeOnArc();
  for (const double d : {1e-4, -3e-5}) {
    WheelRailPair pair = w.pair();
    pair.radius += d;
    const WheelOnRail left(pair);
    Rolling r = FirstGuess(w);
    double y = 0, yaw = 0;
    Solve({left, w}, &y, &yaw, &r, {&r.z, &r.roll, &y, &yaw, &r.spin},
          {1e-7, 1e-7, 1e-6, 1e-7, 1e-5});
    const double base = TouchHalfBase(w), radius = TouchRadius(w);
    const double line = -d / 2 * (1 / Conicity(base, radius) + radius / base);
    EXPECT_NEAR(y / line, 1, 0.03) << d;
  }
}

TEST(WheelOnRail, LeftAndRightMirrorEachOther) {
  const WheelOnRail w = ConeOnArc();
  AxleInTrack one;
  one.y = 0.003, one.z = 0.6248, one.roll = 2e-4, one.yaw = 1e-3;
  one.speed = {kSpeed, 0.01, 0.002}, one.turn = {0.01, 16, 0.02};
  AxleInTrack other = one;
  other.y *= -1, other.roll *= -1, other.yaw *= -1;
  other.speed.y() *= -1, other.turn.x() *= -1, other.turn.z() *= -1;
  const AxleLoad a = LoadAxle(w, w, one), b = LoadAxle(w, w, other);
  ASSERT_GT(a.force.norm(), 1e4);
  EXPECT_EQ(a.force.y(), -b.force.y());
  EXPECT_EQ(a.force.z(), b.force.z());
  EXPECT_EQ(a.moment.z(), -b.moment.z());
}

}  // namespace
}  // namespace bogie_curve
