// What drives a rig and what it is compared with, from a file or from generated signals.
#pragma once

#include "base/result.h"
#include "effects/rig_model.h"
#include "identify/manifest.h"
#include "identify/rig_data.h"

namespace phs::rigs {

struct RigCase {
  effects::RigMotion motion;
  identify::RigRun run;  ///< measured channels; no sample when the motion is generated
  bool measured() const { return run.num_samples > 0; }
};

/// Measured positions are smoothed without lag, as the identification does, so that a corrected
/// model gives here what it gave there; generated ones are taken as they are.
Result<RigCase> ReadRigCase(const identify::Manifest& manifest, const effects::RigModel& model);

/// The driven cylinders stay inside their stroke: of the piston where something elastic lies
/// between it and the actuator (`piston`: predicted, [driven cylinder][sample]), else of the
/// actuator.
Status CheckStroke(const effects::RigModel& model, const effects::RigMotion& motion,
                   const std::vector<std::vector<double>>& piston);

}  // namespace phs::rigs
