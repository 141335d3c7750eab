// A folder on this machine (TMPDIR) for files that nobody else needs; removed at the end.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "base/result.h"

namespace phs::sweep {

class LocalFolder {
 public:
  LocalFolder() : path_((std::filesystem::temp_directory_path() / "phs_sweep_XXXXXX").string()) {
    made_ = mkdtemp(path_.data()) != nullptr;
  }
  ~LocalFolder() {
    std::error_code ignored;
    if (made_) std::filesystem::remove_all(path_, ignored);
  }
  LocalFolder(const LocalFolder&) = delete;
  LocalFolder& operator=(const LocalFolder&) = delete;

  Status status() const {
    if (made_) return {};
    return Error{std::filesystem::temp_directory_path().string(), "cannot be written", "",
                 "set TMPDIR"};
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool made_ = false;
};

}  // namespace phs::sweep
