#include "cli/verbs.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "base/origin.h"

namespace phs::cli {
void AddCommonOptions(CLI::App* verb, CommonOptions* options) {
  verb->add_option("--out", options->out, "Result directory (complete or absent)")->check(NotEmpty);
  verb->add_option("--format", options->format, "Output on stdout")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  verb->add_flag("--quiet", options->quiet, "No progress on stderr");
  verb->add_flag("--force", options->force, "Replace a former result of phs");
}

std::string NotEmpty(const std::string& path) {
  return path.empty() ? "is empty; name a file or folder, or leave the option away" : "";
}

int BadInput(const Error& error) {
  std::fprintf(stderr, "phs: %s\n", error.Line().c_str());
  if (StopSignal() != 0) return kSignalled + StopSignal();
  return IsDiskFault(error) ? kFailed : kBadInput;
}

int Stopped(const std::string& what) {
  std::fprintf(stderr, "phs: stopped; %s\n", what.c_str());
  return kSignalled + StopSignal();
}

Result<std::optional<ResultDir>> OpenAskedDir(const CommonOptions& options) {
  std::optional<ResultDir> dir;
  if (options.out.empty()) return dir;
  ListenForStop();  // from here on there is something to take away
  auto created = ResultDir::Create(options.out, options.force);
  if (!created.ok()) return created.error();
  dir.emplace(std::move(created).value());
  return dir;
}

Status Publish(const CommonOptions& options, const std::string& name, const std::string& text,
               Status (*write_report)(const std::string& file, const std::string& html),
               ResultDir* dir) {
  const std::string file = dir->File(name);
  if (Status s = WriteFileAtomically(file, text); !s.ok()) return s;
  if (Status s = WriteOrigin(dir->File("")); !s.ok()) return s;
  if (Status s = write_report(file, dir->File("report.html")); !s.ok()) return s;
  return CommitAndTell(options, dir);
}

Status CommitAndTell(const CommonOptions& options, ResultDir* dir) {
  if (Status s = dir->Commit(); !s.ok()) return s;
  if (options.format == "text")
    std::printf("\nReport: %s/report.html\n", dir->final_path().c_str());
  return {};
}

}  // namespace phs::cli
