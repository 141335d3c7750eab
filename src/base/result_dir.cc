#include "base/result_dir.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace phs {
namespace {

namespace fs = std::filesystem;

}  // namespace

Result<ResultDir> ResultDir::Create(const std::string& final_path, bool force) {
  fs::path path = fs::path(final_path).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  std::error_code fault;
  if (fs::exists(path, fault) && !force) {
    return Error{path.string(), "exists already", "a new directory", "choose another, or --force"};
  }
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), fault);
  const std::string partial = path.string() + ".partial." + std::to_string(getpid());
  fs::remove_all(partial, fault);
  fs::create_directory(partial, fault);
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
  std::error_code fault;
  const std::string old = partial_ + ".old";
  const bool replaces = fs::exists(final_path_, fault);
  if (replaces && !force_) {
    return Error{final_path_, "exists already", "a new directory", "choose another, or --force"};
  }
  if (replaces) fs::rename(final_path_, old, fault);
  if (!fault) fs::rename(partial_, final_path_, fault);
  if (fault) {
    std::error_code ignored;
    if (replaces && !fs::exists(final_path_)) fs::rename(old, final_path_, ignored);
    return Error{final_path_, "cannot be put into place (" + fault.message() + ")", "", ""};
  }
  partial_.clear();
  if (replaces) fs::remove_all(old, fault);
  return {};
}

Status WriteFileAtomically(const std::string& path, const std::string& text) {
  const std::string aside = path + ".tmp." + std::to_string(getpid());
  {
    std::ofstream file(aside, std::ios::binary);
    file << text;
    file.flush();
    if (!file) {
      std::error_code ignored;
      fs::remove(aside, ignored);
      return Error{path, "cannot be written", "a place with room that can be written", ""};
    }
  }
  std::error_code fault;
  fs::rename(aside, path, fault);
  if (!fault) return {};
  std::error_code ignored;
  fs::remove(aside, ignored);
  return Error{path, "cannot be written (" + fault.message() + ")", "", ""};
}

Result<std::string> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || fs::is_directory(path) || !(text << file.rdbuf())) {
    return Error{path, "cannot be read", "a readable, non-empty file", "check the path"};
  }
  return text.str();
}

}  // namespace phs
