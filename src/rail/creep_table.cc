#include "rail/creep_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/wide.h"
#include "rail/creep_table_grid.h"

namespace phs::rail {
namespace {

using creep_table::Face;
using creep_table::FaceGrid;
using creep_table::kDataSize;
using creep_table::kFaceU;
using creep_table::kFaceV;
using creep_table::kFaceW;
using creep_table::kGrids;
using creep_table::kPerUnit;
using creep_table::kShapes;
using creep_table::kSizes;
using creep_table::kSizeUnit;
using creep_table::kStride;
using creep_table::Place;
using creep_table::PlaceOn;

constexpr double kLeastPush = 1e-9;  ///< p of the linear limit

/// Folded into the part of the cube that is stored, with the signs that undo it.
struct Folded {
  double u, v, half_w, p;
  double sign_x, sign_yw;
  Face face;
};

PHS_WITHIN_WIDE Folded Fold(const NormalisedCreepage& c) {
  Folded f;
  f.sign_x = c.u < 0 ? -1.0 : 1.0;
  f.u = std::abs(c.u);
  const double half_w = 0.5 * c.w;
  const double size_v = std::abs(c.v);
  const double size_w = std::abs(half_w);
  f.p = std::max({f.u, size_v, size_w});
  f.face = f.u >= size_v && f.u >= size_w ? kFaceU : (size_v >= size_w ? kFaceV : kFaceW);
  const bool by_v = f.face == kFaceV || half_w == 0;
  f.sign_yw = (by_v ? c.v : half_w) < 0 ? -1.0 : 1.0;
  f.v = f.sign_yw * c.v;
  f.half_w = f.sign_yw * half_w;
  return f;
}

/// Where a folded creepage lies in the table.
struct Spot {
  Place shape, extent, one, two;
  double t;
  double per_p;
};

PHS_WITHIN_WIDE Spot Find(const Folded& f, double chi) {
  const FaceGrid& grid = kGrids[f.face];
  Spot spot;
  spot.t = f.p / (f.p + kSizeUnit);
  spot.per_p = 1 / f.p;
  const bool by_u = f.face == kFaceU;
  // Components along both axes of the face; a component of both signs begins at -1.
  const double first = by_u ? f.v * spot.per_p + 1 : f.u * spot.per_p;
  const double second = (f.face == kFaceW ? f.v : f.half_w) * spot.per_p + 1;
  spot.shape = PlaceOn(std::clamp(chi, 0.0, 1.0) * (kShapes - 1), kShapes);
  spot.extent = PlaceOn(spot.t * (kSizes - 1), kSizes);
  spot.one = PlaceOn(first * kPerUnit, grid.nodes[2]);
  spot.two = PlaceOn(second * kPerUnit, grid.nodes[3]);
  return spot;
}

std::array<int, 3> NodesOf(const Spot& at) { return {at.extent.node, at.one.node, at.two.node}; }

/// g and its derivatives over t and the places on both axes of the face.
struct Sums {
  double value[kStride] = {};
  double by_t[kStride] = {}, by_one[kStride] = {}, by_two[kStride] = {};
};

/// Neighbours along the last axis lie side by side.
constexpr std::size_t kRow = 3 * kStride;
static_assert(sizeof(CreepTable::Cell::row) == 9 * kRow * sizeof(double));

/// out = sum of weight[k] in[k].
PHS_WITHIN_WIDE void Blend(const std::array<double, 3>& weight, const double (*in)[kRow],
                           double* out) {
  for (std::size_t q = 0; q < kRow; ++q) {
    out[q] = weight[0] * in[0][q] + weight[1] * in[1][q] + weight[2] * in[2][q];
  }
}

PHS_WITHIN_WIDE void BlendRow(const std::array<double, 3>& weight, const double* row, double* out) {
  for (int q = 0; q < kStride; ++q) {
    out[q] = weight[0] * row[q] + weight[1] * row[kStride + q] + weight[2] * row[2 * kStride + q];
  }
}

/// The nine rows that meet at a spot, with the shape of the patch put in.
PHS_WITHIN_WIDE void CutOut(const double* data, const Folded& f, const Spot& at,
                            double (*out)[kRow]) {
  const FaceGrid& grid = kGrids[f.face];
  const std::size_t n1 = static_cast<std::size_t>(grid.nodes[1]) + 2;
  const std::size_t n2 = static_cast<std::size_t>(grid.nodes[2]) + 2;
  const std::size_t n3 = static_cast<std::size_t>(grid.nodes[3]) + 2;
  const std::size_t plane = n1 * n2 * n3 * kStride;
  const double* corner =
      data + grid.offset +
      (((at.shape.node * n1 + at.extent.node) * n2 + at.one.node) * n3 + at.two.node) * kStride;
  const std::array<double, 3>& chi = at.shape.weight;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double* row = corner + (j * n2 + k) * n3 * kStride;
      double* cut = out[3 * k + j];
      for (std::size_t q = 0; q < kRow; ++q) {
        cut[q] = chi[0] * row[q] + chi[1] * row[plane + q] + chi[2] * row[2 * plane + q];
      }
    }
  }
}

