#include "rail/alignment.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {
namespace {

// Sine and cosine of a small angle, |a| <= 0.06: truncation below 1e-17.
double SmallSin(double a) {
  const double a2 = a * a;
  return a + a * a2 * (-1.0 / 6 + a2 * (1.0 / 120 - a2 * (1.0 / 5040)));
}
double SmallCos(double a) {
  const double a2 = a * a;
  return 1 + a2 * (-0.5 + a2 * (1.0 / 24 + a2 * (-1.0 / 720 + a2 * (1.0 / 40320))));
}

// Gauss-Legendre, four points on (0, 1).
constexpr double kGaussPoint[4] = {
    0.0694318442029737123880267555535953, 0.3300094782075718675986671204483777,
    0.6699905217924281324013328795516223, 0.9305681557970262876119732444464048};
constexpr double kGaussWeight[4] = {
    0.1739274225687269286865319746109997, 0.3260725774312730713134680253890003,
    0.3260725774312730713134680253890003, 0.1739274225687269286865319746109997};

}  // namespace

Alignment::PlanPoint Alignment::Advance(const Knot& knot, double u) noexcept {
  const double rate = knot.curvature_rate / 2;
  double along = u;
  double across = 0;
  double turn = 0;
  double c = 1;
  double s = 0;
  if (u != 0 && (knot.curvature != 0 || rate != 0)) {
    double sum_cos = 0;
    double sum_sin = 0;
    for (int i = 0; i < 4; ++i) {
      const double v = kGaussPoint[i] * u;
      const double angle = v * (knot.curvature + v * rate);
      sum_cos += kGaussWeight[i] * SmallCos(angle);
      sum_sin += kGaussWeight[i] * SmallSin(angle);
    }
    along = u * sum_cos;
    across = u * sum_sin;
    turn = u * (knot.curvature + u * rate);
    c = SmallCos(turn);
    s = SmallSin(turn);
  }
  const double ck = knot.cos_heading;
  const double sk = knot.sin_heading;
  return {knot.x + (ck * along - sk * across), knot.y + (sk * along + ck * across), turn,
          ck * c - sk * s, sk * c + ck * s};
}

const Alignment::Knot& Alignment::KnotFor(double s) const noexcept {
  if (!(s > 0)) return knots_.front();
  if (s >= knots_.back().s) return knots_.back();
  size_t i = static_cast<size_t>(bucket_[static_cast<size_t>(s * buckets_per_metre_)]);
  while (knots_[i + 1].s <= s) ++i;
  return knots_[i];
}

TrackFrame Alignment::FrameAt(double s) const noexcept {
  const Knot& knot = KnotFor(s);
  const double u = s - knot.s;
  const PlanPoint p = Advance(knot, u);
  TrackFrame frame;
  frame.s = s;
  frame.origin = {p.x, p.y, knot.height.At(u)};
  frame.heading = knot.heading + p.turn;
  frame.curvature = knot.curvature + knot.curvature_rate * u;
  const double slope = knot.height.SlopeAt(u);
  const double flat = 1 / std::sqrt(1 + slope * slope);
  const double rise = slope * flat;
  frame.forward = {p.cos_heading * flat, p.sin_heading * flat, rise};
  const double sine = knot.cant.At(u) / cant_base_;
  const double cosine = std::sqrt(1 - sine * sine);
  frame.cant = sine == 0 ? 0.0 : std::asin(sine);
  // x_T x y_0, the vertical of the uncanted frame.
  const Vec3 up0 = {-p.cos_heading * rise, -p.sin_heading * rise, flat};
  frame.left = {-cosine * p.sin_heading - sine * up0[0], cosine * p.cos_heading - sine * up0[1],
                -sine * up0[2]};
  frame.up = {cosine * up0[0] - sine * p.sin_heading, cosine * up0[1] + sine * p.cos_heading,
              cosine * up0[2]};
  return frame;
}

Quadratic Alignment::WideningAt(double s) const noexcept {
  const Knot& knot = KnotFor(s);
  const double u = s - knot.s;
  return {knot.widening.At(u), knot.widening.SlopeAt(u), knot.widening.half_second};
}

double Alignment::TwistAt(double s) const noexcept {
  const Knot& knot = KnotFor(s);
  const double u = s - knot.s;
  const double sine = knot.cant.At(u) / cant_base_;
  return knot.cant.SlopeAt(u) / (cant_base_ * std::sqrt(1 - sine * sine));
}

double Alignment::CurvatureAt(double s) const noexcept {
  const Knot& knot = KnotFor(s);
  return knot.curvature + knot.curvature_rate * (s - knot.s);
}

double Alignment::Project(const Vec3& point) const noexcept {
  double s = knots_[static_cast<size_t>(NearestKnot(point))].s;
  // Newton on f(s) = (point - origin(s)) . (cos th, sin th, z'). Steps are bounded so that a point
  // near the centre of a curve cannot throw it away.
  for (int i = 0; i < 30; ++i) {
    const Knot& knot = KnotFor(s);
    const double u = s - knot.s;
    const PlanPoint p = Advance(knot, u);
    const double dx = point[0] - p.x;
    const double dy = point[1] - p.y;
    const double dz = point[2] - knot.height.At(u);
    const double slope = knot.height.SlopeAt(u);
    const double f = dx * p.cos_heading + dy * p.sin_heading + dz * slope;
    const double curvature = knot.curvature + knot.curvature_rate * u;
    const double across = dy * p.cos_heading - dx * p.sin_heading;
    const double derivative =
        1 + slope * slope - curvature * across - 2 * knot.height.half_second * dz;
    const double tangent = f / std::max(derivative, 0.2);
    // On a circle the way is the arc, not the tangent: atan x = x - x^3/3.
    const double turn = curvature * tangent;
    const double step = tangent * (1 - std::min(turn * turn, 1.0) / 3);
    s += step;
    // Quadratic convergence: after a step of 1e-7 m the error is below rounding.
    if (!(std::abs(step) > (derivative > 0.2 ? 1e-7 : 1e-12))) break;
  }
  return s;
}

}  // namespace phs::rail
