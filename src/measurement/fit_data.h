// One measured run made ready for fitting: motion smoothed, noise known, checks passed.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/result.h"
#include "measurement/manifest.h"
#include "measurement/motion_smoother.h"
#include "measurement/rig_data.h"
#include "rigs/rig_model.h"

namespace phs::measurement {

struct MeasuredChannel {
  std::string name;            ///< "load_cell_N"
  std::vector<double> values;  ///< NaN where a sample takes no part
  double noise = 0;            ///< standard deviation of the sensor noise, unit of the channel
};

struct FitData {
  rigs::RigKind kind = rigs::RigKind::kQuarter;
  rigs::RigOptions options;             ///< steps per sample, beam of the full rig
  std::vector<std::string> candidates;  ///< effects to look for; empty = all
  std::vector<OwnCandidate> own;        ///< and the user's own
  std::vector<std::string> free;        ///< numbers of the declared model; empty = the usual
  std::string source;
  std::vector<double> time_s;           ///< uniform
  std::vector<double> row_time_s;       ///< of the file's rows; empty: as time_s
  std::vector<double> run, run_time_s;  ///< several runs joined: number from 1 and own time
  double step_s = 0;
  std::array<double, 2> estimation = {0, 0}, validation = {0, 0};  ///< [s]
  std::vector<MeasuredChannel> inputs;                             ///< as measured
  double input_unit_m = 1;           ///< of a driving motion that is not in the unit of its name
  std::vector<SmoothMotion> motion;  ///< the same smoothed
  std::vector<double> pressure_Pa;   ///< element rig, else empty
  std::vector<MeasuredChannel> outputs;  ///< those measured, in the order of the model
  bool InEstimation(size_t i) const {
    return time_s[i] >= estimation[0] && time_s[i] < estimation[1];
  }
  std::vector<DataFinding> findings;   ///< what was found wrong, and mended or left out
  std::vector<std::string> faults;     ///< and what nothing mends: the verdict says so
  std::vector<std::string> questions;  ///< and what is only asked about
};

}  // namespace phs::measurement
