// How a page is written: with its last section, which program, command, day and input files it comes
// from, and with a link to the index above it.
#include <fmt/format.h>

#include <filesystem>

#include "base/disk.h"
#include "base/origin.h"
#include "report/page_links.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

/// "2026-11-23T17:00:00Z" for reading.
std::string DateWords(std::string date) {
  if (date.size() != 20 || date[10] != 'T' || date[19] != 'Z') return date;
  return date.substr(0, 10) + ", " + date.substr(11, 8) + " UTC";
}

void AddOrigin(const std::optional<Origin>& origin, ReportPage* page) {
  page->Section("Where this comes from");
  if (!origin) {
    page->Paragraph(
        "The command, its date and its inputs were not recorded with this result. Page drawn by "
        "phs " PHS_VERSION ".");
    return;
  }
  page->Paragraph(fmt::format("Calculated by {} on {}; page drawn by phs " PHS_VERSION ".",
                              origin->program, DateWords(origin->date)));
  page->Paragraph(
      "The command. Here and in the tables folders of the machine are left away; origin.json "
      "beside "
      "this page has the whole paths.");
  page->Preformatted(origin->command);
  if (origin->inputs.empty()) {
    page->Paragraph("No input file was read.");
    return;
  }
  DataTable table{.caption = fmt::format("Input files that were read ({})", origin->inputs.size()),
                  .head = {"File", "SHA-256 of its bytes"},
                  .words = true};
  for (const InputFile& file : origin->inputs) table.rows.push_back({file.path, file.sha256});
  page->Add(table);
}

}  // namespace

Status ReportPage::Write(const std::string& path) const {
  const std::filesystem::path file(path);
  ReportPage whole = *this;
  if (!whole.origin_ && file.filename() == kReportName) {
    whole.origin_ = ReadOrigin(file.parent_path().string());
  }
  AddOrigin(whole.origin_, &whole);
  if (whole.links_.empty()) whole.links_ = LinkToIndexAbove(path);
  return WriteFileAtomically(path, whole.Html());
}

}  // namespace phs::report
