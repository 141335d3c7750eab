#include "report/index_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/result_dir.h"
#include "base/words.h"
#include "report/page_links.h"
#include "report/report_page.h"
#include "report/result_summary.h"

namespace phs::report {
namespace {

namespace fs = std::filesystem;

/// Names beside a folder that does not exist.
std::vector<std::string> Neighbours(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code fault;
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  for (fs::directory_iterator at(parent, fault), end; !fault && at != end; at.increment(fault)) {
    std::error_code none;
    if (at->is_directory(none)) names.push_back(at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Status CheckPlace(const std::string& folder) {
  std::error_code fault;
  if (!fs::exists(folder, fault)) {
    const fs::path path =
        fs::path(folder).has_filename() ? fs::path(folder) : fs::path(folder).parent_path();
    return Error{folder, "no such folder", "a folder with results below it",
                 DidYouMean(path.filename().string(), Neighbours(path), "check the path")};
  }
  if (!fs::is_directory(folder, fault)) {
    return Error{folder, "is a file", "a folder with results below it", ""};
  }
  const std::string index = (fs::path(folder) / kIndexName).string();
  const auto kind = fs::symlink_status(index, fault).type();
  if (kind == fs::file_type::not_found) return {};
  const auto before = ReadFile(index);
  if (kind == fs::file_type::regular && before.ok() && IsOwnPage(before.value())) return {};
  return Error{index, "exists and was not written by phs", "",
               "move it away: it would be replaced"};
}

std::string NameOf(const ResultSummary& result, const std::string& folder) {
  if (result.folder != ".") return result.folder;
  std::error_code fault;
  const fs::path whole = fs::weakly_canonical(folder, fault);
  return whole.filename().string();
}

DataTable TableOf(const FoundResults& found, const std::string& folder) {
  DataTable table{.caption = "Results by folder",
                  .head = {"Folder", "What", "Status", "Numbers", "Date (UTC)"},
                  .words = true};
  for (const ResultSummary& r : found.results) {
    TableCell name(NameOf(r, folder) + (r.report.empty() ? " (no report)" : ""));
    if (!r.report.empty()) name.link = Address(r.report);
    TableCell status(r.status);
    status.bad = r.bad;
    std::string date = r.date.substr(0, 16);
    std::replace(date.begin(), date.end(), 'T', ' ');
    if (r.date.ends_with("file")) date += " (file)";
    table.rows.push_back({name, r.kind, status, r.numbers, date});
  }
  return table;
}

ReportPage PageOf(const FoundResults& found, const std::string& folder) {
  std::error_code fault;
  ReportPage page("Results", fs::weakly_canonical(folder, fault).filename().string());
  const auto bad = std::count_if(found.results.begin(), found.results.end(),
                                 [](const ResultSummary& r) { return r.bad; });
  page.Paragraph(
      fmt::format("{} result{}{}. Links lead to the reports.", found.results.size(),
                  found.results.size() == 1 ? "" : "s",
                  bad > 0 ? fmt::format(", {} with something wrong (marked)", bad) : ""));
  if (!found.closed.empty()) {
    page.Warning(fmt::format("{} could not be looked into: {}.",
                             found.closed.size() == 1 ? "One folder" : "Folders",
                             JoinWords(found.closed)));
  }
  page.Add(TableOf(found, folder));
  page.Note(
      "A date with (file) is that of the result's file: the result itself names none. Folders of "
      "results being written and hidden folders are left out, links are not followed. New results "
      "come in with the next phs report --index.");
  return page;
}

/// From the page's folder up to that of the index.
std::string Up(const std::string& report) {
  std::string up;
  for (const char c : report) up += c == '/' ? "../" : "";
  return up;
}

/// A result may hold the index of its own folder, too: `--force` must know that it is ours.
Status AddToMark(const std::string& folder) {
  const std::string mark = (fs::path(folder) / kResultMark).string();
  std::error_code fault;
  if (!fs::is_regular_file(fs::symlink_status(mark, fault))) return {};
  const auto text = ReadFile(mark);
  if (!text.ok()) return text.error();
  const std::string line = std::string(kIndexName) + "\n";
  if (text.value().find("\n" + line) != std::string::npos) return {};
  return WriteFileAtomically(mark, text.value() + line);
}

}  // namespace

Result<IndexWritten> WriteIndex(const std::string& folder) {
  if (Status s = CheckPlace(folder); !s.ok()) return s.error();
  const FoundResults found = FindResults(folder);
  if (found.results.empty()) {
    return Error{folder, "holds no result of phs", "a folder with results below it",
                 found.closed.empty() ? "name the folder that --out was given"
                                      : "some folders cannot be looked into: check their rights"};
  }
  IndexWritten written{.page = (fs::path(folder) / kIndexName).string()};
  written.results = static_cast<int>(found.results.size());
  std::vector<PageLink> reports;
  for (const ResultSummary& r : found.results) {
    if (!r.report.empty()) reports.push_back({NameOf(r, folder), r.report});
  }
  written.reports = static_cast<int>(reports.size());
  const ReportPage page = PageOf(found, folder);
  if (Status s = WriteFileAtomically(written.page, page.Html()); !s.ok()) return s.error();
  if (Status s = AddToMark(folder); !s.ok()) return s.error();
  for (size_t i = 0; i < reports.size(); ++i) {
    const std::string& path = reports[i].path;
    const auto put =
        PutLinks((fs::path(folder) / path).string(), NeighbourLinks(reports, i, Up(path)));
    if (!put.ok()) return put.error();
    if (!put.value()) ++written.older;
  }
  return written;
}

}  // namespace phs::report
