// A PHS driven through one cylinder by measured motion (rigs `cylinder` and `quarter`), integrated
// along the samples. Channels as in rig_model.h: piston, load, p_bore, p_rod.
#pragma once

#include <memory>
#include <vector>

#include "hydraulics/phs_system.h"
#include "rigs/rig.h"

namespace phs::rigs {

/// Fills the four channels of `out`, already of the length of the motion [m, N, Pa, Pa].
/// `speed` [m/s] belongs to the samples.
/// With rigid mountings, pressures of an earlier run are taken from `pressures` or kept there; with
/// yielding ones friction acts back on them and `pressures` stays as it is.
void RunCylinder(const hydraulics::PhsSystem& system, const RigOptions& options,
                 const RigMotion& motion, const std::vector<double>& speed,
                 std::shared_ptr<const KeptRun>* pressures, RigPrediction* out);

/// The same where the pressures of the samples are given [Pa]: forces alone; rigid mountings.
void RunAtPressures(const hydraulics::PhsSystem& system, const RigMotion& motion,
                    const std::vector<double>& speed, const KeptRun& pressures, RigPrediction* out);

}  // namespace phs::rigs
