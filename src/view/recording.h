// What is replayed: the channels of one run (docs/results.md), read from a result directory or just
// simulated. Nothing in here runs a model.
#pragma once

#include <string>
#include <vector>

#include "base/hdf5_series.h"
#include "vehicle/scenario.h"
#include "vehicle/simulation.h"

namespace phs::view {

/// A moment between two rows.
struct Moment {
  double time = 0;   ///< [s]
  size_t row = 0;    ///< the row before
  double share = 0;  ///< of the way to the next row, 0 … 1
};

struct Recording {
  std::string label;           ///< bogie, as tables and reports call it
  vehicle::Scenario scenario;  ///< what the model is built from
  std::vector<Channel> channels;
  std::vector<std::vector<double>> columns;  ///< [channel][row]

  int Find(const std::string& channel) const;  ///< -1 if absent
  double begin_s() const { return columns[static_cast<size_t>(time_column)].front(); }
  double end_s() const { return columns[static_cast<size_t>(time_column)].back(); }
  Moment At(double time) const;  ///< the ends beyond them
  /// Linear between rows; 0 for an absent channel (column < 0).
  double Value(int column, const Moment& at) const;
  double Value(const std::string& channel, const Moment& at) const {
    return Value(Find(channel), at);
  }
  /// Where the leading wheelset is at `s` for the first time [s]; the end if it never gets there.
  double TimeAt(double s_m) const;
  int time_column = -1;
};

/// The runs of a result directory of `simulate` or `compare`, in its order. Errors name the file.
Result<std::vector<Recording>> LoadRecordings(const std::string& dir);

/// One bogie of a scenario run now.
Result<Recording> Record(const vehicle::Scenario& scenario, const std::string& label,
                         const vehicle::Progress& progress);

/// True if `source` is a result directory rather than a scenario.
bool IsResult(const std::string& source);

}  // namespace phs::view
