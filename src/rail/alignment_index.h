// Square cells that cover the plan: the hash of the spatial index of an alignment.
#pragma once

#include <cmath>
#include <cstdint>

namespace phs::rail {

inline constexpr double kCellSize = 8;  ///< [m]
inline constexpr int kCellReach = 2;    ///< cells on each side of a knot: at least 16 m are covered

/// Index of the cell of a coordinate; false when it is not finite or absurdly far.
inline bool CellIndex(double coordinate, std::int32_t* index) {
  if (!(std::abs(coordinate) < 1e9)) return false;
  *index = static_cast<std::int32_t>(std::floor(coordinate / kCellSize));
  return true;
}

inline std::uint32_t CellHash(std::int32_t ix, std::int32_t iy) {
  std::uint32_t h =
      static_cast<std::uint32_t>(ix) * 0x9E3779B1u ^ static_cast<std::uint32_t>(iy) * 0x85EBCA77u;
  return h ^ (h >> 15);
}

}  // namespace phs::rail
