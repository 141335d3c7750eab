// Faults of a bench record that show only against the motion or the declared model.
#pragma once

#include "identify/element_data.h"
#include "measurement/manifest.h"

namespace phs::identify::element {

/// What contradicts itself and cannot be mended, one sentence each:
/// - a turned sign: over the record the part gives out work, sum (F - mean F) v dt < -0.1 sum |F v|
///   dt. No passive part does (a spring gives back what it took), whatever its law.
/// - swapped columns: the force follows the declared model only if the two columns change places
///   (correlation above 0.7 instead of below 0.5).
/// - another unit: the force follows the declared model but swings a hundred times more or less.
std::vector<std::string> FindFaults(const measurement::Manifest& manifest, const ElementData& data,
                                    const hydraulics::PhsParams& declared);

}  // namespace phs::identify::element
