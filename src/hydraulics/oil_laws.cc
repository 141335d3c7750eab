#include "hydraulics/oil_laws.h"

#include <cmath>

#include "base/rising_root.h"

namespace phs::hydraulics {

double FlowLaw::Drop(const FlowPlace& at, double flow, double* slope) const noexcept {
  constexpr RootSearch kSearch{.near = 0, .step = 1e4, .reach = 1e9, .tolerance = 1e-6};
  double conductance = 0;
  const auto beyond = [&](double dp) { return Flow(at, dp, &conductance) - flow; };
  const double dp = RisingRoot(beyond, kSearch).value_or(std::copysign(kSearch.reach, flow));
  Flow(at, dp, &conductance);
  *slope = 1 / std::max(conductance, 1e-30);
  return dp;
}

}  // namespace phs::hydraulics
