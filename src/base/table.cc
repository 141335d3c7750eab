#include "base/table.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/result_dir.h"
#include "base/yaml.h"

namespace phs {
namespace {

std::string Trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

double ToNumber(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [rest, fault] = std::from_chars(begin, end, value);
  if (fault != std::errc() || rest != end) return std::numeric_limits<double>::quiet_NaN();
  return value;
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

Result<std::vector<std::string>> SplitLine(const std::string& line, const std::string& where) {
  csv_parser parser;
  if (csv_init(&parser, CSV_APPEND_NULL) != 0) return Error{where, "out of memory"};
  Cells cells;
  const bool bad = csv_parse(&parser, line.data(), line.size(), &Cells::OnField, &Cells::OnRow,
                             &cells) != line.size() ||
                   csv_fini(&parser, &Cells::OnField, &Cells::OnRow, &cells) != 0;
  const std::string reason = bad ? csv_strerror(csv_error(&parser)) : "";
  csv_free(&parser);
  if (bad) return Error{where, "broken CSV: " + reason, "comma separated values", ""};
  return cells.rows.empty() ? std::vector<std::string>{} : cells.rows[0];
}

}  // namespace

int Table::Find(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

Result<std::vector<double>> Table::Column(std::string_view name) const {
  const int at = Find(name);
  if (at >= 0) return columns[static_cast<size_t>(at)];
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  const std::string nearest = NearestWord(name, names);
  return Error{source, "has no column '" + std::string(name) + "'", "it has: " + list,
               nearest.empty() ? "" : "did you mean '" + nearest + "'?"};
}

Result<Table> ParseCsv(const std::string& text, const std::string& name) {
  Table table;
  table.source = name;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string trimmed = Trimmed(line);
    if (trimmed.empty() || trimmed[0] == '#') continue;
    const std::string where = fmt::format("{}:{}", name, number);
    auto cells = SplitLine(trimmed, where);
    if (!cells.ok()) return cells.error();
    if (table.names.empty()) {
      for (const std::string& cell : cells.value()) {
        const std::string column = Trimmed(cell);
        if (column.empty()) return Error{where, "a column has no name", "a header row", ""};
        if (table.Find(column) >= 0) {
          return Error{where, "column '" + column + "' is given twice", "each name once", ""};
        }
        table.names.push_back(column);
      }
      table.columns.resize(table.names.size());
      table.text.resize(table.names.size());
      continue;
    }
    if (cells.value().size() != table.names.size()) {
      return Error{where, fmt::format("has {} cells", cells.value().size()),
                   fmt::format("{} as in the header", table.names.size()), ""};
    }
    for (size_t i = 0; i < cells.value().size(); ++i) {
      table.text[i].push_back(Trimmed(cells.value()[i]));
      table.columns[i].push_back(ToNumber(table.text[i].back()));
    }
    table.line.push_back(number);
  }
  if (table.names.empty()) return Error{name, "is empty", "a header row and rows of numbers", ""};
  if (table.line.empty()) return Error{name, "has a header but no rows", "at least one row", ""};
  return table;
}

Result<Table> ReadCsv(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  return ParseCsv(text.value(), path);
}

Result<Table> ReadTable(const std::string& path) {
  const bool is_mat = path.size() > 4 && path.compare(path.size() - 4, 4, ".mat") == 0;
  return is_mat ? ReadMat(path) : ReadCsv(path);
}

Status WriteCsv(const std::string& path, const std::vector<std::string>& names,
                const std::vector<std::vector<double>>& columns) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ",") + names[i];
  text += '\n';
  const size_t rows = columns.empty() ? 0 : columns[0].size();
  for (size_t row = 0; row < rows; ++row) {
    for (size_t i = 0; i < columns.size(); ++i) {
      if (i > 0) text += ',';
      // fmt prints the shortest form that reads back exactly.
      text += fmt::format("{}", columns[i][row]);
    }
    text += '\n';
  }
  return WriteFileAtomically(path, text);
}

}  // namespace phs
