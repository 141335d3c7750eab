// Where the friction law of a bench part was evaluated, sample by sample: for formulas and maps.
#pragma once

#include "base/result.h"
#include "identify/element_data.h"
#include "identify/formula_search.h"

namespace phs::identify::element {

/// Places that the friction law of this model saw, for formulas and maps.
Result<FormulaPlaces> PlacesOf(const ElementData& data, const hydraulics::PhsParams& params);

}  // namespace phs::identify::element
