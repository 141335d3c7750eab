#include "base/local_folder.h"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <utility>
#include <vector>

#include "base/disk.h"

namespace phs {
namespace {

std::string TemporaryRoot() {
  std::error_code fault;
  const auto root = std::filesystem::temp_directory_path(fault);
  return fault ? "/tmp" : root.string();
}

std::mutex mutex;
std::vector<std::string> all_made;  // of the process, with a slash; their names never come again

}  // namespace

LocalFolder::LocalFolder() : path_(TemporaryRoot() + "/phs_XXXXXX") {
  made_ = mkdtemp(path_.data()) != nullptr;
  if (!made_) {
    fault_ = errno;
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex);
  all_made.push_back(path_ + "/");
}

LocalFolder::LocalFolder(LocalFolder&& other) noexcept
    : path_(std::move(other.path_)),
      fault_(other.fault_),
      made_(std::exchange(other.made_, false)) {}

LocalFolder& LocalFolder::operator=(LocalFolder&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fault_, other.fault_);
  std::swap(made_, other.made_);
  return *this;
}

LocalFolder::~LocalFolder() {
  std::error_code ignored;
  if (made_) std::filesystem::remove_all(path_, ignored);
}

bool IsInLocalFolder(const std::string& path) {
  const std::lock_guard<std::mutex> lock(mutex);
  return std::any_of(all_made.begin(), all_made.end(),
                     [&](const std::string& folder) { return path.starts_with(folder); });
}

Status LocalFolder::status() const {
  if (fault_ == 0) return {};
  Error error = WriteFault(TemporaryRoot(), fault_);
  if (!IsDiskFault(error)) error.mend = "set TMPDIR";
  return error;
}

}  // namespace phs
