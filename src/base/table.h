// Tables of numbers with named columns: CSV files (libcsv) and MATLAB .mat files (matio).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace phs {

/// No quantity in any unit is larger; sums of its squares stay finite.
inline constexpr double kLargestReading = 1e60;

/// Columns of equal length. Text cells that are not numbers are kept in `text`.
struct Table {
  std::string source;                          ///< file it came from, for messages
  std::vector<std::string> names;              ///< column names with unit, e.g. "t_s"
  std::vector<std::vector<double>> columns;    ///< [column][row]; NaN where the cell is no number
  std::vector<std::vector<std::string>> text;  ///< [column][row] raw cells (CSV only; else empty)
  std::vector<int> line;                       ///< [row] line in the file

  int num_rows() const { return columns.empty() ? 0 : static_cast<int>(columns[0].size()); }
  int num_columns() const { return static_cast<int>(names.size()); }
  /// Index of a column, or -1.
  int Find(std::string_view name) const;
  /// A column by name, or an error that names the nearest column.
  Result<std::vector<double>> Column(std::string_view name) const;
};

/// Reads a CSV with one header row: commas, '.' as decimal mark, line ends of any system. `#` lines
/// are comments. Ragged rows, unclosed quotes, doubled names and empty files are errors; a cell
/// that is no number up to kLargestReading is NaN and stays readable in `text`.
Result<Table> ReadCsv(const std::string& path);
Result<Table> ParseCsv(const std::string& text, const std::string& name);
/// Reads the real numeric vectors of a MATLAB file (v5/v7.3): each variable or struct field one
/// column of its name (`struct.field` where two structs share a field name). Scalars, text and
/// matrices are no channels and are passed over; vectors of different length are an error.
Result<Table> ReadMat(const std::string& path);
/// Reads by extension: .csv, .txt, .mat.
Result<Table> ReadTable(const std::string& path);

/// Writes `columns` as CSV, each number in the shortest form that reads back exactly.
Status WriteCsv(const std::string& path, const std::vector<std::string>& names,
                const std::vector<std::vector<double>>& columns);

}  // namespace phs
