// Rows of `phs validate`: Table B-1 jointly, each step left out of every fit, and what the thesis's
// other tables say of the same hydraulics without having been fitted.
#pragma once

#include "hydraulics/phs_params.h"
#include "identify/run/steps_search.h"
#include "validate/check.h"

namespace phs::validate {

/// Begins the source of a row; the place within follows.
inline constexpr char kThesis[] = "Löwe, M.Eng. thesis, Univ. of Pretoria, ";

/// Of models/rigs/steps_joint.yaml: the search, and the checks of what it found.
Result<identify::StepSearch> SearchTableB1();
Status AddTableB1Checks(Checks* checks);

/// Mean relative error [%] of the hydraulic force against the load cell of a quarter rig that is
/// driven over one period: friction as a share of the force, so it measures the force. `triangle`:
/// constant speed, else a sine. Each sample's error is capped at 100 %.
Result<double> CalcFrictionShare(const hydraulics::PhsParams& quarter, double amplitude_m,
                                 double frequency_Hz, bool triangle);

}  // namespace phs::validate
