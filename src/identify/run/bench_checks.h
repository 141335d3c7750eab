// Faults of a bench record that show only against the motion or the declared model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/models/element_data.h"
#include "identify/select/verdict.h"
#include "measurement/manifest.h"

namespace phs::identify::element {

/// What contradicts itself and cannot be mended, one sentence each:
/// - a turned sign: over the record the part gives out work, sum (F - mean F) v dt < -0.1 sum |F v|
///   dt. No passive part does (a spring gives back what it took), whatever its law.
/// - swapped columns: the force follows the declared model only if the two columns change places
///   (correlation above 0.7 instead of below 0.5).
/// - another unit: the force follows the declared model but swings 32 times more or less.
std::vector<std::string> FindFaults(const measurement::Manifest& manifest, const ElementData& data,
                                    const hydraulics::PhsParams& declared);

/// A unit that the numbers have swallowed: a force read a times and a position read b times too
/// large turn a number in N^p m^q into a^p b^q of it. Said where the numbers, three more than
/// channels that are off, are all driven so by the a and b of a known unit (measurement/units.h):
/// rms to a factor of 1.5, a fifth of how far they were driven, in logarithms, and by a factor of 3
/// at least.
std::optional<std::string> FindSwallowedUnit(const std::vector<FittedNumber>& numbers);

}  // namespace phs::identify::element