/// Axis by axis, so that what value and slopes share is done once.
template <bool kSlope>
PHS_WITHIN_WIDE Sums Interpolate(const double (*cell)[kRow], const Spot& at) {
  const std::array<double, 3> by_t = at.extent.Slope();
  double along[3][kRow], along_t[3][kRow];  // [place on the first axis of the face]
  for (std::size_t k = 0; k < 3; ++k) {
    const double(*extent)[kRow] = cell + 3 * k;
    Blend(at.extent.weight, extent, along[k]);
    if constexpr (kSlope) Blend(by_t, extent, along_t[k]);
  }
  Sums sums;
  double last[kRow];
  Blend(at.one.weight, along, last);
  BlendRow(at.two.weight, last, sums.value);
  if constexpr (kSlope) {
    BlendRow(at.two.Slope(), last, sums.by_two);
    Blend(at.one.Slope(), along, last);
    BlendRow(at.two.weight, last, sums.by_one);
    Blend(at.one.weight, along_t, last);
    BlendRow(at.two.weight, last, sums.by_t);
  }
  return sums;
}

/// The splines may overshoot a little where the force saturates: what brings it back to f N.
PHS_WITHIN_WIDE double CutOf(const double* g, double t) {
  const double size2 = (g[0] * g[0] + g[1] * g[1]) * t * t;
  return size2 > 1 ? 1 / std::sqrt(size2) : 1;
}

PHS_WITHIN_WIDE NormalisedForce ForceOf(const Folded& f, const Spot& at, const double* g) {
  const double force = at.t * CutOf(g, at.t);
  return {g[0] * force * f.sign_x, g[1] * force * f.sign_yw, g[2] * at.t * f.sign_yw};
}

/// How t and the places on both axes of the face move with a component of the folded creepage.
struct Moves {
  double t = 0, one = 0, two = 0;
};
PHS_WITHIN_WIDE Moves MovesWithU(const Folded& f, const Spot& at) {
  const double per = kPerUnit * at.per_p;
  if (f.face != kFaceU) return {0, per, 0};
  return {kSizeUnit / ((f.p + kSizeUnit) * (f.p + kSizeUnit)), -f.v * at.per_p * per,
          -f.half_w * at.per_p * per};
}
PHS_WITHIN_WIDE Moves MovesWithV(const Folded& f, const Spot& at) {
  const double per = kPerUnit * at.per_p;
  if (f.face == kFaceU) return {0, per, 0};
  if (f.face == kFaceW) return {0, 0, per};
  return {kSizeUnit / ((f.p + kSizeUnit) * (f.p + kSizeUnit)), -f.u * at.per_p * per,
          -f.half_w * at.per_p * per};
}

/// Slope of t g, or of g/|g| where that is the force.
PHS_WITHIN_WIDE void SlopeAlong(const Sums& g, const Moves& move, double t, double cut, double* x,
                                double* y) {
  const double rise = move.t * (kSizes - 1);
  double d[2];
  for (int q = 0; q < 2; ++q) {
    d[q] = t * (rise * g.by_t[q] + move.one * g.by_one[q] + move.two * g.by_two[q]) +
           move.t * g.value[q];
  }
  if (cut < 1) {
    const double fx = g.value[0] * t * cut, fy = g.value[1] * t * cut;
    const double along = d[0] * fx + d[1] * fy;
    d[0] = cut * (d[0] - along * fx);
    d[1] = cut * (d[1] - along * fy);
  }
  *x = d[0];
  *y = d[1];
}

}  // namespace

std::size_t CreepTable::DataSize() { return kDataSize; }

CreepTable CreepTable::FromData(std::vector<double> data) {
  CreepTable table;
  if (data.size() == kDataSize) table.data_ = std::move(data);
  return table;
}

PHS_WIDE NormalisedForce CreepTable::At(const NormalisedCreepage& c) const noexcept {
  const Folded f = Fold(c);
  if (!(f.p > 0)) return {};
  const Spot at = Find(f, c.chi);
  double row[9][kRow];
  CutOut(data_.data(), f, at, row);
  return ForceOf(f, at, Interpolate<false>(row, at).value);
}

PHS_WIDE NormalisedForce CreepTable::At(const NormalisedCreepage& c,
                                        const Cell& cell) const noexcept {
  const Folded f = Fold(c);
  if (f.face != cell.face || c.chi != cell.chi || !(f.p > 0)) return At(c);
  const Spot at = Find(f, c.chi);
  if (NodesOf(at) != cell.node) return At(c);
  return ForceOf(f, at, Interpolate<false>(cell.row, at).value);
}

PHS_WIDE NormalisedForce CreepTable::At(const NormalisedCreepage& c, NormalisedSlope* slope,
                                        Cell* cell) const noexcept {
  const Folded f = Fold(c);
  if (f.p == 0) {  // no direction: that of u stands for the linear limit
    At({kLeastPush, 0, 0, c.chi}, slope, nullptr);
    return {};
  }
  *slope = {};
  if (!(f.p > 0)) return {};
  const Spot at = Find(f, c.chi);
  Cell own;
  if (cell == nullptr) cell = &own;
  cell->face = f.face;
  cell->node = NodesOf(at);
  cell->chi = c.chi;
  CutOut(data_.data(), f, at, cell->row);
  const Sums sums = Interpolate<true>(cell->row, at);
  const double cut = CutOf(sums.value, at.t);
  SlopeAlong(sums, MovesWithU(f, at), at.t, cut, &slope->x_u, &slope->y_u);
  SlopeAlong(sums, MovesWithV(f, at), at.t, cut, &slope->x_v, &slope->y_v);
  slope->x_v *= f.sign_x * f.sign_yw;
  slope->y_u *= f.sign_x * f.sign_yw;
  return ForceOf(f, at, sums.value);
}

}  // namespace phs::rail
