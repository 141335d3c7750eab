#include "base/table.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "base/numbers.h"
#include "base/origin.h"
#include "base/result_dir.h"
#include "base/words.h"

namespace phs {
namespace {

std::string_view Trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// One row of cells as libcsv hands them over.
struct Cells {
  std::vector<std::string> row;
  std::vector<std::vector<std::string>> rows;
  static void OnField(void* text, size_t size, void* self) {
    static_cast<Cells*>(self)->row.emplace_back(static_cast<const char*>(text), size);
  }
  static void OnRow(int, void* self) {
    auto* cells = static_cast<Cells*>(self);
    cells->rows.push_back(std::move(cells->row));
    cells->row.clear();
  }
};

/// The cells of one line. Quoted cells may hold commas and doubled quotes, but no line ends.
Result<std::vector<std::string>> SplitLine(std::string_view line, const std::string& where) {
  csv_parser parser;
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) return Error{where, "out of memory"};
  Cells cells;
  const bool bad = csv_parse(&parser, line.data(), line.size(), &Cells::OnField, &Cells::OnRow,
                             &cells) != line.size() ||
                   csv_fini(&parser, &Cells::OnField, &Cells::OnRow, &cells) != 0;
  const std::string reason = bad ? csv_strerror(csv_error(&parser)) : "";
  csv_free(&parser);
  if (bad || cells.rows.size() != 1) {
    return Error{where, "broken CSV" + (bad ? " (" + reason + ")" : std::string()),
                 "comma separated values, quotes closed on the same line", ""};
  }
  return std::move(cells.rows[0]);
}

/// Takes the names from the header row.
Status ReadHeader(const std::vector<std::string>& cells, const std::string& where, Table* table) {
  std::unordered_set<std::string> known;
  for (const std::string& cell : cells) {
    const std::string column(Trimmed(cell));
    if (column.empty()) return Error{where, "a column has no name", "a header row of names", ""};
    if (!known.insert(column).second) {
      return Error{where, "column " + Quoted(column) + " is given twice", "each name once", ""};
    }
    table->names.push_back(column);
  }
  const auto is_number = [](const std::string& cell) { return ParseNumber(Trimmed(cell)); };
  if (std::all_of(cells.begin(), cells.end(), is_number)) {
    return Error{where, "holds numbers, where the names of the columns belong",
                 "a header row of names with their units, as t_s,load_cell_N", "add one"};
  }
  if (cells.size() == 1 && cells[0].find_first_of(";\t") != std::string::npos) {
    return Error{where, "is separated by semicolons or tabs", "commas, and '.' as decimal mark",
                 "save it as comma separated values"};
  }
  table->columns.resize(table->names.size());
  table->text.resize(table->names.size());
  return {};
}

/// Appends one row of cells.
Status ReadRow(const std::vector<std::string>& cells, const std::string& where, Table* table) {
  if (cells.size() != table->names.size()) {
    return Error{where, fmt::format("has {} cells", cells.size()),
                 fmt::format("{} as in the header", table->names.size()), ""};
  }
  for (size_t i = 0; i < cells.size(); ++i) {
    const std::string_view cell = Trimmed(cells[i]);
    table->text[i].emplace_back(cell);
    const auto number = ParseNumber(cell);
    const bool fits = number && std::abs(*number) <= kLargestReading;
    table->columns[i].push_back(fits ? *number : std::numeric_limits<double>::quiet_NaN());
  }
  return {};
}

/// Line ends of any system become '\n'; a byte order mark goes.
std::string WithPlainLines(const std::string& text) {
  std::string plain;
  plain.reserve(text.size());
  for (size_t i = text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      plain += text[i];
    } else if (i + 1 >= text.size() || text[i + 1] != '\n') {
      plain += '\n';
    }
  }
  return plain;
}

}  // namespace

int Table::Find(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

Result<std::vector<double>> Table::Column(std::string_view name) const {
  const int at = Find(name);
  if (at >= 0) return columns[static_cast<size_t>(at)];
  return Error{source, "has no column " + Quoted(name), JoinWords(names), DidYouMean(name, names)};
}

Result<Table> ParseCsv(const std::string& text, const std::string& name) {
  Table table;
  table.source = name;
  if (text.find('\0') != std::string::npos || text.starts_with("\xFF\xFE") ||
      text.starts_with("\xFE\xFF")) {
    return Error{name, "is no plain text (UTF-16, or binary)", "text in UTF-8 or ASCII",
                 "save it as CSV in UTF-8"};
  }
  const std::string plain = WithPlainLines(text);
  const std::string_view all(plain);
  int number = 1;
  for (size_t begin = 0; begin < all.size(); ++number) {
    const size_t end = std::min(all.find('\n', begin), all.size());
    const std::string_view line = Trimmed(all.substr(begin, end - begin));
    begin = end + 1;
    if (line.empty() || line[0] == '#') continue;
    const std::string where = fmt::format("{}:{}", name, number);
    auto cells = SplitLine(line, where);
    if (!cells.ok()) return cells.error();
    const bool header = table.names.empty();
    const Status read =
        header ? ReadHeader(cells.value(), where, &table) : ReadRow(cells.value(), where, &table);
    if (!read.ok()) return read.error();
    if (!header) table.line.push_back(number);
  }
  if (table.names.empty()) return Error{name, "is empty", "a header row and rows of numbers", ""};
  if (table.line.empty()) return Error{name, "has a header but no rows", "at least one row", ""};
  return table;
}

Result<Table> ReadCsv(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  NoteInput(path, text.value());
  return ParseCsv(text.value(), path);
}

Result<Table> ReadTable(const std::string& path) {
  if (!path.ends_with(".mat")) return ReadCsv(path);
  NoteInput(path);
  return ReadMat(path);
}

Status WriteCsv(const std::string& path, const std::vector<std::string>& names,
                const std::vector<std::vector<double>>& columns) {
  PHS_CHECK(names.size() == columns.size());
  for (const auto& column : columns) PHS_CHECK(column.size() == columns[0].size());
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ",") + names[i];
  text += '\n';
  const size_t rows = columns.empty() ? 0 : columns[0].size();
  for (size_t row = 0; row < rows; ++row) {
    for (size_t i = 0; i < columns.size(); ++i) {
      if (i > 0) text += ',';
      text += Shortest(columns[i][row]);
    }
    text += '\n';
  }
  return WriteFileAtomically(path, text);
}

}  // namespace phs
