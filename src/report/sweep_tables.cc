#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/origin.h"
#include "report/readable_name.h"
#include "report/sweep_parts.h"

namespace phs::report::sweep_page {
namespace {

constexpr std::size_t kWorst = 3;        ///< shown of each output
constexpr std::size_t kMostFailed = 20;  ///< shown of the runs that did not end well
constexpr int kMostRows = 1000;          ///< of the table of all runs

/// Number of the run in a row: its column `run`, or the row itself.
int RunOf(const Table& table, int row) {
  const int column = table.Find("run");
  return column < 0 ? row : static_cast<int>(table.columns[column][row]);
}

std::string Repeat(const Table& table, int row, const std::string& study) {
  const int run = RunOf(table, row);
  return ShellLine(
      {"phs", "sweep", study, "--only", std::to_string(run), "--out", fmt::format("run_{}", run)});
}

/// "radius 400 m, phs".
std::string Varied(const Sweep& sweep, int row) {
  std::string text;
  for (int column : sweep.parameters) {
    const ReadableName name = Readable(sweep.table.names[column]);
    text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", name.words,
                        FormatNumber(Value(sweep.table, column, row), 4), name.unit);
  }
  const std::string texts = TextsOf(sweep, row);
  return texts.empty() ? text : text + ", " + texts;
}

std::vector<int> Largest(const Sweep& sweep, int output) {
  std::vector<int> rows;
  for (int row : sweep.good) {
    if (std::isfinite(sweep.table.columns[output][row])) rows.push_back(row);
  }
  const auto magnitude = [&](int row) { return std::abs(sweep.table.columns[output][row]); };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](int a, int b) { return magnitude(a) > magnitude(b); });
  rows.resize(std::min(rows.size(), kWorst));
  return rows;
}

/// What lies below is noise of the estimate.
double Thousandths(double share) { return std::round(1e3 * share) / 1e3 + 0.0; }

/// "0.774 (0.482 … 1.066)": an estimate with its interval of 95 %, of a normal error.
std::string WithInterval(double share, double standard_error) {
  const double half = 1.96 * standard_error;
  return fmt::format("{:.3f} ({:.3f} … {:.3f})", Thousandths(share), Thousandths(share - half),
                     Thousandths(share + half));
}

void AddIndexTable(const SweepReportInput& input, ReportPage* page) {
  DataTable table{.caption = "Sobol indices with their intervals of 95 %",
                  .head = {"Parameter", "first order", "total"},
                  .rows = {}};
  for (const OutputIndices& of : input.indices) {
    table.rows.push_back({TableCell(Readable(of.output).words)});
    for (std::size_t i = 0; i < input.parameters.size(); ++i) {
      table.rows.push_back({TableCell(Readable(input.parameters[i]).words),
                            TableCell(WithInterval(of.first[i], of.first_error[i])),
                            TableCell(WithInterval(of.total[i], of.total_error[i]))});
    }
  }
  page->Add(table);
}

}  // namespace

void AddCorrelations(const Sweep& sweep, ReportPage* page) {
  DataTable table{.caption = "Rank correlation (Spearman): +1 rises always, -1 falls always",
                  .head = {"Output"},
                  .rows = {}};
  for (int parameter : sweep.parameters) {
    table.head.push_back(Readable(sweep.table.names[parameter]).words);
  }
  for (int output : sweep.outputs) {
    std::vector<TableCell> cells = {TableCell(Readable(sweep.table.names[output]).words)};
    for (int parameter : sweep.parameters) {
      const double r = RankCorrelation(sweep, parameter, output);
      cells.emplace_back(fmt::format("{:+.2f}", r), std::abs(r) >= 0.5);
    }
    table.rows.push_back(std::move(cells));
  }
  page->Add(table);
}

