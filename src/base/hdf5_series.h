// Time series in one HDF5 file: one dataset per channel under /channels with attributes `unit` and
// `description`, file attributes for the run; appended in blocks so that recording stays cheap.
#pragma once

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

/// Writes rows of doubles to a chunked, compressed HDF5 file. Rows are buffered in memory.
class SeriesWriter {
 public:
  static Result<SeriesWriter> Create(const std::string& path, std::vector<Channel> channels);
  SeriesWriter(SeriesWriter&&) noexcept;
  SeriesWriter& operator=(SeriesWriter&&) noexcept;
  ~SeriesWriter();
  /// Appends one row; `row` holds one value per channel. No allocation except every 1024 rows.
  Status Append(const double* row);
  /// File attribute (text).
  Status Note(const std::string& name, const std::string& value);
  /// Flushes and closes; errors (disk full) surface here.
  Status Close();

 private:
  struct Impl;
  explicit SeriesWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A series read back.
struct Series {
  std::vector<Channel> channels;
  std::vector<std::vector<double>> columns;  ///< [channel][row]
  int Find(const std::string& name) const;   ///< -1 if absent
};
Result<Series> ReadSeries(const std::string& path);

}  // namespace phs
