// A declared model driven by the motion of a manifest: what every rig with a clock does before its
// numbers are told (rig_numbers.h).
#pragma once

#include <vector>

#include "base/result.h"
#include "measurement/manifest.h"
#include "measurement/rig_motion.h"
#include "rigs/rig_model.h"

namespace phs::measurement {

struct DrivenRig {
  rigs::RigModel model;
  RigCase input;
  rigs::RigPrediction predicted;  ///< channels as model.output_names()
  /// Clock of the motion and of the predicted channels [s].
  std::vector<double> Times() const;
};

/// The declared model of the manifest. Errors: what manifest, data or model say wrongly; a driven
/// stroke beyond the end stop; a prediction that is no number. @pre cylinder, quarter, full, element
Result<DrivenRig> DriveRig(const Manifest& manifest);
/// Another model on the same motion.
Result<DrivenRig> DriveRig(const Manifest& manifest, const hydraulics::PhsParams& params);

}  // namespace phs::measurement
