// A measured run is read, checked and made ready for fitting.
#pragma once

#include <vector>

#include "base/result.h"
#include "hydraulics/phs_params.h"
#include "measurement/fit_data.h"
#include "measurement/manifest.h"

namespace phs::measurement {

/// What a record says of itself: source, clock, windows, findings; no channel yet.
FitData StartData(const RigRun& run);

/// Both windows hold enough samples to tell an effect from noise. `several`: one of several runs
/// may have one window only.
Status CheckWindows(const RigRun& run, bool several = false);
/// Takes one channel into `data` as an output to be explained, its stuck stretches, spikes and the
/// samples of `input_lost` left out; or leaves a finding why not.
void TakeOutput(Channel* channel, const RigRun& run, const std::vector<char>& input_lost,
                FitData* data);

/// Reads and checks the (first) run of a manifest, or one of `several`, against its declared model.
/// Errors say what cannot be identified and why: fewer than 200 samples in a window, an input that
/// stands still or never reverses, no output.
Result<FitData> ReadFitData(const Manifest& manifest, const hydraulics::PhsParams& params,
                            bool several = false);

}  // namespace phs::measurement
