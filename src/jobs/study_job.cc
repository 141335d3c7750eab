#include "jobs/study_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/disk.h"
#include "base/origin.h"
#include "base/result_dir.h"
#include "base/table.h"
#include "base/words.h"
#include "jobs/study_tables.h"
#include "report/result_summary.h"
#include "report/study_report.h"
#include "sweep/result_store.h"
#include "sweep/study_file.h"

namespace phs::jobs {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFailedCode = 1;    ///< a run or a limit failed: the result stands
constexpr int kSignalCode = 128;  ///< and more: ended by a signal

/// DIR.unfinished: the study's file and the parts that are made.
class Unfinished {
 public:
  explicit Unfinished(std::string out) {
    while (out.size() > 1 && out.back() == '/') out.pop_back();
    path_ = out + ".unfinished";
  }

  Status Open(const StudyRequest& request) const {
    std::error_code fault;
    if (fs::exists(request.out, fault) && !request.overwrite) {
      return Error{request.out, "exists already", "a new directory", "choose another, or --force"};
    }
    if (fs::exists(path_, fault)) {
      const auto former = ReadFile(File("study.yaml"));
      const bool ours = former.ok();
      if (request.resume && ours && former.value() == request.study.text) return {};
      if (request.resume || !ours || !request.overwrite) {
        return Error{path_,
                     ours && former.value() != request.study.text ? "belongs to another study"
                                                                  : "is an unfinished study",
                     "the same study with --resume",
                     ours ? "--force begins anew" : "remove it yourself"};
      }
      fs::remove_all(path_, fault);
      if (fault) return WriteFault(path_, fault.value());
    }
    fs::create_directories(path_, fault);
    if (fault) return WriteFault(path_, fault.value());
    return WriteFileAtomically(File("study.yaml"), request.study.text);
  }

