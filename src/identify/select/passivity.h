// What must dissipate may not drive.
//
// The laws of the catalogue are passive by their form, and by the bounds of their amounts; what a
// formula has found in data need not be. Of a force f on the piston that part is friction which
// depends on its motion, f(v, s) - f(0, 0), s the direction of friction. Beside the level R of the
// model's own friction it takes in
//   W = integral of [R + (f(v, s) - f(0, 0)) sgn v] |v| dt
// over the record, in extension and in retraction; of a flow out of a line or past the piston,
//   W = integral of [q(p) - q(0)] p dt
// p its pressure difference; what flows at p = 0 is driven by time, by a supply of its own. Where
// one of these is negative the formula drives: no part of a rig without a supply does that, so that
// something else is there.
#pragma once

#include <string>
#include <vector>

#include "identify/select/identification.h"

namespace phs::identify::search {

/// A sentence for each way in which a formula of the corrected model drives; empty: none does.
std::vector<std::string> WhatDrives(const FitProblem& problem, const Identification& found);

}  // namespace phs::identify::search
