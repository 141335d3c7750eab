// Which columns of a file hold the channels of a rig, and whether they can be read.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/table.h"
#include "measurement/manifest.h"

namespace phs::measurement {

/// Column that holds `channel`: named in the manifest, of the same name, with another unit at the
/// end ("load_cell_kN", "load_cell [kN]"), or the field of a MATLAB struct. -1 if none.
int FindChannel(const Table& table, const Manifest& manifest, const std::string& channel);

/// A column of this quantity whose unit says nothing here: p_bore_torr for p_bore_Pa; else empty.
std::string InUnknownUnit(const Table& table, const Manifest& manifest, const std::string& name);

/// Cells of a column that hold something which is no number, and is no sign of a missing one.
struct UnreadableCells {
  int count = 0;
  std::string where, cell;  ///< of the first: "run.csv:12"
};
UnreadableCells FindUnreadable(const Table& table, int column);

/// A column most of which is written in a way that is not read is an error, not left out in
/// silence.
Status CheckReadable(const Table& table, const Manifest& manifest, const std::string& channel);

/// Every name under `columns:` and `factors:` is one of `known` or a side channel, and every column
/// named there is in the table.
Status CheckNames(const Manifest& manifest, const Table& table, std::vector<std::string> known);

}  // namespace phs::measurement
