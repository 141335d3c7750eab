// The parts of the identification report, one function each.
#pragma once

#include "report/identify_results.h"
#include "report/report_page.h"

namespace phs::report {

// identify_words.cc
/// `words` with spaces for underscores.
std::string Spaced(std::string words);
/// An accepted effect: name, the lines or cylinders it acts on, its formula if it is on no list.
std::string DescribeEffect(const nlohmann::ordered_json& effect);
/// Of a rig run: a section of its own; nothing if the data are sound.
void AddDataFindings(const IdentifyResults& results, ReportPage* page);
/// Effects that the record does not tell apart; where the residual of the declared model sits.
void AddDoubt(const IdentifyResults& results, ReportPage* page);
void AddUnexplained(const IdentifyResults& results, ReportPage* page);
/// What to do next, the most useful first; never empty.
std::vector<std::string> NextTests(const IdentifyResults& results);
void AddNextTests(const IdentifyResults& results, ReportPage* page);

// identify_tables.cc
/// Significant figures that show the interval of a fitted number: one of its half width, 3 to 8.
int FiguresOf(const nlohmann::ordered_json& parameter);
void AddErrorFigures(const IdentifyResults& results, ReportPage* page);
void AddErrorTable(const IdentifyResults& results, ReportPage* page);
void AddEffectTable(const IdentifyResults& results, ReportPage* page);
void AddCandidateTable(const IdentifyResults& results, ReportPage* page);

// identify_plots.cc
void AddTimePlots(const IdentifyResults& results, ReportPage* page);
void AddLoops(const IdentifyResults& results, ReportPage* page);
void AddResidualMaps(const IdentifyResults& results, ReportPage* page);

}  // namespace phs::report
