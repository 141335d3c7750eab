// What drives a rig and what it is compared with, from a file or from generated signals.
#pragma once

#include "base/result.h"
#include "measurement/manifest.h"
#include "measurement/rig_data.h"
#include "rigs/rig_model.h"

namespace phs::measurement {

struct RigCase {
  rigs::RigMotion motion;
  measurement::RigRun run;  ///< measured channels; no sample when the motion is generated
  bool measured() const { return run.num_samples > 0; }
  /// Some output was measured; else the model is shown alone.
  bool compared() const;
};

/// Measured positions are smoothed without lag, as the identification does, so that a corrected
/// model gives here what it gave there; forces, pressures and generated motion are taken as they
/// are.
Result<RigCase> ReadRigCase(const measurement::Manifest& manifest, const rigs::RigModel& model);

/// The driven cylinders stay inside their stroke: of the piston where something elastic lies
/// between it and the actuator (`piston`: predicted, [driven cylinder][sample]), else of the
/// actuator.
Status CheckStroke(const rigs::RigModel& model, const rigs::RigMotion& motion,
                   const std::vector<std::vector<double>>& piston);

}  // namespace phs::measurement
