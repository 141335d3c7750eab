// The true quarter rig: actuator – mount – piston – two lines, integrated with a fixed fine step.
//
//   x_a ──[mount]── x_p ──[friction]── cylinder: bore line (−A_b x), rod line (+A_r x)
//   F = p_rod A_r − p_bore A_b + friction + ripple          tension > 0
//   F_mount(x_a − x_p) = F                                    solved for v at the end of each step
//
// Backward Euler throughout: first order in the step, no parasitic oscillation with stiff friction.
#pragma once

#include <functional>
#include <vector>

#include "friction_truth.h"
#include "line_truth.h"
#include "mount_truth.h"

namespace rigdata {

enum class WarmingForm { kNone, kRamp, kSettling, kWave };

struct EnvironmentParams {
  WarmingForm form = WarmingForm::kNone;
  double warming = 0;      // K at the end (ramp), in the limit (settling), amplitude (wave)
  double tau = 60;         // s
  double gas_share = 0.5;  // share of the warming that the gas sees
};

struct RippleParams {
  double amplitude = 0;      // N
  double wavelength = 1e-3;  // m; 0 = a ripple in time
  double frequency = 0;      // Hz
  double phase = 0;          // rad
};

struct RigParams {
  LineParams bore, rod;
  LeakPath piston_leak;  // bore → rod
  FrictionParams friction;
  MountParams mount;
  EnvironmentParams environment;
  RippleParams ripple;
  double bore_area_error = 0, rod_area_error = 0;  // relative, in force only
};

// The nominal rig: the declared model with nothing hidden.
RigParams NominalRig();

// The true signals at the sampling instants.
struct RigSignals {
  std::vector<double> t, actuator, piston, speed, load, p_bore, p_rod, friction;
  size_t size() const { return t.size(); }
};

struct Integration {
  double step = 5e-5;  // s; the sampling interval is a whole number of steps
  double rate = 200;   // Hz
  double duration = 126;
};

// `speed` may be left empty: then it follows from the position over each step. With a position that
// was itself estimated from noisy samples, an estimated speed is better (rigid mount only).
struct ActuatorInput {
  std::function<double(double)> position;
  std::function<double(double)> speed;
};

RigSignals Simulate(const RigParams& params, const ActuatorInput& actuator,
                    const Integration& integration);

inline constexpr double kBoreArea = 7.853981633974483e-3;  // m², 100 mm bore
inline constexpr double kRodArea = 7.049733914655495e-3;   // m², less a 32 mm rod

}  // namespace rigdata
