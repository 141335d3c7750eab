// The move over one step of backward Euler at which what holds against a mass vanishes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::rigs {

/// What a step hands on to the next, and how well a balance is met.
struct MoveGuess {
  double slope = 0;      ///< imbalance over move where it last was zero; at least `least` is taken
  double enough = 1e-5;  ///< of the imbalance
};

/// Root of `imbalance(move)` [N or N m], which rises with the move by `least` or more (the mass over
/// the square of the step; all else is passive): from `start` by the guessed slope, then by secants,
/// halved where these leave the bracket or close in slowly. To `enough` of the imbalance or 1e-11 of
/// the move. The last call of `imbalance` is at the result.
template <typename Imbalance>
double FindMove(double start, double least, MoveGuess* guess, const Imbalance& imbalance) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double x = start, f = imbalance(x);
  double low = -kNone, high = kNone;  // of the root
  double slope = std::max(least, guess->slope);
  int slow = 0;  // steps that did not halve the bracket
  for (int i = 0; i < 200 && std::abs(f) >= guess->enough; ++i) {
    const double width = high - low, enough = 1e-14 + 1e-11 * std::abs(x);
    (f > 0 ? high : low) = x;
    if (high - low <= enough) break;
    slow = high - low > 0.5 * width ? slow + 1 : 0;
    double step = -f / slope;
    if (std::abs(step) < enough) step = std::copysign(enough, step);
    if (high - low < kNone && (slow > 2 || !(x + step > low && x + step < high))) {
      step = 0.5 * (low + high) - x;
      slow = 0;
    }
    const double held = f;
    x += step, f = imbalance(x);
    slope = std::max(least, (f - held) / step);
  }
  guess->slope = slope;
  return x;
}

}  // namespace phs::rigs
