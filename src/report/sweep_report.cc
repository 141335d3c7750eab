#include "report/sweep_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/table.h"
#include "report/readable_name.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

constexpr int kMostCurves = 8;

/// The sweep's table with the columns sorted by their part.
struct Sweep {
  Table table;
  std::vector<int> parameters;
  std::vector<int> outputs;
  std::vector<int> texts;  ///< text columns that differ between runs (bogie, track)
  std::vector<int> good;   ///< rows whose run went well
  std::vector<int> bad;
};

bool IsNumeric(const Table& table, int column) {
  for (double value : table.columns[column]) {
    if (std::isfinite(value)) return true;
  }
  return false;
}

bool Varies(const Table& table, int column) {
  const std::set<std::string> values(table.text[column].begin(), table.text[column].end());
  return values.size() > 1;
}

Error MissingColumn(const Table& table, const std::string& name) {
  return {.where = table.source,
          .what = "has no numeric column '" + name + "'",
          .allowed = fmt::format("{}", fmt::join(table.names, ", ")),
          .mend = ""};
}

Status FindColumns(const std::vector<std::string>& names, const Table& table,
                   std::vector<int>* columns) {
  for (const std::string& name : names) {
    const int column = table.Find(name);
    if (column < 0 || !IsNumeric(table, column)) return MissingColumn(table, name);
    columns->push_back(column);
  }
  return {};
}

Result<Sweep> ReadSweep(const SweepReportInput& input) {
  Result<Table> read = ReadCsv(input.table);
  if (!read.ok()) return read.error();
  Sweep sweep;
  sweep.table = std::move(read.value());
  const Table& table = sweep.table;
  if (Status s = FindColumns(input.parameters, table, &sweep.parameters); !s.ok()) {
    return s.error();
  }
  if (Status s = FindColumns(input.outputs, table, &sweep.outputs); !s.ok()) return s.error();
  const int status = table.Find("status");
  for (int i = 0; i < table.num_columns(); ++i) {
    const bool left = status < 0 || i < status;
    if (i == status) continue;
    if (IsNumeric(table, i)) {
      if (left && input.parameters.empty() && Varies(table, i)) sweep.parameters.push_back(i);
      if (!left && input.outputs.empty()) sweep.outputs.push_back(i);
    } else if (left && Varies(table, i)) {
      sweep.texts.push_back(i);
    }
  }
  for (int row = 0; row < table.num_rows(); ++row) {
    const bool ok = status < 0 || table.text[status][row] == "ok";
    (ok ? sweep.good : sweep.bad).push_back(row);
  }
  if (sweep.parameters.empty() || sweep.outputs.empty()) {
    return Error{.where = input.table,
                 .what = "shows no parameter that varies or no result",
                 .allowed = "a CSV with varied parameters left and results right of `status`",
                 .mend = "name parameters and outputs"};
  }
  return sweep;
}

std::string Label(const Table& table, int column) {
  const ReadableName name = Readable(table.names[column]);
  return name.words + " [" + name.unit + "]";
}

double Value(const Table& table, int column, int row) {
  return Readable(table.names[column]).factor * table.columns[column][row];
}

/// What tells one curve from another: texts and all parameters but the first.
std::string CurveName(const Sweep& sweep, int row) {
  std::string name;
  for (int column : sweep.texts) {
    name += (name.empty() ? "" : ", ") + sweep.table.text[column][row];
  }
  for (std::size_t i = 1; i < sweep.parameters.size(); ++i) {
    const int column = sweep.parameters[i];
    const ReadableName words = Readable(sweep.table.names[column]);
    name += fmt::format("{}{} {} {}", name.empty() ? "" : ", ", words.words,
                        FormatNumber(Value(sweep.table, column, row)), words.unit);
  }
  return name.empty() ? "all runs" : name;
}

void AddCurves(const Sweep& sweep, int output, ReportPage* page) {
  std::map<std::string, std::vector<std::pair<double, double>>> curves;
  for (int row : sweep.good) {
    curves[CurveName(sweep, row)].emplace_back(Value(sweep.table, sweep.parameters[0], row),
                                               Value(sweep.table, output, row));
  }
  const std::string title = Readable(sweep.table.names[output]).words;
  XyPlot plot{.title = title,
              .x_label = Label(sweep.table, sweep.parameters[0]),
              .y_label = Label(sweep.table, output),
              .height_px = 300};
  for (auto& [name, points] : curves) {
    const int number = static_cast<int>(plot.curves.size());
    if (number == kMostCurves) {
      plot.title += fmt::format(" (the first {} of {} series)", kMostCurves, curves.size());
      break;
    }
    std::sort(points.begin(), points.end());
    Curve curve{.label = name, .colour = number, .dash = number % 4};
    for (const auto& [x, y] : points) {
      curve.x.push_back(x);
      curve.y.push_back(y);
    }
    plot.curves.push_back(std::move(curve));
  }
  if (!plot.curves.empty()) page->Add(plot);
}

