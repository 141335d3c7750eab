// Where the friction law of a bench part was evaluated, sample by sample: for formulas and maps.
#pragma once

#include "base/result.h"
#include "identify/discrepancy/formula_search.h"
#include "identify/models/element_data.h"

namespace phs::identify::element {

/// Places that the friction law of this model saw, for formulas and maps.
Result<FormulaPlaces> PlacesOf(const ElementData& data, const hydraulics::PhsParams& params);

}  // namespace phs::identify::element
