// The hydraulics in numbers: where each line and cylinder began, stood in the curve, and went at most.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/curving_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// "1.63 at 447 m".
std::string ValueAt(double value, double place) {
  return fmt::format("{} at {:.0f} m", FormatNumber(value), place);
}

/// A row of one channel: start, steady, least and greatest with their places.
std::vector<TableCell> RowOf(const CurvingResults& results, const BogieRun& run,
                             const std::string& name, const std::string& channel, double factor) {
  const std::vector<double>& s = *run.Channel("s_m");
  const std::vector<double>& y = *run.Channel(channel);
  const auto [least, most] = std::minmax_element(y.begin(), y.end());
  const auto place = [&](auto at) { return s[static_cast<size_t>(at - y.begin())]; };
  return {
      TableCell(name), TableCell(FormatNumber(factor * y.front())),
      TableCell(FormatNumber(factor * run.Mean(channel, results.steady_begin, results.steady_end))),
      TableCell(ValueAt(factor * *least, place(least))),
      TableCell(ValueAt(factor * *most, place(most)))};
}

/// Kind of the section of track at s; "" beyond its ends.
std::string KindAt(const CurvingResults& results, double s) {
  for (const Section& section : results.sections) {
    if (s >= section.begin && s < section.end) return section.kind;
  }
  return "";
}

/// Where the largest cylinder force stands, and why it may be there.
void AddLargestForce(const CurvingResults& results, const BogieRun& run, const std::string& system,
                     ReportPage* page) {
  const std::vector<double>* s = run.Channel("s_m");
  double largest = 0, place = 0;
  int cylinder = 0;
  for (int i = 1; s != nullptr; ++i) {
    const auto* force = run.Channel(fmt::format("{}cylinder_{}_force_N", system, i));
    if (force == nullptr) break;
    for (size_t k = 0; k < force->size(); ++k) {
      if (std::abs((*force)[k]) <= largest) continue;
      largest = std::abs((*force)[k]), place = (*s)[k], cylinder = i;
    }
  }
  if (cylinder == 0) return;
  const bool moves = KindAt(results, place) == "transition";
  page->Paragraph(
      fmt::format("{} kN in cylinder {} at {:.0f} m{}", FormatNumber(1e-3 * largest), cylinder,
                  place,
                  moves ? ", in a transition: there the pistons move and the seals hold against it "
                          "with all their friction, which in the arc they partly give back."
                        : "."),
      "Largest force.");
}

}  // namespace

void AddHydraulicTable(const CurvingResults& results, const BogieRun& run, const std::string& bogie,
                       const std::string& system, ReportPage* page) {
  DataTable table{
      .caption = "Hydraulics, " + BogieWords(bogie) + run.label,
      .head = {"Part", "At the start", "Steady curve", "Least of the run", "Greatest of the run"}};
  const auto add = [&](const std::string& part, const char* unit, double factor) {
    for (int i = 1;; ++i) {
      const bool line = part == "line";
      const std::string item = line ? fmt::format("L{}", i) : fmt::format("{}", i);
      const std::string channel =
          fmt::format("{}{}_{}_{}", system, part, item, line ? "pressure_Pa" : "force_N");
      const std::vector<double>* y = run.Channel(channel);
      if (y == nullptr || y->empty() || run.Channel("s_m") == nullptr) return;
      table.rows.push_back(
          RowOf(results, run, fmt::format("{} {} [{}]", part, item, unit), channel, factor));
    }
  };
  add("line", "MPa absolute", 1e-6);
  add("cylinder", "kN", 1e-3);
  if (table.rows.empty()) return;
  page->Add(table);
  AddLargestForce(results, run, system, page);
  if (run.summary.contains("warnings") && run.summary["warnings"].empty()) {
    page->Paragraph(
        "Of what is watched in every run nothing was passed: end stops of the pistons, 60 kN per "
        "cylinder, 0.1 MPa in a line, the precharge of a blow-off accumulator.",
        "Limits.");
  }
}

}  // namespace phs::report
