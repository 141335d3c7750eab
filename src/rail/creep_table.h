// Table of FASTSIM over its four normalised numbers (fastsim.h), so that a creep force costs a
// look-up. It does not depend on material, load or friction: these only scale its arguments.
//
// Arguments. Size p = max(|u|, |v|, |w|/2), compactified as t = p/(p + 2) in [0, 1] (t = 1: full
// slip); direction (u, v, w/2)/p on the surface of a cube; chi = a/(a + b) in [0, 1]. Two mirror
// symmetries fold the cube to u >= 0 and one of its halves in (v, w), so the symmetries hold to the
// last bit. Three faces remain, named after the component that is largest: u, v, w.
//
// Values. g = force/t (a smooth function with a finite limit at t = 0, which is the exact linear
// law of the grid), interpolated by quadratic B-splines through the nodes in all four arguments:
// once continuously differentiable within a face, continuous across the edges of the cube.
//
// The slope is that of the splines, d(t g) = g dt + t dg with dt/dp = 2/(p + 2)^2, where the force is
// cut back without the part along the force.
//
// After interpolation the force is cut back to f N. Error against FASTSIM on the same grid, p from
// 0.02 to 40 in all directions, as a share of f N: a/b from 0.43 to 2.3 rms 0.03 %, largest 0.7 %;
// a/b from 0.11 to 9 rms 0.05 %, largest 1.1 % (tests/rail/creep_table_test.cc).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "rail/fastsim.h"

namespace phs::rail {

class CreepTable {
 public:
  /// Evaluates FASTSIM at all nodes on up to `threads` threads; the result does not depend on it.
  static CreepTable Build(const FastsimParams& params, int threads);
  /// From the numbers of `data()`; empty when their count is wrong.
  static CreepTable FromData(std::vector<double> data);
  static std::size_t DataSize();

  /// A part of the table with the shape of the patch put in: what creepages near by need.
  struct Cell {
    int face = -1;  ///< none
    std::array<int, 3> node;
    double chi;
    double row[9][12];
  };

  /// @pre not empty.
  NormalisedForce At(const NormalisedCreepage& creepage) const noexcept;
  /// The same with the slope of the interpolated force, in closed form.
  /// `cell`: filled with the part of the table that was used; may be null.
  NormalisedForce At(const NormalisedCreepage& creepage, NormalisedSlope* slope,
                     Cell* cell) const noexcept;
  /// As At(creepage), to the last bit; quicker where it falls into the cell.
  NormalisedForce At(const NormalisedCreepage& creepage, const Cell& cell) const noexcept;
  std::span<const double> data() const { return data_; }
  bool empty() const { return data_.empty(); }

 private:
  std::vector<double> data_;
};

}  // namespace phs::rail
