#include "base/result_dir.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/numbers.h"
#include "base/words.h"

namespace phs {
namespace {

namespace fs = std::filesystem;

constexpr char kPartial[] = ".partial.";
constexpr char kOld[] = ".old";
constexpr char kMarkTitle[] =
    "# A result of phs. --force replaces this folder while it holds these files alone.\n";

/// What killed writers of `path` on this machine left behind is removed; a former result that was
/// aside when its place was empty goes back.
void RemoveLeftovers(const fs::path& path) {
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
    if (lives) continue;
    if (name.ends_with(kOld) && !fs::exists(fs::symlink_status(path, ignored))) {
      fs::rename(entry.path(), path, ignored);
    } else {
      fs::remove_all(entry.path(), ignored);
    }
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

Error NoFormerResult(const std::string& path, const std::string& what) {
  return {path, "is no former result of phs: " + what,
          "--force replaces only what phs wrote, with nothing else in it",
          "choose another directory, or remove it yourself"};
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

/// Two directories change places: in one step, or by a third name.
bool ChangePlaces(const std::string& a, const std::string& b, std::error_code* fault) {
  fault->clear();
  if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) {
    *fault = {errno, std::generic_category()};
    return false;
  }
  const std::string aside = a + kOld;
  std::error_code ignored;
  fs::rename(b, aside, *fault);
  if (*fault) return false;
  fs::rename(a, b, *fault);
  if (*fault) {
    fs::rename(aside, b, ignored);
    return false;
  }
  fs::rename(aside, a, ignored);
  return true;
}

/// Files below `folder`, by their path in it, sorted; the mark is not among them.
std::set<std::string> FilesIn(const std::string& folder, std::error_code* fault) {
  std::set<std::string> files;
  for (fs::recursive_directory_iterator at(folder, *fault), end; !*fault && at != end;
       at.increment(*fault)) {
    if (at->symlink_status(*fault).type() == fs::file_type::directory) continue;
    files.insert(at->path().lexically_relative(folder).generic_string());
  }
  files.erase(kResultMark);
  return files;
}

Status WriteMark(const std::string& folder) {
  std::error_code fault;
  std::string text = kMarkTitle;
  for (const std::string& file : FilesIn(folder, &fault)) text += file + "\n";
  if (fault) return WriteFault(folder, fault.value());
  return WritePassingFile(folder + "/" + kResultMark, text);
}

}  // namespace

Status CheckFormerResult(const std::string& path) {
  std::error_code fault;
  const fs::file_type kind = fs::symlink_status(path, fault).type();
  if (kind == fs::file_type::symlink) return NoFormerResult(path, "it is a link");
  if (kind != fs::file_type::directory) return NoFormerResult(path, "it is a file");
  fault.clear();
  if (fs::is_empty(path, fault)) return {};
  const std::set<std::string> found = FilesIn(path, &fault);
  if (fault) return NoFormerResult(path, "it cannot be looked into (" + fault.message() + ")");
  const auto mark = ReadFile(path + "/" + kResultMark);
  if (!mark.ok() || mark.value().compare(0, sizeof kMarkTitle - 1, kMarkTitle) != 0) {
    const std::string held = found.empty() ? "folders" : Quoted(*found.begin());
    return NoFormerResult(path, "it holds " + held + " and no " + kResultMark);
  }
  std::set<std::string> own;
  std::istringstream lines(mark.value());
  for (std::string line; std::getline(lines, line);) own.insert(line);
  for (const std::string& file : found) {
    if (own.count(file) == 0) return NoFormerResult(path, "it holds " + Quoted(file) + " too");
  }
  return {};
}

Status AdoptIntoResult(const std::string& file) {
  const fs::path path(file);
  const std::string list = (path.parent_path() / kResultMark).string();
  const auto mark = ReadFile(list);
  if (!mark.ok() || !mark.value().starts_with(kMarkTitle)) return {};
  const std::string line = path.filename().string() + "\n";
  if (mark.value().find("\n" + line) != std::string::npos) return {};
  return WriteFileAtomically(list, mark.value() + line);
}

Result<ResultDir> ResultDir::Create(const std::string& final_path, bool force) {
  fs::path path = fs::path(final_path).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  if (path.empty() || HoldsCurrentDirectory(path)) {
    return Error{final_path.empty() ? "result directory ''" : final_path,
                 "cannot be a result directory: the current directory lies in it",
                 "a directory of its own", ""};
  }
  std::error_code fault;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), fault);
  if (!fault) RemoveLeftovers(path);
  std::error_code none;
  if (fs::exists(fs::symlink_status(path, none))) {
    if (!force) return ExistsAlready(path.string());
    if (Status s = CheckFormerResult(path.string()); !s.ok()) return s.error();
  }
  const std::string partial = path.string() + kPartial + WriterName();
  if (!fault) fs::create_directory(partial, fault);
  if (!fault) return ResultDir(path.string(), partial, force);
  const Error error = WriteFault(path.string(), fault.value());
  if (IsDiskFault(error)) return error;
  return Error{path.string(), "cannot be created (" + fault.message() + ")",
               "a place that can be written", ""};
}

void ResultDir::RemoveAbandoned(const std::string& final_path) {
  fs::path path = fs::path(final_path).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  if (!path.empty()) RemoveLeftovers(path);
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

std::string ResultDir::Parent() const { return fs::path(final_path_).parent_path().string(); }

Status ResultDir::Commit() {
  PHS_CHECK(!partial_.empty());
  if (Status s = WriteMark(partial_); !s.ok()) return s;
  if (Status s = SyncTree(partial_); !s.ok()) return s;
  std::error_code fault;
  if (RenameToNew(partial_, final_path_, &fault)) {
    if (Status s = SyncFolder(Parent()); !s.ok()) {
      std::error_code ignored;
      (void)RenameToNew(final_path_, partial_, &ignored);
      return s;
    }
    partial_.clear();
    return {};
  }
  if (fault == std::errc::file_exists) return force_ ? Replace() : ExistsAlready(final_path_);
  return WriteFault(final_path_, fault.value());
}

Status ResultDir::Replace() {
  // Hours may have passed since it was looked into.
  if (Status s = CheckFormerResult(final_path_); !s.ok()) return s;
  std::error_code fault;
  if (!ChangePlaces(partial_, final_path_, &fault)) {
    return WriteFault(final_path_, fault.value());
  }
  if (Status s = SyncFolder(Parent()); !s.ok()) {
    std::error_code ignored;
    (void)ChangePlaces(partial_, final_path_, &ignored);
    return s;
  }
  fs::remove_all(partial_, fault);  // the old one; the new one stands whatever becomes of it
  partial_.clear();
  return {};
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
  if (!file.is_open() || file.bad() || !text) return ReadFault(path, errno != 0 ? errno : EIO);
  return text.str();
}

}  // namespace phs
