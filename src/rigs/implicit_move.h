// The move over one step of backward Euler at which what holds against a mass vanishes.
#pragma once

#include <cmath>

namespace phs::rigs {

/// Root of `imbalance(move)`, which rises with the move: bracketed from `start` in steps that grow
/// from imbalance / `stiffness`, then Illinois. The last call of `imbalance` is at the result.
template <typename Imbalance>
double FindMove(double start, double stiffness, const Imbalance& imbalance) {
  double a = start;
  double fa = imbalance(a);
  double reach = std::abs(fa) / stiffness;
  double b = fa > 0 ? a - reach : a + reach;
  double fb = fa == 0 ? 0 : imbalance(b);
  for (int i = 0; i < 60 && fa * fb > 0; ++i) {
    reach *= 2;
    a = b;
    fa = fb;
    b = fa > 0 ? a - reach : a + reach;
    fb = imbalance(b);
  }
  double move = std::abs(fb) < std::abs(fa) ? b : a;
  int stuck = 0;
  for (int i = 0; i < 80 && fa != 0 && fb != 0; ++i) {
    move = (a * fb - b * fa) / (fb - fa);
    const double f = imbalance(move);
    if (f == 0 || std::abs(b - a) <= 1e-14 + 1e-11 * std::abs(move) || std::abs(f) < 1e-5) break;
    if ((f > 0) == (fb > 0)) {
      b = move;
      fb = f;
      if (++stuck > 1) fa *= 0.5;
    } else {
      a = b;
      fa = fb;
      b = move;
      fb = f;
      stuck = 0;
    }
  }
  imbalance(move);
  return move;
}

}  // namespace phs::rigs
