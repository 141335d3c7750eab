// A measured run of a bogie in a curve made ready for fitting: place along the track, outputs with
// their noise, checks passed (docs/identify_bogie.md).
#pragma once

#include "identify/models/bogie_model.h"
#include "measurement/fit_data.h"

namespace phs::identify::search {

/// Reads the (first) run of a manifest, or one of `several`, which may have one window only. Where
/// the vehicle is comes from `s_m` (arc length of the leading wheelset) or, without it, from
/// `speed_m_s` integrated from the scenario's start; sets the model's speed to the measured mean.
/// Outputs: every column that is a channel of a run or of a rig. Errors say what cannot be
/// identified and why: neither place nor speed, standing still, straight track, too few samples, no
/// output. Without windows in the manifest the whole record counts as `validation` (to compare
/// only).
Result<measurement::FitData> ReadBogieData(const measurement::Manifest& manifest, BogieModel* model,
                                           bool several = false);

}  // namespace phs::identify::search
