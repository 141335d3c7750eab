// The grid of starts of a form (hydraulics/effect_forms.h).
#pragma once

#include <vector>

#include "hydraulics/effect_forms.h"

namespace phs::identify::search {

/// `unit`, `nothing`: of each number, what it is measured in and where it does nothing. A share of
/// `nothing` where `of_nothing` is set, the distances of Walk::kEitherWay are else in its unit.
struct NumberScale {
  double unit = 1;
  double nothing = 0;
  bool of_nothing = false;
};

/// `count` values from one to the other: by equal factors, by equal steps where one is not positive.
std::vector<double> Between(double from, double to, int count);

/// All starts, one value per number each. `scale`: of the same length.
std::vector<std::vector<double>> GridOf(const std::vector<hydraulics::FormNumber>& numbers,
                                        const std::vector<NumberScale>& scale);

}  // namespace phs::identify::search
