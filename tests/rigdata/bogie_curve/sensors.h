// What instruments of a measuring bogie write down of a run: means over each interval of the clock,
// noise, steps of the converter. Columns as `phs identify` reads them of a bogie.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bogie_motion.h"

namespace bogie_curve {

struct MeasuredRun {
  std::vector<std::string> names;
  std::vector<double> quantum;               // of each column, its unit
  std::vector<std::vector<double>> columns;  // [column][row]
};

struct RunWish {
  double step = 5e-4;                // of the integration [s]
  double interval = 0.02;            // of the record [s]
  double loose_until_s = 0;          // until here the lines are tight and the seals let go [m] …
  double loosens_in = 0.2;           // … with this time [s]
  double first_s = 4, last_s = 500;  // of the leading axle [m]
};

// Means of every channel, without noise.
MeasuredRun Measure(const BogieMotion& bogie, const RunWish& wish);
// Noise and steps of every column, each from a stream of its own.
void AddInstruments(uint64_t seed, MeasuredRun* run);
std::string Csv(const MeasuredRun& run);

}  // namespace bogie_curve
