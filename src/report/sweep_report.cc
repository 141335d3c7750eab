#include "report/sweep_report.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/table.h"
#include "report/readable_name.h"
#include "report/report_page.h"
#include "report/sweep_parts.h"

namespace phs::report {
namespace {

using sweep_page::Sweep;

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
        fmt::format("{} of {} runs did not end well and are left out of the plots; "
                    "they stand under the worst cases.",
                    sweep.bad.size(), sweep.table.num_rows()));
  }
  page.BeginGrid(2);
  for (int output : sweep.outputs) {
    if (input.sampled) {
      sweep_page::AddScatter(sweep, output, &page);
    } else {
      sweep_page::AddCurves(sweep, output, &page);
    }
  }
  page.EndGrid();
  if (!input.sampled) {
    page.BeginGrid(2);
    for (int output : sweep.outputs) sweep_page::AddMaps(sweep, output, &page);
    page.EndGrid();
  }
  if (input.sampled) sweep_page::AddCorrelations(sweep, &page);
  sweep_page::AddSobolIndices(input, &page);
  page.Section("Worst cases");
  sweep_page::AddWorst(sweep, input.study, &page);
  sweep_page::AddFailed(sweep, input.study, &page);
  page.Section("Runs");
  sweep_page::AddRuns(sweep, &page);
  return page.Write(path);
}

}  // namespace phs::report