  std::string File(const std::string& name) const { return path_ + "/" + name; }
  void Remove() const {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

 private:
  std::string path_;
};

/// Whether the tables of the sweeps will have the columns that are asked for, before anything runs.
Status CheckColumns(const StudyRequest& request) {
  for (const StudyPart& part : request.study.parts) {
    if (part.plots.empty() && part.spreads.empty()) continue;
    const auto sweep = sweep::LoadStudy(part.words[1]);
    if (!sweep.ok()) return sweep.error();
    const std::vector<std::string> known = sweep::ColumnNames(sweep.value());
    std::vector<std::string> asked;
    const auto ask = [&asked](const std::vector<std::string>& more) {
      asked.insert(asked.end(), more.begin(), more.end());
    };
    for (const StudyPlot& plot : part.plots) ask({plot.x, plot.y}), ask(plot.by);
    for (const StudySpread& spread : part.spreads) ask(spread.of), ask(spread.by);
    for (const std::string& name : asked) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      return Error{request.study.path + ": part " + part.name,
                   "asks for column " + Quoted(name) + " of " + part.words[1], JoinWords(known),
                   DidYouMean(name, known)};
    }
  }
  return {};
}

std::vector<std::string> WordsOf(const StudyRequest& request, const StudyPart& part,
                                 const Unfinished& work) {
  std::vector<std::string> words = part.words;
  words.insert(words.end(), {"--out", work.File(part.name)});
  std::error_code fault;
  const bool begun = fs::exists(work.File(part.name) + ".unfinished", fault);
  if (part.is_sweep && begun) words.emplace_back("--resume");
  const bool workers = request.takes_workers && request.takes_workers(part.words[0]);
  if (workers && request.workers > 0) {
    words.insert(words.end(), {"--workers", fmt::format("{}", request.workers)});
  }
  return words;
}

/// Exit code of a part that is made; what was made before is not made again.
Result<int> MakePart(const StudyRequest& request, const StudyPart& part, const Unfinished& work) {
  const std::string made = work.File(part.name + ".code");
  std::error_code fault;
  if (const auto code = ReadFile(made); code.ok() && fs::exists(work.File(part.name), fault)) {
    return std::atoi(code.value().c_str());
  }
  auto code = request.run(WordsOf(request, part, work), work.File(part.name + ".txt"));
  if (!code.ok() || code.value() >= kSignalCode) return code;
  if (code.value() > kFailedCode || !fs::exists(work.File(part.name), fault)) {
    return Error{request.study.path + ": part " + part.name,
                 fmt::format("phs {} ended with exit code {}", ShellLine(part.words), code.value()),
                 "0, or 1 with a result", "its own line above says what to mend; then --resume"};
  }
  if (Status s = WriteFileAtomically(made, fmt::format("{}\n", code.value())); !s.ok()) {
    return s.error();
  }
  return code;
}

/// The line of a result in an index of results.
report::ResultSummary ToldOf(const std::string& folder) {
  for (const report::ResultSummary& told : report::FindResults(folder).results) {
    if (told.folder == ".") return told;
  }
  return {};
}

Result<Json> PartJson(const StudyPart& part, int code, const std::string& folder) {
  const bool good = code == 0 || (code == kFailedCode && part.may_fail);
  const report::ResultSummary told = ToldOf(folder);
  std::error_code fault;
  Json json = {
      {"name", part.name},
      {"text", part.text},
      {"command", "phs " + ShellLine(part.words)},
      {"exit_code", code},
      {"status", good ? "ok" : "failed"},
      {"result", told.status},
      {"numbers", told.numbers},
      {"report", fs::exists(folder + "/report.html", fault) ? Json(part.name + "/report.html")
                                                            : Json(nullptr)},
      {"plots", Json::array()},
      {"spreads", Json::array()}};
  if (part.plots.empty() && part.spreads.empty()) return json;
  const auto table = ReadCsv(folder + "/sweep.csv");
  if (!table.ok()) return table.error();
  for (const StudyPlot& plot : part.plots) {
    auto made = PlotJson(plot, table.value());
    if (!made.ok()) return made.error();
    json["plots"].push_back(std::move(made).value());
  }
  for (const StudySpread& spread : part.spreads) {
    auto made = SpreadJson(spread, table.value());
    if (!made.ok()) return made.error();
    json["spreads"].push_back(std::move(made).value());
  }
  return json;
}

/// The parts as they lie in `work`, copied beside study.json and the page, put into place.
Status Publish(const StudyRequest& request, const Json& json, const Unfinished& work) {
  auto dir = ResultDir::Create(request.out, request.overwrite);
  if (!dir.ok()) return dir.error();
  std::error_code fault;
  for (const StudyPart& part : request.study.parts) {
    fs::copy(work.File(part.name), dir.value().File(part.name), fs::copy_options::recursive, fault);
    if (!fault)
      fs::copy_file(work.File(part.name + ".txt"), dir.value().File(part.name + ".txt"), fault);
    if (fault) return WriteFault(dir.value().File(part.name), fault.value());
  }
  const std::string main = dir.value().File("study.json");
  if (Status s = WriteFileAtomically(main, json.dump(2) + "\n"); !s.ok()) return s;
  if (Status s = WriteFileAtomically(dir.value().File("study.yaml"), request.study.text); !s.ok()) {
    return s;
  }
  if (Status s = WriteOrigin(dir.value().File("")); !s.ok()) return s;
  if (Status s = report::WriteStudyReport(dir.value().File(""), dir.value().File("report.html"));
      !s.ok()) {
    return s;
  }
  return dir.value().Commit();
}

}  // namespace

Result<MadeStudy> MakeStudy(const StudyRequest& request) {
  if (Status s = CheckColumns(request); !s.ok()) return s.error();
  const Unfinished work(request.out);
  if (Status s = work.Open(request); !s.ok()) return s.error();
  MadeStudy made{.json = {{"study", request.study.name},
                          {"question", request.study.question},
                          {"status", "ok"},
                          {"parts", Json::array()}}};
  for (const StudyPart& part : request.study.parts) {
    const auto code = MakePart(request, part, work);
    if (!code.ok()) return code.error();
    if (code.value() >= kSignalCode) {
      made.stopped_in = part.name;
      return made;
    }
    auto json = PartJson(part, code.value(), work.File(part.name));
    if (!json.ok()) return json.error();
    if (json.value()["status"] != "ok") made.json["status"] = "failed";
    made.json["parts"].push_back(std::move(json).value());
  }
  if (Status s = Publish(request, made.json, work); !s.ok()) return s.error();
  work.Remove();
  made.all = true;
  return made;
}

}  // namespace phs::jobs
