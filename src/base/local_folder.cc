#include "base/local_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <utility>

#include "base/disk.h"

namespace phs {
namespace {

std::string TemporaryRoot() {
  std::error_code fault;
  const auto root = std::filesystem::temp_directory_path(fault);
  return fault ? "/tmp" : root.string();
}

}  // namespace

LocalFolder::LocalFolder() : path_(TemporaryRoot() + "/phs_XXXXXX") {
  made_ = mkdtemp(path_.data()) != nullptr;
  if (!made_) fault_ = errno;
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

Status LocalFolder::status() const {
  if (fault_ == 0) return {};
  Error error = WriteFault(TemporaryRoot(), fault_);
  if (!IsDiskFault(error)) error.mend = "set TMPDIR";
  return error;
}

}  // namespace phs
