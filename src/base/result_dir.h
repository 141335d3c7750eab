// A result directory is complete or absent: written aside, then renamed into place.
#pragma once

#include <string>

#include "base/result.h"

namespace phs {

/// A directory being written. Destroyed without Commit(), it leaves nothing behind.
class ResultDir {
 public:
  /// Creates `final_path + ".partial.<pid>"`. Fails if `final_path` exists and `force` is false, or
  /// if its parent cannot be written.
  static Result<ResultDir> Create(const std::string& final_path, bool force);
  ResultDir(ResultDir&&) noexcept;
  ResultDir& operator=(ResultDir&&) noexcept;
  ResultDir(const ResultDir&) = delete;
  ResultDir& operator=(const ResultDir&) = delete;
  ~ResultDir();

  /// Path of a file inside the directory being written.
  std::string File(const std::string& name) const;
  const std::string& final_path() const { return final_path_; }
  /// Moves the directory into place (replacing an old one only with force).
  Status Commit();

 private:
  ResultDir(std::string path, std::string partial, bool force)
      : final_path_(std::move(path)), partial_(std::move(partial)), force_(force) {}
  std::string final_path_;
  std::string partial_;
  bool force_ = false;
};

/// Writes a text file aside and renames it.
Status WriteFileAtomically(const std::string& path, const std::string& text);
Result<std::string> ReadFile(const std::string& path);

}  // namespace phs
