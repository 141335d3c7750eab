#include "base/result_dir.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/numbers.h"

namespace phs {
namespace {

namespace fs = std::filesystem;

constexpr char kPartial[] = ".partial.";

std::string HostName() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

/// "HOST.PID.COUNT": no two writers of one file share it, on one machine or on a shared disk.
std::string WriterName() {
  static std::atomic<int> count{0};
  return HostName() + '.' + std::to_string(getpid()) + '.' + std::to_string(count++);
}

/// Removes what killed writers of `path` on this machine left behind.
void RemoveAbandoned(const fs::path& path) {
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::string prefix = path.filename().string() + kPartial + HostName() + '.';
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(parent, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.compare(0, prefix.size(), prefix) != 0) continue;
    const size_t end = name.find('.', prefix.size());
    if (end == std::string::npos) continue;
    const auto pid = ParseNumber(name.substr(prefix.size(), end - prefix.size()));
    if (!pid || *pid < 2 || *pid > 1e9) continue;
    const bool lives = kill(static_cast<pid_t>(*pid), 0) == 0 || errno != ESRCH;
    if (!lives) fs::remove_all(entry.path(), ignored);
  }
}

/// True if the current directory lies in `path`: replacing it would take away the user's place.
bool HoldsCurrentDirectory(const fs::path& path) {
  std::error_code fault;
  const fs::path target = fs::canonical(path, fault);
  if (fault) return false;
  for (fs::path at = fs::current_path(fault); !fault; at = at.parent_path()) {
    if (at == target) return true;
    if (at == at.parent_path()) return false;
  }
  return false;
}

Error ExistsAlready(const std::string& path) {
  return {path, "exists already", "a new directory", "choose another, or --force"};
}

/// Renames, never over something that exists.
bool RenameToNew(const std::string& from, const std::string& to, std::error_code* fault) {
  fault->clear();
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno == EINVAL || errno == ENOSYS) {  // a file system without that flag
    if (fs::exists(to, *fault)) {
      *fault = std::make_error_code(std::errc::file_exists);
    } else {
      fs::rename(from, to, *fault);
    }
    return !*fault;
  }
  *fault = {errno, std::generic_category()};
  return false;
}

}  // namespace

Result<ResultDir> ResultDir::Create(const std::string& final_path, bool force) {
  fs::path path = fs::path(final_path).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  if (path.empty() || HoldsCurrentDirectory(path)) {
    return Error{final_path.empty() ? "result directory ''" : final_path,
                 "cannot be a result directory: the current directory lies in it",
                 "a directory of its own", ""};
  }
  std::error_code fault;
  if (fs::exists(fs::symlink_status(path, fault)) && !force) return ExistsAlready(path.string());
  fault.clear();  // nothing there is what a new directory asks for
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), fault);
  if (!fault) RemoveAbandoned(path);
  const std::string partial = path.string() + kPartial + WriterName();
  if (!fault) fs::create_directory(partial, fault);
  if (fault) {
    return Error{path.string(), "cannot be created (" + fault.message() + ")",
                 "a place that can be written", ""};
  }
  return ResultDir(path.string(), partial, force);
}

ResultDir::ResultDir(ResultDir&& other) noexcept
    : final_path_(std::move(other.final_path_)),
      partial_(std::exchange(other.partial_, "")),
      force_(other.force_) {}

ResultDir& ResultDir::operator=(ResultDir&& other) noexcept {
  std::swap(final_path_, other.final_path_);
  std::swap(partial_, other.partial_);
  std::swap(force_, other.force_);
  return *this;
}

ResultDir::~ResultDir() {
  std::error_code ignored;
  if (!partial_.empty()) fs::remove_all(partial_, ignored);
}

std::string ResultDir::File(const std::string& name) const { return partial_ + "/" + name; }

Status ResultDir::Commit() {
  PHS_CHECK(!partial_.empty());
  std::error_code fault;
  if (RenameToNew(partial_, final_path_, &fault)) {
    partial_.clear();
    return {};
  }
  if (fault == std::errc::file_exists) {
    if (!force_) return ExistsAlready(final_path_);
    // The old and the new change places at once: at no time is there neither.
    fault.clear();
    if (renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, final_path_.c_str(), RENAME_EXCHANGE) !=
        0) {
      const std::string old = partial_ + ".old";
      fs::rename(final_path_, old, fault);
      if (!fault) fs::rename(partial_, final_path_, fault);
      if (!fault) partial_ = old;
    }
    if (!fault) {  // what is aside now is the old one
      fs::remove_all(partial_, fault);
      partial_.clear();
      return {};
    }
  }
  return Error{final_path_, "cannot be put into place (" + fault.message() + ")", "", ""};
}

Status WriteFileAtomically(const std::string& path, const std::string& text) {
  std::error_code fault;
  // A pipe or a terminal is written to, not replaced.
  const bool direct = fs::exists(path, fault) && !fs::is_regular_file(path, fault);
  const std::string aside = direct ? path : path + ".tmp." + WriterName();
  errno = 0;
  std::ofstream file(aside, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    fault = {errno != 0 ? errno : EIO, std::generic_category()};
  } else if (!direct) {
    fs::rename(aside, path, fault);
  } else {
    fault.clear();
  }
  if (!fault) return {};
  std::error_code ignored;
  if (!direct) fs::remove(aside, ignored);
  return Error{path, "cannot be written (" + fault.message() + ")",
               "a place with room that can be written", ""};
}

Result<std::string> ReadFile(const std::string& path) {
  std::error_code fault;
  if (fs::is_directory(path, fault)) {
    return Error{path, "is a directory", "a readable file", "check the path"};
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || !text) {
    const int code = errno != 0 ? errno : EIO;
    return Error{path, "cannot be read (" + std::generic_category().message(code) + ")",
                 "a readable file", "check the path"};
  }
  return text.str();
}

}  // namespace phs
