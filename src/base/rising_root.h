// Where a continuous function of one number that rises crosses zero.
//
// From a guess the search steps outwards, each step twice the one before, until the function has both
// signs; then Algorithm 748 of Alefeld, Potra and Shi (ACM Trans. Math. Softw. 21, 1995, 327-344), which
// cannot lose the root and needs few values.
#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <optional>

namespace phs {

struct RootSearch {
  double near = 0;       ///< where the root is looked for first
  double step = 0;       ///< the first step away from there, > 0
  double reach = 0;      ///< no further away from `near` than this
  double tolerance = 0;  ///< on the root
};

/// The place at which `f` is zero or just above; none within reach, or where f is not a number.
template <class F>
std::optional<double> RisingRoot(const F& f, const RootSearch& search) {
  double at[2] = {search.near, search.near};  // f < 0, f >= 0
  double value[2];
  value[0] = value[1] = f(search.near);
  if (value[0] != value[0]) return std::nullopt;
  if (value[0] == 0) return search.near;
  const int sought = value[0] < 0 ? 1 : 0;
  const auto found = [&] { return value[0] < 0 && value[1] >= 0; };
  for (double far = search.step; !found(); far *= 2) {
    if (!(far < 2 * search.reach)) return std::nullopt;
    const double next = search.near + (sought == 1 ? 1 : -1) * std::min(far, search.reach);
    const double there = f(next);
    if (there != there) return std::nullopt;
    const int side = there < 0 ? 0 : 1;
    at[side] = next;
    value[side] = there;
  }
  if (value[1] == 0) return at[1];
  std::uintmax_t most = 100;
  const auto close = [&](double low, double high) { return high - low <= search.tolerance; };
  return boost::math::tools::toms748_solve(f, at[0], at[1], value[0], value[1], close, most).second;
}

}  // namespace phs
