// The equivalent conicity of the wheels and rails of a run (rail/contact_functions.h, EN 15302:2008),
// as the results keep it: of its own profiles, worn as they are, at its own gauge.
//
// Two curves over the amplitude: rigid bodies, as the standard asks, and elastic ones under the
// static load of a wheel. Amplitudes go as far as the rigid wheelset finds both turning points within
// 10 mm of the middle.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "rail/contact_functions.h"
#include "rail/wheel_rail.h"
#include "vehicle/simulation.h"

namespace phs::analysis {

struct ConicityCurve {
  double wheel_load_N = 0;  ///< 0: rigid bodies
  std::vector<rail::Conicity> points = {};
};

struct PairConicity {
  std::string missing;         ///< why there is none: no profiles, or they do not meet
  rail::WheelRailParams pair;  ///< with the profiles and the gauge it holds for
  std::vector<ConicityCurve> curves = {};
};

/// `wheel_load_N` 0: the rigid curve alone.
PairConicity CalcConicity(const rail::WheelRail& pair, double wheel_load_N);

/// The same of a simulation, under the mean static load of its wheels.
PairConicity CalcConicity(const vehicle::Simulation& simulation);

/// `conicity` of summary.json (docs/results.md).
nlohmann::ordered_json ConicityJson(const PairConicity& conicity);

}  // namespace phs::analysis