/// Edges of cells around sorted values: midway between neighbours.
std::vector<double> EdgesAround(const std::set<double>& values) {
  const std::vector<double> v(values.begin(), values.end());
  std::vector<double> edges = {v[0] - (v[1] - v[0]) / 2};
  for (std::size_t i = 1; i < v.size(); ++i) edges.push_back((v[i - 1] + v[i]) / 2);
  edges.push_back(v.back() + (v.back() - v[v.size() - 2]) / 2);
  return edges;
}

/// One map per text combination, for sweeps of two parameters with at least three values each.
void AddMaps(const Sweep& sweep, int output, ReportPage* page) {
  if (sweep.parameters.size() != 2) return;
  std::set<double> xs;
  std::set<double> ys;
  std::map<std::string, std::map<std::pair<double, double>, double>> maps;
  for (int row : sweep.good) {
    const double x = Value(sweep.table, sweep.parameters[0], row);
    const double y = Value(sweep.table, sweep.parameters[1], row);
    xs.insert(x);
    ys.insert(y);
    std::string name;
    for (int column : sweep.texts) {
      name += (name.empty() ? "" : ", ") + sweep.table.text[column][row];
    }
    maps[name][{x, y}] = Value(sweep.table, output, row);
  }
  if (xs.size() < 3 || ys.size() < 3) return;
  for (const auto& [name, cells] : maps) {
    HeatMap map{
        .title = Readable(sweep.table.names[output]).words + (name.empty() ? "" : ", ") + name,
        .x_label = Label(sweep.table, sweep.parameters[0]),
        .y_label = Label(sweep.table, sweep.parameters[1]),
        .value_label = Label(sweep.table, output),
        .x_edges = EdgesAround(xs),
        .y_edges = EdgesAround(ys),
        .diverging = false};
    for (double y : ys) {
      std::vector<double> row;
      for (double x : xs) {
        const auto found = cells.find({x, y});
        row.push_back(found == cells.end() ? std::numeric_limits<double>::quiet_NaN()
                                           : found->second);
      }
      map.values.push_back(std::move(row));
    }
    page->Add(map);
  }
}

void AddRuns(const Sweep& sweep, ReportPage* page) {
  DataTable table{.caption = "All runs", .head = {"Run"}};
  for (const std::string& name : sweep.table.names) table.head.push_back(name);
  for (int row = 0; row < sweep.table.num_rows(); ++row) {
    std::vector<TableCell> cells = {TableCell(std::to_string(row + 1))};
    for (int i = 0; i < sweep.table.num_columns(); ++i) {
      const double value = sweep.table.columns[i][row];
      cells.emplace_back(std::isfinite(value) ? FormatNumber(value, 4) : sweep.table.text[i][row]);
    }
    table.rows.push_back(std::move(cells));
  }
  page->BeginDetails(fmt::format("Table of all {} runs", sweep.table.num_rows()));
  page->Add(table);
  page->EndDetails();
}

}  // namespace

Status WriteSweepReport(const SweepReportInput& input, const std::string& path) {
  Result<Sweep> read = ReadSweep(input);
  if (!read.ok()) return read.error();
  const Sweep& sweep = read.value();
  std::string varied;
  for (int column : sweep.parameters) {
    varied += (varied.empty() ? "" : ", ") + Readable(sweep.table.names[column]).words;
  }
  ReportPage page("Sweep over " + varied, fmt::format("{} runs", sweep.table.num_rows()));
  page.Section("Results");
  if (!sweep.bad.empty()) {
    page.Warning(
        fmt::format("{} of {} runs did not end well and are left out of the plots; the "
                    "table at the end names them.",
                    sweep.bad.size(), sweep.table.num_rows()));
  }
  page.BeginGrid(2);
  for (int output : sweep.outputs) AddCurves(sweep, output, &page);
  page.EndGrid();
  page.BeginGrid(2);
  for (int output : sweep.outputs) AddMaps(sweep, output, &page);
  page.EndGrid();
  page.Section("Runs");
  AddRuns(sweep, &page);
  return page.Write(path);
}

}  // namespace phs::report
