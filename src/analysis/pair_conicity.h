// The equivalent conicity of the wheels and rails of a run (rail/contact_functions.h, EN 15302:2008),
// as the results keep it: of its own profiles, worn as they are, at its own gauge.
//
// Two curves over the amplitude: rigid bodies, as the standard asks, and elastic ones under the
// static load of a wheel. Amplitudes go as far as the rigid wheelset finds both turning points within
// 10 mm of the middle.
#pragma once

#include <nlohmann/json.hpp>

#include "rail/wheel_rail.h"
#include "vehicle/simulation.h"

namespace phs::analysis {

/// `conicity` of summary.json (docs/results.md). Without profiles, or where they do not meet, only
/// `missing`: the reason. `wheel_load_N` 0: the rigid curve alone.
nlohmann::ordered_json DescribeConicity(const rail::WheelRail& pair, double wheel_load_N);

/// The same of a simulation, under the mean static load of its wheels.
nlohmann::ordered_json DescribeConicity(const vehicle::Simulation& simulation);

}  // namespace phs::analysis
