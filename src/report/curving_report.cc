#include "report/curving_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/conicity.h"
#include "report/curving_parts.h"
#include "report/curving_results.h"
#include "report/json_fields.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

std::string Title(const CurvingResults& results) {
  std::string title = "Curving run";
  if (results.radius > 0) {
    const auto arcs = std::count_if(results.sections.begin(), results.sections.end(),
                                    [](const Section& s) { return s.kind == "curve"; });
    title +=
        fmt::format("{}, R = {:.0f} m to the {}", arcs > 1 ? " through several arcs, first" : "",
                    results.radius, results.hand > 0 ? "left" : "right");
  }
  return title;
}

std::string Subtitle(const CurvingResults& results) {
  std::string text;
  for (const BogieRun& run : results.runs) text += (text.empty() ? "" : " against ") + run.label;
  const double speed =
      results.reference().Mean("speed_m_s", results.steady_begin, results.steady_end);
  if (!results.track_name.empty()) text += " on track " + results.track_name;
  if (std::isfinite(speed)) text += fmt::format(", {:.3g} km/h", 3.6 * speed);
  const std::string version = results.reference().summary.value("version", "");
  if (!version.empty()) text += "; phs " + version;
  return text;
}

std::vector<ConicityOf> ConicityOfRuns(const CurvingResults& results) {
  std::vector<ConicityOf> bogies;
  for (const BogieRun& run : results.runs) {
    bogies.push_back({run.label, run.colour, run.summary.value("conicity", json())});
  }
  return bogies;
}

/// Side by side where the table is narrow enough, else one below the other.
void AddWordsAndTable(const CurvingResults& results, ReportPage* page) {
  constexpr size_t kNarrow = 3;
  const bool beside = results.runs.size() <= kNarrow;
  if (beside) {
    page->BeginBeside();
  } else {
    AddHeadlineTable(results, page);
  }
  AddSteeringWords(results, page);
  AddWheelWords(results, page);
  AddComparisonBars(results, page);
  if (!beside) return;
  page->Next();
  AddHeadlineTable(results, page);
  page->EndBeside();
}

Status WritePage(const CurvingReportInput& input, const std::string& path, const Replay* replay) {
  Result<CurvingResults> read = ReadCurvingResults(input);
  if (!read.ok()) return read.error();
  const CurvingResults& results = read.value();
  ReportPage page(Title(results), Subtitle(results));
  AddStatus(results, &page);
  AddRunWarnings(results, &page);
  page.Section("At a glance");
  AddKeyFigures(results, &page);
  AddTrackWords(results, &page);
  AddWordsAndTable(results, &page);
  if (replay != nullptr) AddReplay(*replay, results, &page);
  page.Section("Seen from above");
  AddPlanView(results, &page);
  page.Section("What steers, what holds back");
  AddMomentBudget(results, &page);
  AddMomentPlots(results, &page);
  page.Section("Along the track");
  AddTrackPlots(results, &page);
  page.Section("Bogie and hydraulics");
  AddHydraulicPlots(results, &page);
  AddConicity(ConicityOfRuns(results), &page);
  if (HasStandards(results)) {
    page.Section("Standards, wear");
    AddStandards(results, &page);
  }
  page.Section("Energy");
  AddEnergyTable(results, &page);
  page.Section("Inputs and assumptions");
  AddDiscretisation(results, &page);
  AddInputs(results, &page);
  page.Section("What to do next");
  AddNextSteps(results, &page);
  return page.Write(path);
}

}  // namespace

Status WriteCurvingReport(const CurvingReportInput& input, const std::string& path,
                          const Replay* replay) {
  return MakeGuarded(input.results, [&] { return WritePage(input, path, replay); });
}

Status WriteCurvingReport(const std::string& directory, const std::string& path,
                          const Replay* replay) {
  return MakeGuarded(directory, [&]() -> Status {
    Result<CurvingReportInput> input = CurvingReportInput::FromDirectory(directory);
    return input.ok() ? WriteCurvingReport(input.value(), path, replay) : Status(input.error());
  });
}

}  // namespace phs::report
