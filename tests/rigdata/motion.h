// The motion of the rig's actuator as a smooth function of time, x_a(t): 0 = static position,
// x > 0 = extension of the cylinder, m. Twice differentiable, so that the solution of the rig
// converges with the step.
//
// The record is a row of blocks, each of one kind of motion; between blocks and at both ends the
// actuator moves by fifth-order ramps and rests. Estimation and validation parts both hold every
// kind, in another order and with other numbers.
#pragma once

#include <numbers>
#include <vector>

#include "random_source.h"

namespace rigdata {

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

// Where the actuator may go and how long it does so.
struct MotionRange {
  double low = -2.5e-3;   // m, deepest compression
  double high = 3.8e-3;   // m, deepest extension
  double deep = 3.8e-3;   // m, one slow excursion of each part goes there; >= high
  double duration = 126;  // s
  double estimation_share = 0.63;
};

struct SineTerm {
  double amplitude = 0;  // m
  double frequency = 0;  // Hz
  double phase = 0;      // rad
};

// Level of a ramp-and-hold sequence: reached at `time` after a ramp of `ramp` seconds.
struct RampPoint {
  double time = 0;
  double ramp = 0.1;
  double level = 0;
};

// One oscillating block on top of the ramps: sum of sines (or a rounded triangle) under a window.
struct OscillationBlock {
  double start = 0, end = 0;
  double taper = 0.5;    // s, fifth-order fade in and out
  double roundness = 0;  // 0: sines; else rounded triangle, 0 < roundness < 1, 1 = sharp corners
  std::vector<SineTerm> terms;
};

class Motion {
 public:
  Motion() = default;
  Motion(std::vector<RampPoint> ramps, std::vector<OscillationBlock> blocks);

  double Position(double t) const;  // m
  const std::vector<OscillationBlock>& blocks() const { return blocks_; }

 private:
  std::vector<RampPoint> ramps_;  // by time
  std::vector<OscillationBlock> blocks_;
};

// Draws the motion of one record. `split` is the time that parts estimation from validation.
struct DrawnMotion {
  Motion motion;
  double split = 0;
  double duration = 0;
};
DrawnMotion DrawMotion(const MotionRange& range, RandomSource random);

// A motion given by samples from t = 0 on, linear between them, at rest after the last.
struct SampledMotion {
  double step = 0;               // s
  std::vector<double> position;  // m; empty: none
  // Catmull and Rom's cubic: its speed has no jumps. Straight between samples, a reversal would
  // come at a sample, and friction turn there.
  double Position(double t) const;
  double Duration() const { return step * static_cast<double>(position.size()); }
};

// 10 u³ − 15 u⁴ + 6 u⁵ between 0 and 1, constant outside.
double SmoothStep(double u);

}  // namespace rigdata
