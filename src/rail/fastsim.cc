#include "rail/fastsim.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"

namespace phs::rail {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

Fastsim::Fastsim(const FastsimParams& params) : params_(params) {
  PHS_CHECK(params.strips >= 2 && params.strips <= kMaxStrips);
  PHS_CHECK(params.slices >= 2 && params.slices <= 1000);
  const int n = params.strips;
  const int m = params.slices;
  const bool uniform = params.cells == FastsimCells::kUniform;
  const double width = uniform ? params.margin : 1.0;
  double sum = 0;
  for (int j = 0; j < n; ++j) {
    // Mirrored exactly about y = 0.
    const double y = width * (2 * j + 1 - n) / static_cast<double>(n);
    y_[j] = y;
    half_[j] = std::sqrt(std::max(0.0, 1 - y * y));
    const double dx = uniform ? 2 * width / m : 2 * half_[j] / m;
    for (int i = 0; i < m; ++i) {
      const double x = (m - 1 - 2 * i) * (0.5 * dx);
      const double rest = std::max(0.0, half_[j] * half_[j] - x * x);
      sum += dx * (2.0 / n) * (params.elliptic_bound ? std::sqrt(rest) : rest);
    }
  }
  scale_ = 1 / sum;
}

NormalisedForce Fastsim::Calc(const NormalisedCreepage& creepage) const noexcept {
  return params_.cells == FastsimCells::kStrip ? CalcStrips(creepage) : CalcUniform(creepage);
}

NormalisedForce Fastsim::CalcAdhesion(const NormalisedCreepage& c) const noexcept {
  // Per strip, exact for growth linear in x: sum of tractions over the cells = integral; the
  // quadratic part of p_y carries a factor 1 - 1/(2 m^2), its first moment likewise.
  const double m2 = static_cast<double>(params_.slices) * params_.slices;
  const double dy = 2.0 / params_.strips;
  double h2 = 0;
  double h3 = 0;
  double y2h2 = 0;
  for (int j = 0; j < params_.strips; ++j) {
    const double h = half_[j];
    h2 += h * h * dy;
    h3 += h * h * h * dy;
    y2h2 += y_[j] * y_[j] * h * h * dy;
  }
  const double first = 1 - 1 / m2;  // sum of x^2 over the slice centres against the integral
  NormalisedForce f;
  f.x = -2 * c.u * h2;
  f.y = -2 * c.v * h2 - 0.5 * c.w * c.chi * (2 - 2.0 / 3 * first) * h3;
  const double x_py = 2.0 / 3 * first * c.v * h3;  // the spin part is even in x: no moment
  const double y_px = 2 * c.w * (1 - c.chi) * y2h2;
  f.moment = c.chi * x_py - (1 - c.chi) * y_px;
  return {f.x * scale_, f.y * scale_, f.moment * scale_};
}

NormalisedForce Fastsim::CalcStrips(const NormalisedCreepage& c) const noexcept {
  return params_.elliptic_bound ? MarchStrips<true>(c) : MarchStrips<false>(c);
}

template <bool kElliptic>
NormalisedForce Fastsim::MarchStrips(const NormalisedCreepage& c) const noexcept {
  const int n = params_.strips;
  const int m = params_.slices;
  const double wx = c.w * c.chi;
  const double wy = c.w * (1 - c.chi);
  // All strips side by side, so that the compiler can use vector instructions; tractions and sums
  // are for a strip of half length 1 in x.
  std::array<double, kMaxStrips> px, py, sum_x, sum_y, sum_m;
  for (int k = 0; k < n; ++k) px[k] = py[k] = sum_x[k] = sum_y[k] = sum_m[k] = 0;
  for (int i = 0; i < m; ++i) {
    const double place = (m - 1 - 2 * i) / static_cast<double>(m);  // of the centre, -1 … 1
    // Way from the last centre, or from the leading edge, and the middle of that way.
    const double way = (i == 0 ? 1.0 : 2.0) / m;
    const double middle = wx * (place + 0.5 * way);
    const double bound_factor = 1 - place * place;
    for (int k = 0; k < n; ++k) {
      const double h = half_[k];
      const double qx = px[k] - way * h * (c.u - wy * y_[k]);
      const double qy = py[k] - way * h * (c.v + middle * h);
      const double rest = h * h * bound_factor;
      const double bound2 = kElliptic ? rest : rest * rest;
      const double size2 = qx * qx + qy * qy;
      const double larger2 = size2 > bound2 ? size2 : bound2;
      const double cut = std::sqrt(bound2 / larger2);  // exactly 1 below the bound
      px[k] = qx * cut;
      py[k] = qy * cut;
      sum_x[k] += px[k];
      sum_y[k] += py[k];
      sum_m[k] += place * py[k];
    }
  }
  NormalisedForce f;
  for (int k = 0; k < n; ++k) {
    const double h = half_[k];
    f.x += h * sum_x[k];
    f.y += h * sum_y[k];
    f.moment += h * (c.chi * h * sum_m[k] - (1 - c.chi) * y_[k] * sum_x[k]);
  }
  const double cell = scale_ * (2.0 / m) * (2.0 / n);
  return {f.x * cell, f.y * cell, f.moment * cell};
}

NormalisedForce Fastsim::CalcUniform(const NormalisedCreepage& c) const noexcept {
  const int m = params_.slices;
  const double dx = 2 * params_.margin / m;
  NormalisedForce f;
  for (int j = 0; j < params_.strips; ++j) {
    const double y = y_[j];
    const double height = half_[j] * half_[j];
    double px = 0;
    double py = 0;
    for (int i = 0; i < m; ++i) {
      const double x = (m - 1 - 2 * i) * (0.5 * dx);
      const double rest = height - x * x;
      if (rest <= 0) continue;
      px -= dx * (c.u - c.w * (1 - c.chi) * y);
      py -= dx * (c.v + c.w * c.chi * (x + dx / 6));
      const double bound = params_.elliptic_bound ? std::sqrt(rest) : rest;
      const double size = std::sqrt(px * px + py * py);
      if (size > bound) {
        px *= bound / size;
        py *= bound / size;
      }
      f.x += px;
      f.y += py;
      f.moment += c.chi * x * py - (1 - c.chi) * y * px;
    }
  }
  // The published grid is not rescaled: its sum of the bound differs from N by its own error.
  const double whole = params_.elliptic_bound ? 2 * kPi / 3 : kPi / 2;
  const double cell = dx * (2 * params_.margin / params_.strips) / whole;
  return {f.x * cell, f.y * cell, f.moment * cell};
}

CreepInput WithBlendedFlexibility(const CreepInput& in, const KalkerCoefficients& c,
                                  double shear) noexcept {
  const double l1 = 8 * in.a / (3 * c.c11 * shear);
  const double l2 = 8 * in.a / (3 * c.c22 * shear);
  const double l3 = kPi * in.a * std::sqrt(in.a / in.b) / (4 * c.c23 * shear);
  const double slip2 = in.xi * in.xi + in.eta * in.eta;
  const double spin = in.phi * (kPi * in.a / 4) * (3.0 / 8);
  const double all2 = slip2 + spin * spin;
  if (!(all2 > 0)) return in;
  const double l = all2 / (in.xi * in.xi / l1 + in.eta * in.eta / l2 + spin * spin / l3);
  const double unit = in.friction * in.normal / (shear * in.a * in.b);
  const double turn2 = unit * unit * (1 / (c.c11 * c.c11) + 1 / (c.c22 * c.c22));
  const double t = std::min(1.0, std::sqrt(slip2 / turn2) / 3);
  CreepInput out = in;
  out.xi *= l1 / ((1 - t) * l1 + t * l);
  out.eta *= l2 / ((1 - t) * l2 + t * l);
  out.phi *= l3 / ((1 - t) * l3 + t * l);
  return out;
}

CreepInput WithSlopeReduction(const CreepInput& in, const KalkerCoefficients& c, double shear,
                              const SlopeReduction& reduction) noexcept {
  const double turned = in.eta + in.phi * in.a;
  const double lateral = std::abs(turned) > std::abs(in.eta) ? turned : in.eta;
  const double w = std::sqrt(in.xi * in.xi + lateral * lateral);
  const double e =
      shear * kPi * in.a * in.b * reduction.k0 * c.c11 * w / (4 * in.friction * in.normal);
  const double k =
      reduction.k0 * (reduction.alpha + (1 - reduction.alpha) / (1 + reduction.beta * e));
  CreepInput out = in;
  out.xi *= k;
  out.eta *= k;
  out.phi *= k;
  return out;
}

}  // namespace phs::rail
