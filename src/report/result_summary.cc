#include "report/result_summary.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "base/origin.h"
#include "base/result_dir.h"
#include "report/json_fields.h"
#include "report/page_links.h"
#include "report/result_kinds.h"
#include "report/sweep_report.h"

namespace phs::report {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

bool IsFile(const fs::path& path) {
  std::error_code fault;
  return fs::symlink_status(path, fault).type() == fs::file_type::regular;
}

std::string DateOf(const fs::path& folder, const fs::path& main) {
  const auto origin = ReadOrigin(folder.string());
  if (origin && !origin->date.empty()) return origin->date;
  struct stat state {};
  if (main.empty() || stat(main.c_str(), &state) != 0) return "";
  return UtcText(state.st_mtime) + ", file";
}

/// Tells a folder by the first kind whose file it holds; false if it is no result.
bool Tell(const fs::path& folder, ResultSummary* told) {
  fs::path main;
  for (const ResultKind& kind : ResultKinds()) {
    const fs::path file = folder / kind.file;
    if (!IsFile(file)) continue;
    const Result<json> read = ReadJsonObject(file.string());
    if (read.ok() && !read.value().contains(kind.member)) continue;  // another program's
    told->kind = kind.kind;
    const Status done = !read.ok() ? Status(read.error()) : MakeGuarded(file.string(), [&] {
      kind.tell(read.value(), told);
      return Status();
    });
    if (!done.ok()) {
      told->bad = true;
      told->status = "cannot be read: " + done.error().what;
    }
    main = file;
    break;
  }
  if (main.empty() && IsFile(folder / kSweepTable)) {
    main = folder / kSweepTable;
    TellSweep(main.string(), told);
  }
  const fs::path mark = folder / kResultMark;
  if (main.empty() && (!IsFile(mark) || !IsFile(folder / kOriginFile))) return false;
  if (main.empty()) told->kind = "Other", told->status = "ok", main = mark;
  told->date = DateOf(folder, main);
  return true;
}

/// Folders that are passed by: hidden ones and results being written.
bool IsPassedBy(const std::string& name) {
  return name.starts_with(".") || name.find(".partial.") != std::string::npos ||
         name.ends_with(".unfinished");
}

void Look(const fs::path& root, const fs::path& folder, FoundResults* found) {
  ResultSummary told;
  const std::string relative = folder.lexically_relative(root).generic_string();
  if (Tell(folder, &told)) {
    told.folder = relative;
    if (IsFile(folder / kReportName)) {
      told.report = relative == "." ? kReportName : relative + "/" + kReportName;
    }
    found->results.push_back(std::move(told));
  }
  std::vector<fs::path> below;
  std::error_code fault;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    std::error_code none;
    if (at->symlink_status(none).type() == fs::file_type::directory &&
        !IsPassedBy(at->path().filename().string())) {
      below.push_back(at->path());
    }
  }
  if (fault) found->closed.push_back(relative);
  std::sort(below.begin(), below.end());
  for (const fs::path& one : below) Look(root, one, found);
}

}  // namespace

FoundResults FindResults(const std::string& root) {
  FoundResults found;
  fs::path folder = fs::path(root).lexically_normal();
  if (!folder.has_filename() && folder.has_relative_path()) folder = folder.parent_path();
  Look(folder, folder, &found);
  return found;
}

Status RemakeReport(const std::string& folder, const MakeReplay& replay) {
  std::string known;
  for (const ResultKind& kind : ResultKinds()) {
    if (kind.remake == nullptr) continue;
    known += (known.empty() ? "" : ", ") + std::string(kind.file);
    if (fs::exists(fs::path(folder) / kind.file)) return kind.remake(folder, replay);
  }
  if (fs::exists(fs::path(folder) / kSweepTable)) return RemakeSweepReport(folder);
  return Error{folder, "holds no result that a report is drawn from",
               "a folder with " + known + ", " + kSweepTable, ""};
}

}  // namespace phs::report
