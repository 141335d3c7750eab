// Measured runs on a uniform clock in SI units, with what is known about their quality.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/table.h"
#include "hydraulics/extra_series.h"
#include "measurement/manifest.h"

namespace phs::measurement {

/// Noise of one channel, from the data itself.
struct ChannelNoise {
  double white = 0;    ///< standard deviation of what changes from sample to sample
  double level = 0;    ///< whole standard deviation where nothing moves (white if never at rest)
  double quantum = 0;  ///< smallest step of the numbers; 0 = not quantised
  double correlation_samples = 1;  ///< integrated correlation time of the noise at rest [samples]
};

struct Channel {
  std::string name;       ///< "load_cell_N"
  std::string column;     ///< its column in the file; empty = not measured
  double factor = 1;      ///< SI value = factor * number in the file
  std::vector<double> y;  ///< on the uniform clock; bad samples bridged linearly
  std::vector<char> bad;  ///< 1: missing, spike or saturated: takes no part in any fit
  ChannelNoise noise;
  bool present() const { return !y.empty(); }
};

/// Something the data say about themselves, in words.
struct DataFinding {
  std::string channel;
  std::string text;
};

struct RigRun {
  std::string source;
  double t0_s = 0, step_s = 0;
  int num_samples = 0;
  std::vector<double> file_time;         ///< clock of the file's rows, each time once [s]
  std::vector<double> row_time;          ///< the same for every row that has a time [s]
  std::vector<Channel> inputs;           ///< driven motion, as RigModel::input_names()
  std::vector<Channel> outputs;          ///< as RigModel::output_names(); may be absent
  Channel speed, pressure, temperature;  ///< element rig: optional side channels
  /// Further channels of the manifest; null: none.
  std::shared_ptr<const hydraulics::ExtraSeries> extra;
  Window estimation, validation;  ///< clipped to the data
  std::vector<DataFinding> findings;
  double Time(int i) const { return t0_s + i * step_s; }
  /// Samples of a window: [first, last).
  int First(const Window& window) const;
  int Last(const Window& window) const;
};

enum class OutputNeed {
  kSome,  ///< something to compare with
  kNone,  ///< a run without windows may hold inputs alone: the model is predicted only
};
/// Reads one run. `inputs`, `outputs`: channel names of the rig. Missing inputs, a clock that does
/// not advance and empty windows are errors; everything else becomes a finding.
Result<RigRun> ReadRigRun(const RunSpec& spec, const Manifest& manifest,
                          const std::vector<std::string>& inputs,
                          const std::vector<std::string>& outputs,
                          OutputNeed need = OutputNeed::kSome);

}  // namespace phs::measurement
