// Spatial vectors in lanes: rotation and translation, or moment and force, each as three numbers
// and one that nobody reads, so that a processor with wide vectors takes a half at once.
#pragma once

#include "base/wide.h"

namespace phs::plugin {

using Lanes = double __attribute__((vector_size(32)));
/// The same at any address, in place of four numbers.
using LanesInMemory [[gnu::aligned(8), gnu::may_alias]] = Lanes;

inline constexpr int kPadded = 8;  ///< numbers of a spatial vector in lanes

struct Spatial {
  Lanes first{};   ///< rotation, or moment
  Lanes second{};  ///< translation, or force
};

/// Four numbers as they lie. (Lanes put together one by one would wait for their own stores.)
PHS_WITHIN_WIDE void LoadFour(const double* from, Lanes* out) {
  *out = *reinterpret_cast<const LanesInMemory*>(from);
}

/// From six numbers.
PHS_WITHIN_WIDE void LoadSix(const double* from, Spatial* out) {
  LoadFour(from, &out->first);
  LoadFour(from + 2, &out->second);
  out->second = __builtin_shufflevector(out->second, out->second, 1, 2, 3, 3);
}

/// From kPadded numbers, and back.
PHS_WITHIN_WIDE void LoadPadded(const double* from, Spatial* out) {
  LoadFour(from, &out->first);
  LoadFour(from + 4, &out->second);
}
PHS_WITHIN_WIDE void StorePadded(const Spatial& s, double* to) {
  *reinterpret_cast<LanesInMemory*>(to) = s.first;
  *reinterpret_cast<LanesInMemory*>(to + 4) = s.second;
}

/// out += a x b.
PHS_WITHIN_WIDE void AddCross(const Lanes& a, const Lanes& b, Lanes* out) {
  *out += __builtin_shufflevector(a, a, 1, 2, 0, 3) * __builtin_shufflevector(b, b, 2, 0, 1, 3) -
          __builtin_shufflevector(a, a, 2, 0, 1, 3) * __builtin_shufflevector(b, b, 1, 2, 0, 3);
}

/// out += scale s.
PHS_WITHIN_WIDE void AddScaledSpatial(double scale, const Spatial& s, Spatial* out) {
  out->first += scale * s.first;
  out->second += scale * s.second;
}

PHS_WITHIN_WIDE double DotSpatial(const Spatial& a, const Spatial& b) {
  const Lanes product = a.first * b.first + a.second * b.second;
  return product[0] + product[1] + product[2];
}

}  // namespace phs::plugin
