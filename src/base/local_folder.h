// A folder on this machine (TMPDIR) for files that nobody else needs. Its name cannot be guessed,
// it belongs to this user alone, and it is removed at the end.
#pragma once

#include <string>

#include "base/result.h"

namespace phs {

class LocalFolder {
 public:
  LocalFolder();
  LocalFolder(LocalFolder&& other) noexcept;
  LocalFolder& operator=(LocalFolder&& other) noexcept;
  LocalFolder(const LocalFolder&) = delete;
  LocalFolder& operator=(const LocalFolder&) = delete;
  ~LocalFolder();

  /// Why it could not be made.
  Status status() const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int fault_ = 0;  ///< errno
  bool made_ = false;
};

/// True for a file in a LocalFolder that this process has made, also where it could not be removed.
bool IsInLocalFolder(const std::string& path);

}  // namespace phs
