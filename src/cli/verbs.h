// What the verbs of `phs` share; their table is verb_table.h.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "base/result_dir.h"

namespace CLI {
class App;
}  // namespace CLI

namespace phs::cli {

/// Exit codes of the program (docs/program.md).
/// Stopped by a signal: 128 + its number, 130 after Ctrl-C.
enum ExitCode {
  kDone = 0,
  kFailed = 1,
  kUsage = 2,
  kBadInput = 3,
  kInternal = 5,
  kSignalled = 128
};

/// Options that every verb has.
struct CommonOptions {
  std::string out;  ///< result directory; empty = none asked for
  std::string format = "text";
  bool quiet = false;
  bool force = false;
};

/// Adds --out, --format, --quiet, --force to a subcommand.
void AddCommonOptions(CLI::App* verb, CommonOptions* options);

/// For options that name a file or folder: '' is refused.
std::string NotEmpty(const std::string& path);

/// Prints `error` as one line on stderr and returns its exit code: bad input; failed where the disk
/// is full or fails; that of the signal where the user stopped the work.
int BadInput(const Error& error);

/// Says that the work was stopped and `what` became of it; returns the exit code.
int Stopped(const std::string& what);

/// The result directory asked for with --out; none without it.
Result<std::optional<ResultDir>> OpenAskedDir(const CommonOptions& options);

/// Commits a written result and, unless JSON goes to stdout, says where the report is.
Status CommitAndTell(const CommonOptions& options, ResultDir* dir);
/// Writes `text` as the file `name` and report.html made from it, commits the directory and, unless
/// JSON goes to stdout, says where the report is.
Status Publish(const CommonOptions& options, const std::string& name, const std::string& text,
               Status (*write_report)(const std::string& file, const std::string& html),
               ResultDir* dir);

/// What the chosen verb does; returns the exit code.
using Action = std::function<int()>;

}  // namespace phs::cli
