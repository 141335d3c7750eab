#include <algorithm>
#include <atomic>
#include <cmath>
#include <system_error>
#include <thread>
#include <vector>

#include "base/tridiagonal.h"
#include "rail/creep_table.h"
#include "rail/creep_table_grid.h"

namespace phs::rail {
namespace {

using creep_table::Direction;
using creep_table::kDataSize;
using creep_table::kFaces;
using creep_table::kFaceU;
using creep_table::kGrids;
using creep_table::kShapes;
using creep_table::kSizes;
using creep_table::kSizeUnit;
using creep_table::kStride;
using creep_table::kValues;

/// Solves for B-spline coefficients c[0 … n+1] (one beyond each end) through f[0 … n-1].
/// Mirror: sign s of f(-x) = s f(x) at the first node; 0 = third difference vanishes there.
void Prefilter(double* c, std::size_t step, int n, double mirror) {
  // c[1 … n] hold f on entry. Tridiagonal (1/8, 3/4, 1/8); free ends: c0 - c1 = f0 - f1.
  const auto at = [&](int i) -> double& { return c[static_cast<std::size_t>(i + 1) * step]; };
  constexpr int kMaxNodes = 128;
  TridiagonalRow rows[kMaxNodes];
  double solved[kMaxNodes];
  const auto count = static_cast<std::size_t>(n);
  for (int i = 1; i < n - 1; ++i) rows[i] = {0.125, 0.75, 0.125, at(i)};
  rows[0] = mirror == 0 ? TridiagonalRow{0, 1, -1, at(0) - at(1)}
                        : TridiagonalRow{0, 0.75, 0.125 * (1 + mirror), at(0)};
  rows[n - 1] = {-1, 1, 0, at(n - 1) - at(n - 2)};
  SolveTridiagonal({rows, count}, {solved, count});
  for (int i = 0; i < n; ++i) at(i) = solved[i];
  at(-1) = mirror == 0 ? 3 * at(0) - 3 * at(1) + at(2) : mirror * at(1);
  at(n) = 3 * at(n - 1) - 3 * at(n - 2) + at(n - 3);
}

/// Node values of one face and shape: force/t, and the linear limit at t = 0.
void FillShape(const Fastsim& fastsim, int face, int shape, double* data) {
  const std::array<int, 4>& nodes = kGrids[face].nodes;
  const std::size_t n1 = nodes[1] + 2, n2 = nodes[2] + 2, n3 = nodes[3] + 2;
  for (int size = 0; size < nodes[1]; ++size) {
    const double t = size / static_cast<double>(kSizes - 1);
    // Full slip is reached in the limit; a million times the unit is beyond any difference.
    const double p = size == kSizes - 1 ? 1e6 : kSizeUnit * t / (1 - t);
    for (int first = 0; first < nodes[2]; ++first) {
      for (int second = 0; second < nodes[3]; ++second) {
        NormalisedCreepage c = Direction(face, first, second);
        c.chi = shape / static_cast<double>(kShapes - 1);
        NormalisedForce f;
        double per = 0;
        if (size == 0) {
          f = fastsim.CalcAdhesion(c);
          per = kSizeUnit;
        } else {
          f = fastsim.Calc({p * c.u, p * c.v, p * c.w, c.chi});
          per = 1 / t;
        }
        double* node =
            data + ((((shape + 1) * n1 + size + 1) * n2 + first + 1) * n3 + second + 1) * kStride;
        node[0] = f.x * per;
        node[1] = f.y * per;
        node[2] = f.moment * per;
      }
    }
  }
}

/// Turns node values into coefficients along every axis.
void PrefilterFace(int face, double* data) {
  const std::array<int, 4>& nodes = kGrids[face].nodes;
  std::array<std::size_t, 5> step;
  step[4] = kStride;
  for (int axis = 3; axis >= 0; --axis) step[axis] = step[axis + 1] * (nodes[axis] + 2);
  // Of an axis `axis`, neighbours lie step[axis + 1] apart.
  for (int axis = 0; axis < 4; ++axis) {
    const std::size_t apart = step[axis + 1];
    const std::size_t length = step[axis];
    for (std::size_t start = 0; start < step[0]; start += length) {
      for (std::size_t in = 0; in < apart; ++in) {
        const std::size_t value = in % kStride;
        if (value >= kValues) continue;
        const bool at_u = axis == 2 && face != kFaceU;
        const double mirror = at_u ? (value == 0 ? -1.0 : 1.0) : 0.0;
        Prefilter(data + start + in, apart, nodes[axis], mirror);
      }
    }
  }
}

}  // namespace

CreepTable CreepTable::Build(const FastsimParams& params, int threads) {
  const Fastsim fastsim(params);
  CreepTable table;
  table.data_.assign(kDataSize, 0.0);
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int job = next++; job < kFaces * kShapes; job = next++) {
      const int face = job / kShapes;
      FillShape(fastsim, face, job % kShapes, table.data_.data() + kGrids[face].offset);
    }
  };
  std::vector<std::thread> helpers;
  try {
    for (int i = 1; i < threads; ++i) helpers.emplace_back(work);
  } catch (const std::system_error&) {  // the system gives no more threads: those there do it all
  }
  work();
  for (std::thread& helper : helpers) helper.join();
  for (int face = 0; face < kFaces; ++face) {
    PrefilterFace(face, table.data_.data() + kGrids[face].offset);
  }
  return table;
}

}  // namespace phs::rail
