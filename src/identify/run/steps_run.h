// Steps of a quarter rig (Table B-1) as a rig: predicted by the declared model (`phs rig`), and
// with its parameters and the effects accumulator_precharge and diaphragm_stop fitted to the
// settled pressures, every step predicted from the others (`phs identify`). docs/rig_table_b1.md.
#pragma once

#include <functional>

#include "base/result.h"
#include "base/result_dir.h"
#include "identify/result/outcome.h"
#include "measurement/manifest.h"

namespace phs::identify {

/// `phs rig`: pressures just after the step and settled, time constants; result.json,
/// predicted.csv, measured.csv.
Result<RigOutcome> RunSteps(const measurement::Manifest& manifest, const ResultDir& dir);

/// `phs identify`: the same file names as an identification over time, plus baseline.csv and
/// model.yaml. "before": oil compliance and gas volumes fitted; "after": with the accepted effects;
/// both scored on steps left out of the fit. `go_on`: asked before every fit; false stops it, with
/// an error.
Result<RigOutcome> IdentifySteps(const measurement::Manifest& manifest, const ResultDir& dir,
                                 const std::function<bool()>& go_on = {});

}  // namespace phs::identify
