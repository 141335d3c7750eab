#include "rail/creep_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rail/creep_table_grid.h"

namespace phs::rail {
namespace {

using namespace creep_table;

/// Folded into the part of the cube that is stored, with the signs that undo it.
struct Folded {
  double u, v, half_w, p;
  double sign_x, sign_yw;
  Face face;
};

Folded Fold(const NormalisedCreepage& c) {
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

}  // namespace

std::size_t CreepTable::DataSize() { return kDataSize; }

CreepTable CreepTable::FromData(std::vector<double> data) {
  CreepTable table;
  if (data.size() == kDataSize) table.data_ = std::move(data);
  return table;
}

NormalisedForce CreepTable::At(const NormalisedCreepage& c) const noexcept {
  const Folded f = Fold(c);
  if (!(f.p > 0)) return {};
  const FaceGrid& grid = kGrids[f.face];
  const double t = f.p / (f.p + kSizeUnit);
  const double per_p = 1 / f.p;
  double first = 0;  // place of the first direction component on its axis
  double second = 0;
  switch (f.face) {
    case kFaceU:
      first = (f.v * per_p + 1) * kPerUnit;
      second = (f.half_w * per_p + 1) * kPerUnit;
      break;
    case kFaceV:
      first = f.u * per_p * kPerUnit;
      second = (f.half_w * per_p + 1) * kPerUnit;
      break;
    case kFaceW:
      first = f.u * per_p * kPerUnit;
      second = (f.v * per_p + 1) * kPerUnit;
      break;
  }
  const Place shape = PlaceOn(std::clamp(c.chi, 0.0, 1.0) * (kShapes - 1), kShapes);
  const Place extent = PlaceOn(t * (kSizes - 1), kSizes);
  const Place one = PlaceOn(first, grid.nodes[2]);
  const Place two = PlaceOn(second, grid.nodes[3]);
  const std::size_t n1 = static_cast<std::size_t>(grid.nodes[1]) + 2;
  const std::size_t n2 = static_cast<std::size_t>(grid.nodes[2]) + 2;
  const std::size_t n3 = static_cast<std::size_t>(grid.nodes[3]) + 2;
  double sum[kStride] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double wij = shape.weight[i] * extent.weight[j];
      for (int k = 0; k < 3; ++k) {
        const double wijk = wij * one.weight[k];
        const double* row =
            data_.data() + grid.offset +
            ((((shape.node + i) * n1 + extent.node + j) * n2 + one.node + k) * n3 + two.node) *
                kStride;
        // Row by row, so that the sums do not wait for one another.
        for (int q = 0; q < kStride; ++q) {
          sum[q] += wijk * (two.weight[0] * row[q] + two.weight[1] * row[kStride + q] +
                            two.weight[2] * row[2 * kStride + q]);
        }
      }
    }
  }
  // The splines may overshoot a little where the force saturates.
  const double size2 = (sum[0] * sum[0] + sum[1] * sum[1]) * t * t;
  const double force = size2 > 1 ? t / std::sqrt(size2) : t;
  return {sum[0] * force * f.sign_x, sum[1] * force * f.sign_yw, sum[2] * t * f.sign_yw};
}

}  // namespace phs::rail
