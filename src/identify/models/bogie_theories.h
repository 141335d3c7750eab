// What theory leaves open of a bogie's run: other theories that are as respectable.
#pragma once

#include <vector>

#include "hydraulics/phs_params.h"
#include "vehicle/scenario.h"

namespace phs::identify::search {

/// A scenario and its PHS.
struct Theory {
  vehicle::Scenario scenario;
  hydraulics::PhsParams phs;
};

/// Other theories that are as respectable as a scenario's own, one of each kind:
/// - creep: Polach's law in the place of FASTSIM or its table (the same where slip is small);
/// - seals: how they hold before they slide is assumed in every PHS model: a bristle half as stiff
///   (unless the stiffness is free) that yields from the first micrometre;
/// - contact: a wheel has the radius that elastic half-spaces give it up to 0.22 mm aside of where
///   they do (tests/rail/half_space_test.cc): 0.2 mm on each rail.
std::vector<Theory> OtherTheories(const vehicle::Scenario& own, const hydraulics::PhsParams& params,
                                  bool stiffness_free);

/// Where axles find their place: in tight curves the independent program puts them as if the seals
/// held 0.92 times as much, and as if there were 1.2 times the gas (docs/identify_bogie.md).
void AddOtherPlaces(const vehicle::Scenario& own, const hydraulics::PhsParams& params,
                    std::vector<Theory>* others);

}  // namespace phs::identify::search
