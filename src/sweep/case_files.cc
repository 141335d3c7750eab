#include "sweep/case_files.h"

#include <filesystem>

#include "base/local_folder.h"
#include "base/result_dir.h"

namespace phs::sweep {

namespace fs = std::filesystem;

Result<std::string> WriteCaseFiles(const Study& study, int run, const std::string& folder) {
  return study.CaseOf(run).subject->lay_out(study, run, folder);
}

Status LayOutRun(const Study& study, int run, const std::string& folder,
                 const std::string& final_folder) {
  const std::string from = fs::absolute(folder).string() + "/";
  const std::string to = fs::absolute(final_folder).string() + "/";
  const auto file = WriteCaseFiles(study, run, from);
  if (!file.ok()) return file.error();
  auto text = ReadFile(file.value());
  if (!text.ok()) return text.error();
  std::string moved = text.value();
  for (std::size_t at = 0; (at = moved.find(from, at)) != std::string::npos; at += to.size()) {
    moved.replace(at, from.size(), to);
  }
  return WritePassingFile(file.value(), moved);
}

namespace {

Status CheckCase(const Study& study, int run, const std::string& folder) {
  const auto file = WriteCaseFiles(study, run, folder);
  if (!file.ok()) return file.error();
  const Subject& subject = *study.CaseOf(run).subject;
  const Status read = subject.check(file.value());
  if (read.ok()) return {};
  const Error& inner = read.error();
  if (!inner.where.starts_with(file.value())) return inner;
  // The reader names the run's own file: name the study and the key instead.
  const std::string key = inner.where.substr(inner.where.rfind(' ') + 1);
  const std::string of = study.CaseOf(run).name;
  return Error{study.path + (of.empty() ? "" : ": case " + of) + ": " + subject.key + "." + key,
               inner.what, inner.allowed, inner.mend};
}

}  // namespace

Status CheckCases(const Study& study) {
  const LocalFolder scratch;
  if (Status s = scratch.status(); !s.ok()) return s;
  Status status;
  for (int run = 0; run < static_cast<int>(study.cases.size()) && status.ok(); ++run) {
    status = CheckCase(study, run, scratch.path());
  }
  return status;
}

}  // namespace phs::sweep
