// Motions that a rig could make in a test, within its limits.
//
// A family, not an optimum: sines over frequency and amplitude, triangles over speed (the slowest a
// single slow way over the full stroke), steps with holds, multisines, and two of them one after the
// other. Each begins and ends at rest at 0 for a twentieth of the test, so that the noise of the
// sensors shows, and goes to the middle of the stroke, where the wave fades in and out over a second.
// What would be faster than the rig is made smaller.
#pragma once

#include <string>
#include <vector>

#include "rigs/rig.h"
#include "rigs/rig_signal.h"

namespace phs::identify::search {

/// What the rig can do.
struct MotionLimits {
  double low_m = 0, high_m = 0;  ///< of the driven position
  double speed_m_s = 0;          ///< > 0
  double duration_s = 60;        ///< > 0
};

struct TestMotion {
  std::string text;                        ///< for people
  std::vector<rigs::SignalParams> signal;  ///< one after the other, equally long
  bool opposed = false;  ///< of two driven cylinders the second goes against the first
};

/// The family; `fastest_Hz`: no sine above it.
std::vector<TestMotion> ListTestMotions(const MotionLimits& limits, double fastest_Hz);

/// Both, each in half of the time.
TestMotion Joined(const TestMotion& first, const TestMotion& second);

/// Position, speed and acceleration of `channels` driven cylinders (1 or 2) on a clock of `step_s`.
rigs::RigMotion Sampled(const TestMotion& motion, const MotionLimits& limits, double step_s,
                        int channels);

}  // namespace phs::identify::search
