// A driving motion in another unit than its name says.
#pragma once

#include <functional>
#include <vector>

#include "base/result.h"
#include "measurement/fit_data.h"

namespace phs::identify::search {

/// A motion in cm puts every output out of size (half of them by more than 5): it is taken in the
/// unit in which half of them swing within 2.5 of the declared model, if there is one, and that is
/// said. `predict`: outputs by the declared model; `predicted`: those of `data`, mended with it.
void MendInputUnit(
    const std::function<Result<std::vector<std::vector<double>>>(const measurement::FitData&)>&
        predict,
    measurement::FitData* data, std::vector<std::vector<double>>* predicted);

}  // namespace phs::identify::search
