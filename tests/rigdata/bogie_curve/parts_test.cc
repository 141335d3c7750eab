// The parts of the independent bogie, each alone, against closed formulas and published numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "creep.h"
#include "hertz_ellipse.h"
#include "steering_oil.h"
#include "track_line.h"

namespace bogie_curve {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(HertzEllipse, ASphereOnAPlane) {
  const Material steel;
  const HertzEllipse hertz(steel);
  const double radius = 0.4, depth = 8e-5;
  const Ellipse e = hertz.At(0.5 / radius, 0.5 / radius, depth);
  const double modulus = steel.shear_modulus / (1 - steel.poisson);
  EXPECT_NEAR(e.a / std::sqrt(radius * depth), 1, 1e-6);
  EXPECT_NEAR(e.b / e.a, 1, 1e-6);
  EXPECT_NEAR(e.normal / (4.0 / 3 * modulus * std::sqrt(radius) * std::pow(depth, 1.5)), 1, 1e-6);
}

// The program CONTACT: a = 8 mm, b = 4 mm, 82 kN, G = 82 GPa, nu = 0.28: 0.09267 mm, 1223 MPa.
// Curvatures of g = 1/2 from tables: K = 2.15652, E = 1.21106.
TEST(HertzEllipse, ContactsPublishedEllipse) {
  const double K = 2.156516, E = 1.211056, depth = 9.267e-5;
  const double sum = depth * E / (K * 16e-6), ratio = (4 * E - K) / (K - E);
  const Ellipse e =
      HertzEllipse(Material{}).At(sum / (1 + ratio), sum * ratio / (1 + ratio), depth);
  EXPECT_NEAR(e.a, 8e-3, 1e-5);
  EXPECT_NEAR(e.b, 4e-3, 5e-6);
  EXPECT_NEAR(e.normal, 82e3, 200);
  EXPECT_NEAR(e.pressure, 1223e6, 4e6);
}

TEST(Creep, KalkersTable) {
  const KalkerNumbers round = CalcKalkerNumbers(1, 0.25), slim = CalcKalkerNumbers(0.1, 0.5);
  EXPECT_DOUBLE_EQ(round.c11, 4.12);
  EXPECT_DOUBLE_EQ(round.c22, 3.67);
  EXPECT_DOUBLE_EQ(round.c23, 1.47);
  EXPECT_DOUBLE_EQ(round.c33, 1.19);
  EXPECT_DOUBLE_EQ(slim.c11, 4.85);
  EXPECT_NEAR(CalcKalkerNumbers(10, 0.25).c23, 14.6, 1e-9);
  EXPECT_NEAR(CalcKalkerNumbers(1.25, 0.25).c22, 3.99, 1e-9);
}

Ellipse SomePatch() {
  Ellipse e;
  e.a = 7e-3, e.b = 4e-3, e.normal = 1e5;
  return e;
}

TEST(Creep, LimitsAreTheLinearTheoryAndFriction) {
  const Material steel;
  const Ellipse e = SomePatch();
  for (const Creepage& direction :
       {Creepage{1, 0, 0}, Creepage{0, 1, 0}, Creepage{0, 0, 100}, Creepage{1, -0.5, 60}}) {
    const Creepage small{1e-7 * direction.v1, 1e-7 * direction.v2, 1e-7 * direction.wn};
    const CreepWrench linear = CalcLinearCreep(e, steel, small);
    const CreepWrench force = CalcCreep(e, steel, 0.35, small);
    const double size = std::hypot(linear.f1, linear.f2);
    EXPECT_NEAR(force.f1, linear.f1, 0.02 * size);
    EXPECT_NEAR(force.f2, linear.f2, 0.02 * size);
  }
  const CreepWrench slides = CalcCreep(e, steel, 0.35, {0.3, 0.4, 0});
  EXPECT_NEAR(slides.f1, -0.35 * e.normal * 0.6, 0.02 * e.normal);
  EXPECT_NEAR(slides.f2, -0.35 * e.normal * 0.8, 0.02 * e.normal);
}

TEST(Creep, NeverBeyondFrictionAndAlwaysDissipates) {
  const Material steel;
  const Ellipse e = SomePatch();
  for (int i = 0; i < 200; ++i) {
    const Creepage c{0.01 * std::sin(3.0 * i), 0.01 * std::cos(1.7 * i), 2 * std::sin(0.9 * i)};
    const CreepWrench w = CalcCreep(e, steel, 0.3, c);
    EXPECT_LE(std::hypot(w.f1, w.f2), 0.3 * e.normal * 1.02);
    EXPECT_LT(w.f1 * c.v1 + w.f2 * c.v2 + w.mn * c.wn, 0);
  }
}

TEST(TrackLine, TurnsByLengthOverRadiusAndFindsItsPlace) {
  CurveDesign design;
  const TrackLine track(design);
  const LinePose end = track.At(track.Length());
  EXPECT_NEAR(end.heading, (design.arc + design.transition) / design.radius, 1e-12);
  const double in_arc = design.tangent + design.transition + 100;
  const LinePose arc = track.At(in_arc);
  EXPECT_DOUBLE_EQ(arc.curvature, 1 / design.radius);
  // Two places on the arc lie on a circle.
  const double chord = (track.At(in_arc + 150).origin - arc.origin).norm();
  EXPECT_NEAR(chord, 2 * design.radius * std::sin(75 / design.radius), 1e-6);
  EXPECT_NEAR(std::asin(-arc.left.z()), std::asin(design.cant / design.base), 1e-12);
  EXPECT_GT(arc.left.y(), 0);
  for (const double s : {-30.0, 90.0, in_arc, 505.0}) {
    const LinePose pose = track.At(s);
    EXPECT_NEAR(track.Project(pose.origin + 0.03 * pose.left, s - 25), s, 1e-6);
  }
}

TEST(SteeringOil, SteeringIsFreeAndShearIsNot) {
  const SteeringOil oil(SteeringNumbers::Measured());
  const SteeringOil::Four bending = {0.01, -0.01, -0.01, 0.01}, shear = {0.01, -0.01, 0.01, -0.01};
  for (const double rate : oil.PressureRate(oil.Rest(), bending)) EXPECT_EQ(rate, 0);
  EXPECT_LT(oil.PressureRate(oil.Rest(), shear)[1], -1e6);
  EXPECT_EQ(oil.PressureRate(oil.Rest(), shear)[0], 0);
}

// Both pistons of a bore line move by x: V/beta (p - p0) + V_g0 (1 - p0/p) = -2 A x.
TEST(SteeringOil, PressureFollowsTheVolumeBalance) {
  const SteeringNumbers numbers = SteeringNumbers::Declared();
  const SteeringOil oil(numbers);
  const double area = kPi / 4 * numbers.bore * numbers.bore, speed = -0.002, h = 1e-4;
  SteeringOil::Four p = oil.Rest();
  for (int i = 0; i < 2500; ++i) {
    SteeringOil::Four middle = p;
    const auto half = oil.PressureRate(p, {speed, 0, speed, 0});
    for (size_t l = 0; l < 4; ++l) middle[l] += h / 2 * half[l];
    const auto rate = oil.PressureRate(middle, {speed, 0, speed, 0});
    for (size_t l = 0; l < 4; ++l) p[l] += h * rate[l];
  }
  const LineNumbers& line = numbers.line[1];
  const double taken =
      line.oil / line.bulk_modulus * (p[1] - line.rest) + line.gas * (1 - line.rest / p[1]);
  EXPECT_NEAR(taken / (2 * area * 0.0005), 1, 1e-6);
  // At rest no force: p_bore A_bore = p_rod A_rod.
  for (const double f : oil.Tension(oil.Rest(), {}, {})) EXPECT_NEAR(f, 0, 1e-6);
}

TEST(SteeringOil, SealsStickThenSlideAtTheirLevel) {
  const SteeringNumbers numbers = SteeringNumbers::Declared();
  const SteeringOil oil(numbers);
  SteeringOil::Four w{};
  const SteeringOil::Four out = {0.001, 0.001, 0.001, 0.001};
  for (int i = 0; i < 60000; ++i) {
    const auto rate = oil.BristleRate(out, w);
    if (i < 100) {
      EXPECT_EQ(rate[0], 0.001) << "sticks";
    }
    for (size_t k = 0; k < 4; ++k) w[k] += 1e-5 * rate[k];
  }
  EXPECT_NEAR(oil.Tension(oil.Rest(), out, w)[0], 1850, 1);
  const SteeringOil::Four in = {-0.001, -0.001, -0.001, -0.001};
  EXPECT_EQ(oil.BristleRate(in, w)[0], -0.001) << "turns back elastically";
}

}  // namespace
}  // namespace bogie_curve
