// Nodes of the creep table and the B-splines through them (private to creep_table*.cc).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rail/fastsim.h"

namespace phs::rail::creep_table {

/// The component of the direction that is largest.
enum Face { kFaceU = 0, kFaceV = 1, kFaceW = 2 };
inline constexpr int kFaces = 3;

inline constexpr int kPerUnit = 10;             ///< intervals of a direction cosine per unit
inline constexpr int kHalf = kPerUnit + 1;      ///< nodes over [0, 1]
inline constexpr int kFull = 2 * kPerUnit + 1;  ///< nodes over [-1, 1]
inline constexpr int kSizes = 21;               ///< nodes in t
inline constexpr int kShapes = 11;              ///< nodes in chi
inline constexpr double kSizeUnit = 2;          ///< p at t = 1/2
inline constexpr int kValues = 3;               ///< x, y, moment
inline constexpr int kStride = 4;               ///< doubles per node (the last is 0)

/// Axes of a face: chi, t, first and second direction component.
/// u: v in [-1, 1], w/2 in [-1, 1].  v: u in [0, 1], w/2 in [-1, 1].  w: u in [0, 1], v in [-1, 1].
struct FaceGrid {
  std::array<int, 4> nodes;
  std::size_t offset;  ///< of its first coefficient in the data
};

/// Every axis carries one more coefficient at each end.
constexpr std::size_t NumCoefficients(const std::array<int, 4>& nodes) {
  std::size_t count = kStride;
  for (int n : nodes) count *= static_cast<std::size_t>(n) + 2;
  return count;
}

inline constexpr std::array<int, 4> kNodesU = {kShapes, kSizes, kFull, kFull};
inline constexpr std::array<int, 4> kNodesV = {kShapes, kSizes, kHalf, kFull};
inline constexpr std::array<int, 4> kNodesW = kNodesV;
inline constexpr std::array<FaceGrid, kFaces> kGrids = {{
    {kNodesU, 0},
    {kNodesV, NumCoefficients(kNodesU)},
    {kNodesW, NumCoefficients(kNodesU) + NumCoefficients(kNodesV)},
}};
inline constexpr std::size_t kDataSize =
    NumCoefficients(kNodesU) + NumCoefficients(kNodesV) + NumCoefficients(kNodesW);

/// Place of a point on an axis: nearest node, distance from it, and the three weights of the quadratic
/// B-spline.
struct Place {
  int node = 0;
  double beyond = 0;
  std::array<double, 3> weight{};
  /// Derivatives of the weights.
  std::array<double, 3> Slope() const { return {beyond - 0.5, -2 * beyond, beyond + 0.5}; }
};
inline Place PlaceOn(double s, int nodes) {
  Place place;
  const double half_up = s + 0.5;
  place.node = std::min(static_cast<int>(half_up), nodes - 1);
  const double d = s - place.node;
  place.beyond = d;
  place.weight = {0.5 * (0.5 - d) * (0.5 - d), 0.75 - d * d, 0.5 * (0.5 + d) * (0.5 + d)};
  return place;
}

/// Direction of a node; the largest component is 1.
inline NormalisedCreepage Direction(int face, int first, int second) {
  const double half1 = first / static_cast<double>(kPerUnit);
  const double full1 = (first - kPerUnit) / static_cast<double>(kPerUnit);
  const double full2 = (second - kPerUnit) / static_cast<double>(kPerUnit);
  switch (face) {
    case kFaceU:
      return {1, full1, 2 * full2, 0};
    case kFaceV:
      return {half1, 1, 2 * full2, 0};
    default:
      return {half1, full2, 2, 0};
  }
}

}  // namespace phs::rail::creep_table
