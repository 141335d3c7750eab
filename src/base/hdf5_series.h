// Time series in one HDF5 file: one dataset per channel under /channels with attributes `unit` and
// `description`, file attributes for the run; appended in blocks so that recording stays cheap.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs {

struct Channel {
  std::string name;  ///< with unit suffix, e.g. "lead_outer_Y_N"
  std::string unit;  ///< "N"
  std::string description;
};

/// Writes rows of doubles to a chunked, compressed HDF5 file. The file is built in memory and
/// written whole by Close(): HDF5 1.10 ends the program by a fault when a disk is full while it
/// writes. After the first failure every further call fails.
class SeriesWriter {
 public:
  static Result<SeriesWriter> Create(const std::string& path, const std::vector<Channel>& channels);
  SeriesWriter(SeriesWriter&&) noexcept;
  SeriesWriter& operator=(SeriesWriter&&) noexcept;
  ~SeriesWriter();
  /// Appends one row; `row` holds one value per channel. No allocation except every 1024 rows.
  Status Append(const double* row);
  /// File attribute (text).
  Status Note(const std::string& name, const std::string& value);
  /// Writes the file, whole or not at all; errors (disk full) surface here. Once, at the end.
  Status Close();

 private:
  struct Impl;
  explicit SeriesWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A series read back, channels in the order they were written.
struct Series {
  std::vector<Channel> channels;
  std::vector<std::vector<double>> columns;  ///< [channel][row]
  std::map<std::string, std::string> notes;  ///< file attributes
  int Find(const std::string& name) const;   ///< -1 if absent
};
/// Reads a series; columns of different length, text and matrices are errors.
Result<Series> ReadSeries(const std::string& path);

}  // namespace phs
