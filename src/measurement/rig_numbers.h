// The numbers of a rig with a clock, as they stand in its result.json (docs/results.md, docs/rig.md).
// Nothing is fitted.
//
//   extremes.CHANNEL.least, .most    of the predicted channel over the run
//   largest.CHANNEL                  largest magnitude
//   rms.CHANNEL                      root of the mean square
//   largest.hydraulic_N, rms.…       one cylinder: of P = p_rod A_rod - p_bore A_bore, its force by
//                                    the pressures alone
//   channels.CHANNEL.…               errors against the record, where one was measured
//   hydraulic_force.…
//     .against_load_cell.…           P against the load cell: the record's, else the predicted one
//                                    (Table 6-3 of the thesis, middle block: friction over force)
//     .against_pressures.…           P against that of the measured pressures (its first block)
//   compared_with.CHANNEL.…          difference from the prediction of another manifest
//                                    (`compare_with:`), relative to that; with hydraulic_N for P
//
// Errors by the names of channel_scores.h. With generated waves the last two begin after the first
// period, as Table 6-3 does; with a record they take its validation window, else the whole of it.
#pragma once

#include <nlohmann/json.hpp>

#include "base/result.h"
#include "measurement/channel_scores.h"
#include "measurement/driven_rig.h"

namespace phs::measurement {

Result<nlohmann::ordered_json> RigNumbers(const Manifest& manifest, const DrivenRig& rig);

/// hydraulic_force.against_load_cell. @pre one cylinder with both pressures predicted
ChannelScore ScoreHydraulicForce(const Manifest& manifest, const DrivenRig& rig);

}  // namespace phs::measurement
