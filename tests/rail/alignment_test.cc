// Geometry of the alignment: clothoids, arcs, cant, gradients, projection, mirror images.
#include "rail/alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

namespace phs::rail {
namespace {

using ::testing::HasSubstr;

TrackSegment Tangent(double length, double gradient = 0) {
  TrackSegment segment;
  segment.length = length;
  segment.gradient = gradient;
  segment.where = "tangent";
  return segment;
}

TrackSegment Curve(double length, double curvature, double cant = 0, double widening = 0) {
  TrackSegment segment;
  segment.kind = SegmentKind::kCurve;
  segment.length = length;
  segment.curvature_begin = segment.curvature_end = curvature;
  segment.cant_begin = segment.cant_end = cant;
  segment.widening_begin = segment.widening_end = widening;
  segment.where = "curve";
  return segment;
}

TrackSegment Transition(double length, const TrackSegment& from, const TrackSegment& to) {
  TrackSegment segment;
  segment.kind = SegmentKind::kTransition;
  segment.length = length;
  segment.curvature_begin = from.curvature_end;
  segment.curvature_end = to.curvature_begin;
  segment.cant_begin = from.cant_end;
  segment.cant_end = to.cant_begin;
  segment.widening_begin = from.widening_end;
  segment.widening_end = to.widening_begin;
  segment.where = "transition";
  return segment;
}

// Tangent 80, clothoid 60, arc 250, clothoid 60, tangent 80 m; with `reverse` a second arc to the
// other hand. Uphill in the middle.
AlignmentParams Course(double curvature = 1 / 550.0, double cant = 0.06, bool reverse = false) {
  AlignmentParams params;
  const TrackSegment straight = Tangent(80);
  const TrackSegment first = Curve(250, curvature, cant, 0.01);
  const TrackSegment second = Curve(120, -curvature, -cant);
  params.segments = {straight, Transition(60, straight, first), first};
  if (reverse) {
    params.segments.push_back(Transition(100, first, second));
    params.segments.push_back(second);
  }
  const TrackSegment last = params.segments.back();
  params.segments.push_back(Transition(60, last, straight));
  params.segments.push_back(straight);
  params.segments[2].gradient = 0.010;
  params.cant_base = 1.139;
  return params;
}

Alignment Make(const AlignmentParams& params) {
  Result<Alignment> made = Alignment::Create(params);
  if (!made.ok()) ADD_FAILURE() << made.error().Line();
  return std::move(made).value();
}

Vec3 Minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Abramowitz & Stegun (1964) table 7.7: C(1) = 0.77989 34004, S(1) = 0.43825 91474. A clothoid of
// length L from 0 to curvature pi/L turns by pi/2 and ends at L (C(1), S(1)).
TEST(AlignmentClothoid, EndPointEqualsFresnelIntegralsOfAbramowitzStegunTable77) {
  constexpr double kC1 = 0.7798934003768228;
  constexpr double kS1 = 0.4382591473903548;
  for (double length : {200.0, 300.0, 500.0}) {
    AlignmentParams params;
    const TrackSegment straight = Tangent(20);
    const TrackSegment curve = Curve(0.3 * length, std::numbers::pi / length);
    params.segments = {straight, Transition(length, straight, curve), curve,
                       Transition(length, curve, straight), straight};
    const Alignment alignment = Make(params);
    const TrackFrame end = alignment.FrameAt(20 + length);
    EXPECT_NEAR(end.origin[0], 20 + length * kC1, 1e-10) << length;
    EXPECT_NEAR(end.origin[1], length * kS1, 1e-10) << length;
    EXPECT_NEAR(end.heading, std::numbers::pi / 2, 1e-13);
  }
}

// Power series of the clothoid from zero curvature, an independent way to the point at any length.
TEST(AlignmentClothoid, PointsInsideEqualPowerSeries) {
  const Alignment alignment = Make(Course());
  const double rate = 1 / 550.0 / 60;
  for (double u : {0.1, 7.3, 29.999, 45.0, 60.0}) {
    double x = 0;
    double y = 0;
    double term = u;  // (rate/2)^n u^(2n+1)/n!
    for (int n = 0; n < 12; ++n) {
      const double sign = n % 4 < 2 ? 1 : -1;
      (n % 2 == 0 ? x : y) += sign * term / (2 * n + 1);
      term *= rate / 2 * u * u / (n + 1);
    }
    const TrackFrame frame = alignment.FrameAt(80 + u);
    EXPECT_NEAR(frame.origin[0], 80 + x, 2e-13 * 100);
    EXPECT_NEAR(frame.origin[1], y, 2e-13 * 100);
  }
}

TEST(AlignmentArc, PointsLieOnOneCircleAndHeadingTurnsWithLength) {
  const Alignment alignment = Make(Course());
  const TrackFrame begin = alignment.FrameAt(140);
  const double centre[2] = {begin.origin[0] - 550 * std::sin(begin.heading),
                            begin.origin[1] + 550 * std::cos(begin.heading)};
  for (double s = 140; s <= 390; s += 3.7) {
    const TrackFrame frame = alignment.FrameAt(s);
    EXPECT_NEAR(std::hypot(frame.origin[0] - centre[0], frame.origin[1] - centre[1]), 550, 1e-10);
    EXPECT_NEAR(frame.heading - begin.heading, (s - 140) / 550, 1e-13);
    EXPECT_NEAR(frame.curvature, 1 / 550.0, 1e-17);
  }
  // The whole curve turns by L/R + two half transitions.
  EXPECT_NEAR(alignment.FrameAt(450).heading, (250 + 60) / 550.0, 1e-13);
}

TEST(AlignmentPlan, EqualsFineQuadratureOfTheHeading) {
  const Alignment alignment = Make(Course(1 / 300.0, 0.05, true));
  // Composite midpoint rule with Richardson extrapolation on the heading the frames report.
  auto integrate = [&](int steps) {
    double x = 0;
    for (int i = 0; i < steps; ++i) {
      x += std::cos(alignment.FrameAt((i + 0.5) * alignment.length() / steps).heading);
    }
    return x * alignment.length() / steps;
  };
  const double coarse = integrate(20000);
  const double fine = integrate(40000);
  EXPECT_NEAR(alignment.FrameAt(alignment.length()).origin[0], fine + (fine - coarse) / 3, 1e-8);
}

TEST(AlignmentFrame, IsOrthonormalAndRightHanded) {
  const Alignment alignment = Make(Course(1 / 300.0, 0.08, true));
  for (double s = -20; s < alignment.length() + 20; s += 1.3) {
    const TrackFrame f = alignment.FrameAt(s);
    EXPECT_NEAR(Dot(f.forward, f.forward), 1, 4e-16 * 4);
    EXPECT_NEAR(Dot(f.left, f.left), 1, 4e-16 * 4);
    EXPECT_NEAR(Dot(f.forward, f.left), 0, 1e-15);
    const Vec3 up = Cross(f.forward, f.left);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(f.up[i], up[i], 1e-15);
  }
}

// Derivatives against central differences: origin along x_T, heading by curvature, rotation of the
// frame about z by curvature (times cosines) and about x by the twist.
TEST(AlignmentFrame, DerivativesEqualCurvatureSlopeAndTwist) {
  const Alignment alignment = Make(Course(1 / 300.0, 0.08, true));
  const double h = 1e-4;
  for (double s = 1.23; s < alignment.length(); s += 2.71) {
    const TrackFrame f = alignment.FrameAt(s);
    const TrackFrame a = alignment.FrameAt(s - h);
    const TrackFrame b = alignment.FrameAt(s + h);
    const Vec3 d_origin = Minus(b.origin, a.origin);
    const double run = std::hypot(d_origin[0], d_origin[1]);
    EXPECT_NEAR(run / (2 * h), 1, 1e-9) << s;
    const double length = std::sqrt(Dot(d_origin, d_origin));
    EXPECT_NEAR(Dot(d_origin, f.forward) / length, 1, 1e-9) << s;
    EXPECT_NEAR((b.heading - a.heading) / (2 * h), f.curvature, 2e-8) << s;
    const Vec3 d_left = Minus(b.left, a.left);
    // y_T' . x_T = -k (projected), y_T' . z_T = -twist - k sin(slope)…: level part of the turn.
    const double slope = f.forward[2];
    const double flat = std::sqrt(1 - slope * slope);
    const double bend = (std::asin(b.forward[2]) - std::asin(a.forward[2])) / (2 * h);
    EXPECT_NEAR(Dot(d_left, f.forward) / (2 * h),
                -f.curvature * flat * std::cos(f.cant) + bend * std::sin(f.cant), 1e-8)
        << s;
    EXPECT_NEAR(Dot(d_left, f.up) / (2 * h), -alignment.TwistAt(s) + f.curvature * slope, 1e-8)
        << s;
  }
}

TEST(AlignmentFrame, CurvatureAndSlopesHaveNoJumps) {
  const Alignment alignment = Make(Course(1 / 300.0, 0.08, true));
  const double h = 0.01;
  for (double s = -5; s < alignment.length() + 5; s += h) {
    const TrackFrame a = alignment.FrameAt(s);
    const TrackFrame b = alignment.FrameAt(s + h);
    ASSERT_LE(std::abs(b.curvature - a.curvature), 1.01 * h / 300 / 50) << s;
    ASSERT_LE(std::abs(b.forward[2] - a.forward[2]), 2e-3 * h) << s;  // 1/R_v + rounding of ramps
    ASSERT_LE(std::abs(b.cant - a.cant), 3e-3 * h) << s;
    ASSERT_LE(std::abs(alignment.TwistAt(s + h) - alignment.TwistAt(s)), 1e-3 * h) << s;
  }
}

TEST(AlignmentCant, RampIsLinearAndRaisesTheOuterRailOnly) {
  AlignmentParams params = Course(1 / 550.0, 0.06, true);
  for (TrackSegment& segment : params.segments) segment.gradient = 0;
  const Alignment alignment = Make(params);
  EXPECT_DOUBLE_EQ(alignment.FrameAt(200).cant, std::asin(0.06 / 1.139));
  EXPECT_DOUBLE_EQ(std::sin(alignment.FrameAt(110).cant) * 1.139, 0.03);
  EXPECT_NEAR(std::sin(alignment.FrameAt(125).cant) * 1.139, 0.045, 1e-15);
  EXPECT_LT(alignment.FrameAt(alignment.length() - 200).cant, 0);
  const double crossing = 440;  // of the clothoid between the hands, rounded over +-3 m
  for (double s = 0; s < alignment.length(); s += 0.7) {
    const TrackFrame f = alignment.FrameAt(s);
    const double left = f.origin[2] + 0.5 * 1.139 * f.left[2];
    const double right = f.origin[2] - 0.5 * 1.139 * f.left[2];
    const double low = s < crossing ? left : right;
    // left[2] = -sin(cant) cos(slope): the slope of the ramp (0.5e-3) enters squared.
    EXPECT_NEAR(low, 0, std::abs(s - crossing) < 3.01 ? 1e-3 : 1e-7) << s;
  }
}

TEST(AlignmentCant, AboutTheCentreLineKeepsItsHeight) {
  AlignmentParams params = Course();
  params.pivot = CantPivot::kCentreLine;
  params.segments[2].gradient = 0;
  const Alignment alignment = Make(params);
  for (double s = 0; s < alignment.length(); s += 5) {
    EXPECT_EQ(alignment.FrameAt(s).origin[2], 0);
  }
}

TEST(AlignmentGauge, WideningRampsLinearlyOverTheTransition) {
  const Alignment alignment = Make(Course());
  EXPECT_EQ(alignment.WideningAt(40).value, 0);
  EXPECT_NEAR(alignment.WideningAt(110).value, 0.005, 1e-16);
  EXPECT_NEAR(alignment.WideningAt(110).slope, 0.01 / 60, 1e-16);
  EXPECT_DOUBLE_EQ(alignment.WideningAt(200).value, 0.01);
}

TEST(AlignmentGradient, HeightIsSumOfGradientsAndVerticalCurveHasItsRadius) {
  AlignmentParams params;
  params.vertical_radius = 4000;
  params.segments = {Tangent(200), Tangent(300, 0.012), Tangent(200, -0.005)};
  const Alignment alignment = Make(params);
  EXPECT_NEAR(alignment.FrameAt(700).origin[2], 0.012 * 300 - 0.005 * 200, 1e-12);
  EXPECT_NEAR(alignment.FrameAt(350).origin[2], 0.012 * 150, 1e-12);
  const double h = 0.5;
  auto z = [&](double s) { return alignment.FrameAt(s).origin[2]; };
  EXPECT_NEAR((z(200 + h) - 2 * z(200) + z(200 - h)) / (h * h), 1 / 4000.0, 1e-12);
  EXPECT_NEAR((z(500 + h) - 2 * z(500) + z(500 - h)) / (h * h), -1 / 4000.0, 1e-12);
  EXPECT_NEAR((z(300 + h) - 2 * z(300) + z(300 - h)) / (h * h), 0, 1e-12);
  // Apex correction of the vertical curve: T^2/(2 R) with T = R |dg|/2.
  const double t = 4000 * 0.012 / 2;
  EXPECT_NEAR(z(200), t * t / (2 * 4000), 1e-12);
}

TEST(AlignmentEnds, GoOnStraight) {
  const Alignment alignment = Make(Course());
  const double length = alignment.length();
  const TrackFrame end = alignment.FrameAt(length);
  const TrackFrame beyond = alignment.FrameAt(length + 1000);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(beyond.origin[i], end.origin[i] + 1000 * end.forward[i], 1e-9);
    EXPECT_EQ(beyond.forward[i], end.forward[i]);
  }
  const TrackFrame before = alignment.FrameAt(-300);
  EXPECT_EQ(before.origin, (Vec3{-300, 0, 0}));
  EXPECT_EQ(alignment.Project({-300, 0.3, 0.6}), -300);
  EXPECT_NEAR(alignment.Project(beyond.origin), length + 1000, 1e-9);
}

TEST(AlignmentProjection, FindsTheFrameOfAnyPointNearTheTrack) {
  const Alignment course = Make(Course(1 / 550.0, 0.06, true));
  const Alignment tight = Make(Course(1 / 90.0, 0.05));
  rc::check("Project(origin + y left + z up) == s", [&]() {
    const Alignment& alignment = **rc::gen::element(&course, &tight);
    const double unit = *rc::gen::inRange(0, 1000001) * 1e-6;
    const double s = -60 + unit * (alignment.length() + 120);
    const double y = *rc::gen::inRange(-3000, 3001) * 1e-3;
    const double z = *rc::gen::inRange(-500, 3001) * 1e-3;
    const TrackFrame f = alignment.FrameAt(s);
    Vec3 point = f.origin;
    for (int i = 0; i < 3; ++i) point[i] += y * f.left[i] + z * f.up[i];
    RC_ASSERT(std::abs(alignment.Project(point) - s) < 1e-9);
  });
}

TEST(AlignmentProjection, PointsThrownFarOffStillProject) {
  const Alignment alignment = Make(Course());
  for (double s : {30.0, 200.0, 430.0}) {
    const TrackFrame f = alignment.FrameAt(s);
    Vec3 point = f.origin;
    for (int i = 0; i < 3; ++i) point[i] -= 60 * f.left[i];
    EXPECT_NEAR(alignment.Project(point), s, 1e-6);
  }
  EXPECT_TRUE(std::isnan(alignment.Project({std::nan(""), 0, 0})));
}

TEST(AlignmentMirror, OtherHandIsTheMirrorImageToTheLastBit) {
  const Alignment left = Make(Course(1 / 317.0, 0.0613, true));
  const Alignment right = Make(Course(-1 / 317.0, -0.0613, true));
  ASSERT_EQ(left.length(), right.length());
  for (double s = -10; s < left.length() + 10; s += 0.377) {
    const TrackFrame a = left.FrameAt(s);
    const TrackFrame b = right.FrameAt(s);
    EXPECT_EQ(a.origin, (Vec3{b.origin[0], -b.origin[1], b.origin[2]}));
    EXPECT_EQ(a.forward, (Vec3{b.forward[0], -b.forward[1], b.forward[2]}));
    EXPECT_EQ(a.left, (Vec3{-b.left[0], b.left[1], -b.left[2]}));
    EXPECT_EQ(a.up, (Vec3{b.up[0], -b.up[1], b.up[2]}));
    EXPECT_EQ(a.curvature, -b.curvature);
    EXPECT_EQ(a.heading, -b.heading);
    EXPECT_EQ(a.cant, -b.cant);
    EXPECT_EQ(left.TwistAt(s), -right.TwistAt(s));
    const Vec3 point = {a.origin[0] + 0.1, a.origin[1] + 0.2, 0.6};
    EXPECT_EQ(left.Project(point), right.Project({point[0], -point[1], point[2]}));
  }
}

std::string Failure(const AlignmentParams& params) {
  Result<Alignment> made = Alignment::Create(params);
  return made.ok() ? "ok" : made.error().Line();
}

TEST(AlignmentErrors, JumpsAreNamedWithPlaceAndMend) {
  AlignmentParams jump = Course();
  jump.segments = {Tangent(50), Curve(100, 1 / 400.0), Tangent(50)};
  EXPECT_THAT(Failure(jump),
              AllOf(HasSubstr("curve: the curvature jumps from straight to R = 400 m left"),
                    HasSubstr("kind: transition")));
  AlignmentParams cant = Course();
  cant.segments.insert(cant.segments.begin() + 3, Curve(50, 1 / 550.0, 0.03, 0.01));
  EXPECT_THAT(Failure(cant), HasSubstr("the cant jumps from 60.0"));
  AlignmentParams gauge = Course();
  gauge.segments.insert(gauge.segments.begin() + 3, Curve(50, 1 / 550.0, 0.06, 0));
  EXPECT_THAT(Failure(gauge), HasSubstr("the gauge jumps"));
  AlignmentParams ends = Course();
  ends.segments.pop_back();
  EXPECT_THAT(Failure(ends), HasSubstr("begins or ends outside a tangent"));
}

TEST(AlignmentErrors, VerticalCurveThatDoesNotFit) {
  AlignmentParams params;
  params.segments = {Tangent(100), Tangent(30, 0.02), Tangent(100)};
  EXPECT_THAT(Failure(params), AllOf(HasSubstr("the vertical curve needs 100 m"),
                                     HasSubstr("holds for 30 m"), HasSubstr("vertical_radius_m")));
}

TEST(AlignmentGradient, VerticalCurvesMayTouchEachOther) {
  for (double first : {100.0, 123.4567, 777.1}) {
    AlignmentParams params;
    params.segments = {Tangent(first), Tangent(100, 0.02), Tangent(100), Tangent(60)};
    EXPECT_EQ(Failure(params), "ok");  // 5000 m * 0.02 / 2 = 50 m from both ends of the second
  }
}

TEST(AlignmentErrors, TrackThatMeetsItself) {
  AlignmentParams params;
  const TrackSegment straight = Tangent(50);
  const TrackSegment circle = Curve(2 * std::numbers::pi * 150, 1 / 150.0);
  params.segments = {straight, Transition(40, straight, circle), circle,
                     Transition(40, circle, straight), straight};
  EXPECT_THAT(Failure(params), HasSubstr("of itself"));
}

}  // namespace
}  // namespace phs::rail