void AddSobolIndices(const SweepReportInput& input, ReportPage* page) {
  if (input.indices.empty()) return;
  page->Section("Which parameter matters");
  page->Paragraph(
      "Share of an output's variance that a parameter explains alone (first order) and together "
      "with the others (total). ± is the standard error of the estimate; a difference between "
      "the two is interaction.",
      "Sobol indices: ");
  page->BeginGrid(2);
  for (const OutputIndices& of : input.indices) {
    BarChart chart{.title = Readable(of.output).words, .bars = {{"first order", 0}, {"total", 1}}};
    for (std::size_t i = 0; i < input.parameters.size(); ++i) {
      chart.categories.push_back(fmt::format("{} (±{:.2f})", Readable(input.parameters[i]).words,
                                             std::max(of.first_error[i], of.total_error[i])));
      chart.bars[0].values.push_back(Thousandths(of.first[i]));
      chart.bars[1].values.push_back(Thousandths(of.total[i]));
    }
    chart.significant = 2;
    page->Add(chart);
  }
  page->EndGrid();
  AddIndexTable(input, page);
}

void AddWorst(const Sweep& sweep, const std::string& study, ReportPage* page) {
  DataTable table{.caption = "Largest magnitudes of each output",
                  .head = {"Run", "value", "varied", "repeat it with all its files"},
                  .rows = {}};
  for (int output : sweep.outputs) {
    const std::vector<int> rows = Largest(sweep, output);
    if (rows.empty()) continue;
    table.rows.push_back({TableCell(Label(sweep.table, output))});
    for (int row : rows) {
      table.rows.push_back({TableCell(std::to_string(RunOf(sweep.table, row))),
                            TableCell(FormatNumber(Value(sweep.table, output, row), 4)),
                            TableCell(Varied(sweep, row)),
                            TableCell(study.empty() ? "" : Repeat(sweep.table, row, study))});
    }
  }
  page->Add(table);
}

void AddFailed(const Sweep& sweep, const std::string& study, ReportPage* page) {
  if (sweep.bad.empty()) return;
  const Table& t = sweep.table;
  const int status = t.Find("status"), reason = t.Find("reason");
  DataTable table{.caption = "Runs that did not end well",
                  .head = {"Run", "status", "reason", "varied", "repeat it"},
                  .rows = {}};
  for (std::size_t i = 0; i < std::min(sweep.bad.size(), kMostFailed); ++i) {
    const int row = sweep.bad[i];
    table.rows.push_back({TableCell(std::to_string(RunOf(t, row))), TableCell(t.text[status][row]),
                          TableCell(reason < 0 ? "" : t.text[reason][row]),
                          TableCell(Varied(sweep, row)),
                          TableCell(study.empty() ? "" : Repeat(t, row, study))});
  }
  page->Add(table);
  if (sweep.bad.size() > kMostFailed) {
    page->Note(fmt::format("{} more stand in sweep.csv.", sweep.bad.size() - kMostFailed));
  }
}

void AddRuns(const Sweep& sweep, ReportPage* page) {
  DataTable table{.caption = "All runs", .head = {}, .rows = {}};
  const bool numbered = sweep.table.Find("run") >= 0;
  if (!numbered) table.head.emplace_back("Run");
  for (const std::string& name : sweep.table.names) table.head.push_back(name);
  const int shown = std::min(sweep.table.num_rows(), kMostRows);
  for (int row = 0; row < shown; ++row) {
    std::vector<TableCell> cells;
    if (!numbered) cells.emplace_back(std::to_string(row + 1));
    for (int i = 0; i < sweep.table.num_columns(); ++i) {
      const double value = sweep.table.columns[i][row];
      cells.emplace_back(std::isfinite(value) ? FormatNumber(value, 4) : sweep.table.text[i][row]);
    }
    table.rows.push_back(std::move(cells));
  }
  page->BeginDetails(shown == sweep.table.num_rows()
                         ? fmt::format("Table of all {} runs", shown)
                         : fmt::format("Table of the first {} of {} runs (all: sweep.csv)", shown,
                                       sweep.table.num_rows()));
  page->Add(table);
  page->EndDetails();
}

}  // namespace phs::report::sweep_page
