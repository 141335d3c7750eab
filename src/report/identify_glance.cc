#include "report/identify_glance.h"

#include <fmt/format.h>

#include "report/identify_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// What the record itself showed: clock, units, signs, spikes, missing samples.
void AddDataChecks(const IdentifyResults& results, ReportPage* page) {
  if (!results.all.contains("data_findings")) return;
  const json findings = results.all.value("data_findings", json::array());
  if (findings.empty()) {
    page->Paragraph(
        "Nothing to mend: clock, units, signs, spikes, clipping and missing samples were looked "
        "at.",
        "The data.");
    return;
  }
  page->Paragraph(findings.size() == 1 ? std::string("One finding in the record:")
                                       : fmt::format("{} findings in the record:", findings.size()),
                  "The data.");
  std::vector<std::string> lines;
  for (const json& finding : findings) {
    const std::string channel = finding.value("channel", "?");
    lines.push_back((channel == "t_s" ? "clock" : channel) + ": " + finding.value("text", ""));
  }
  page->List(lines);
}

void AddReasons(const IdentifyResults& results, ReportPage* page) {
  const json reasons = results.all.value("reasons", json::array());
  std::vector<std::string> lines;
  for (const json& reason : reasons) {
    if (reason.is_string()) lines.push_back(reason.get<std::string>());
  }
  if (lines.empty()) return;
  page->Paragraph("The reasons of the verdict:");
  page->List(lines);
}

}  // namespace

void AddGlance(const IdentifyResults& results, ReportPage* page) {
  const VerdictWords verdict = WordsOfVerdict(results);
  page->Verdict(verdict.sentence, verdict.tone);
  page->BeginBeside();
  page->Paragraph(WhatWasMissing(results), "What was missing.");
  page->Paragraph(HowSure(results), "How sure.");
  page->Paragraph(WhatItChanged(results), "What it changed.");
  page->Paragraph(WhatNext(results), "Next.");
  AddReasons(results, page);
  AddDataChecks(results, page);
  page->Next();
  AddWherePicture(results, page);
  AddChangePicture(results, page);
  page->EndBeside();
}

}  // namespace phs::report
