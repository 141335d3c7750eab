// Parts of the page of a sweep: its table with the columns sorted, plots, tables.
#pragma once

#include <string>
#include <vector>

#include "base/table.h"
#include "report/report_page.h"
#include "report/sweep_input.h"

namespace phs::report::sweep_page {

/// The sweep's table with the columns sorted by their part.
struct Sweep {
  Table table;
  std::vector<int> parameters;
  std::vector<int> outputs;
  std::vector<int> texts;  ///< text columns that differ between runs (bogie, track)
  std::vector<int> good;   ///< rows whose run went well
  std::vector<int> bad;
};

/// "words [unit]" of a column, and a cell in that unit.
std::string Label(const Table& table, int column);
double Value(const Table& table, int column, int row);
/// The texts of a row that differ between runs: "phs, dry".
std::string TextsOf(const Sweep& sweep, int row);

/// Grids and lists: the output over the first parameter, a curve per combination of the others;
/// with two parameters maps as well.
void AddCurves(const Sweep& sweep, int output, ReportPage* page);
void AddMaps(const Sweep& sweep, int output, ReportPage* page);
/// Samples: the output as points over the parameter it follows most.
void AddScatter(const Sweep& sweep, int output, ReportPage* page);
/// Spearman's rank correlation of two columns over the good rows; 0 if one does not vary.
double RankCorrelation(const Sweep& sweep, int a, int b);

void AddCorrelations(const Sweep& sweep, ReportPage* page);
void AddSobolIndices(const SweepReportInput& input, ReportPage* page);
/// The runs with the largest magnitude of each output, and how to repeat them.
void AddWorst(const Sweep& sweep, const std::string& study, ReportPage* page);
void AddFailed(const Sweep& sweep, const std::string& study, ReportPage* page);
void AddRuns(const Sweep& sweep, ReportPage* page);

}  // namespace phs::report::sweep_page
