#include "cli/verbs.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>

namespace phs::cli {
namespace {

std::atomic<int> stop_signal{0};
void OnStop(int signal) {
  stop_signal = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

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

void ListenForStop() {
  if (StopSignal() != 0) return;
  std::signal(SIGINT, &OnStop);
  std::signal(SIGTERM, &OnStop);
}

int StopSignal() { return stop_signal; }

int Stopped(const std::string& what) {
  std::fprintf(stderr, "phs: stopped; %s\n", what.c_str());
  return kSignalled + StopSignal();
}

Result<std::optional<ResultDir>> OpenAskedDir(const CommonOptions& options) {
  std::optional<ResultDir> dir;
  if (options.out.empty()) return dir;
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
  if (Status s = write_report(file, dir->File("report.html")); !s.ok()) return s;
  if (Status s = dir->Commit(); !s.ok()) return s;
  if (options.format == "text")
    std::printf("\nReport: %s/report.html\n", dir->final_path().c_str());
  return {};
}

struct ProgressLine::Impl {
  std::string what;
  bool quiet = false;
  bool terminal = false;
  int last_tenth = -1;
  bool shown = false;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last{};
};

ProgressLine::ProgressLine(std::string what, bool quiet) : impl_(new Impl) {
  impl_->what = std::move(what);
  impl_->quiet = quiet;
  impl_->terminal = isatty(STDERR_FILENO) != 0;
  ListenForStop();
}

ProgressLine::~ProgressLine() {
  if (impl_->shown && impl_->terminal) std::fprintf(stderr, "\r\033[K");
  delete impl_;
}

bool ProgressLine::operator()(double share) {
  if (StopSignal() != 0) return false;
  if (impl_->quiet) return true;
  const auto now = std::chrono::steady_clock::now();
  const double elapsed = std::chrono::duration<double>(now - impl_->begin).count();
  if (share <= 0) return true;  // no time left to tell yet
  const double left = elapsed * (1 - share) / share;
  if (impl_->terminal) {
    if (now - impl_->last < std::chrono::milliseconds(100)) return true;
    impl_->last = now;
    std::fprintf(stderr, "\r\033[K%s: %3.0f %%, %.0f s left", impl_->what.c_str(), 100 * share,
                 left);
    impl_->shown = true;
  } else if (const int tenth = static_cast<int>(share * 10);
             tenth > impl_->last_tenth && elapsed > 5) {
    impl_->last_tenth = tenth;
    std::fprintf(stderr, "%s: %3.0f %%, %.0f s left\n", impl_->what.c_str(), 100 * share, left);
  }
  return true;
}

}  // namespace phs::cli
