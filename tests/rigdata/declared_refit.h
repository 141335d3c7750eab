// The declared model with its free parameters, for judging how large a hidden effect is: static
// lines with one compliance and one gas volume each, one friction scale, rigid mount. Fitted by
// Levenberg and Marquardt to a record's estimation window.
#pragma once

#include <array>
#include <vector>

#include "motion_estimate.h"
#include "rig_truth.h"
#include "sensor_truth.h"

namespace rigdata {

// Factors on the declared values: oil compliance and gas volume of the bore and the rod line,
// friction.
struct DeclaredFactors {
  double oil_bore = 1, gas_bore = 1, oil_rod = 1, gas_rod = 1, friction = 1;
};

RigParams DeclaredRig(const DeclaredFactors& factors);

// Piston, load, p_bore and p_rod that the declared model gives for a motion, at sample i only.
std::array<double, kChannels> DeclaredPrediction(const DeclaredFactors& factors, double x,
                                                 double v);

struct Window {
  double begin = 0, end = 0;  // s
};

// Fits to `record` on `window`, every channel weighted by 1/level.
DeclaredFactors FitDeclared(const Record& record, const MotionEstimate& motion,
                            const Window& window, const std::array<double, kChannels>& level);

// RMSE per channel of the declared model on a window.
std::array<double, kChannels> DeclaredError(const DeclaredFactors& factors, const Record& record,
                                            const MotionEstimate& motion, const Window& window);

}  // namespace rigdata
