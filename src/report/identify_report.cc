#include "report/identify_report.h"

#include "report/identify_glance.h"
#include "report/identify_parts.h"
#include "report/json_fields.h"

namespace phs::report {
namespace {

std::string IdentifySubtitle(const IdentifyResults& results) {
  std::string text = results.all.value("rig", "");
  text += text == "bogie" ? " on its track" : " rig";
  for (const char* key : {"declared", "data"}) {
    const auto found = results.all.find(key);
    if (found == results.all.end() || !found->is_string()) continue;
    text += std::string(", ") + (std::string(key) == "declared" ? "declared model " : "data ") +
            found->get<std::string>();
  }
  return text;
}

/// The first screen: of an identification its verdict, of a rig run its errors.
void AddTop(const IdentifyResults& results, ReportPage* page) {
  page->Section("At a glance");
  if (results.has_before) return AddGlance(results, page);
  AddErrorFigures(results, page);
  AddDataFindings(results, page);
}

Status WriteIdentifyPage(const IdentifyReportInput& input, const std::string& path) {
  Result<IdentifyResults> read = ReadIdentifyResults(input);
  if (!read.ok()) return read.error();
  const IdentifyResults& results = read.value();
  const bool identified = results.has_before;
  ReportPage page(identified ? "What the declared model lacks" : "Rig against model",
                  IdentifySubtitle(results));
  AddTop(results, &page);
  page.Section("Errors");
  AddErrorTable(results, &page);
  if (identified) {
    page.Section("Effects");
    AddDoubt(results, &page);
    AddEffectTable(results, &page);
    AddCandidateTable(results, &page);
  }
  if (!results.time.empty()) {
    page.Section("Over time");
    AddTimePlots(results, &page);
    if (results.place.empty()) {
      page.Section("Loops");
      AddLoops(results, &page);
    }
    page.Section("Where the residual lives");
    AddResidualMaps(results, &page);
  }
  if (identified) {
    page.Section("What is still unexplained");
    AddUnexplained(results, &page);
    page.Section("Which test to run next");
    AddNextTests(results, &page);
  }
  return page.Write(path);
}

}  // namespace

Status WriteIdentifyReport(const IdentifyReportInput& input, const std::string& path) {
  return MakeGuarded(input.result, [&] { return WriteIdentifyPage(input, path); });
}

}  // namespace phs::report
