// The groups of checks, in the order of the table. A group is a file NAME_checks.cc and its row
// here.
#pragma once

#include "validate/check.h"

namespace phs::validate {

/// Appends the checks of a group; an error if its reference data cannot be read.
using AddChecks = Status(Checks* checks);

struct CheckGroup {
  const char* name;
  const char* text;
  AddChecks* add;
};

AddChecks AddCreepChecks, AddContactChecks, AddStabilityChecks, AddSteeringChecks,
    AddHydraulicsChecks;

inline constexpr CheckGroup kCheckGroups[] = {
    {"creep", "creep forces on given patches", &AddCreepChecks},
    {"contact", "wheel on rail, Hertz, FASTSIM, Carter", &AddContactChecks},
    {"stability", "linear stability on straight track", &AddStabilityChecks},
    {"steering", "steering bogies against their claims", &AddSteeringChecks},
    {"hydraulics", "the PHS beside what the thesis measured", &AddHydraulicsChecks},
};

}  // namespace phs::validate
