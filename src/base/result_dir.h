// A result directory is complete or absent: written aside, then renamed into place.
#pragma once

#include <string>

#include "base/result.h"

namespace phs {

/// A directory being written. Destroyed without Commit(), it leaves nothing behind.
class ResultDir {
 public:
  /// Creates `final_path + ".partial.HOST.PID.N"` and the parents. Fails if `final_path` exists and
  /// `force` is false, if it holds the current directory, or if its parent cannot be written. What
  /// killed writers of the same directory left behind on this machine is removed.
  static Result<ResultDir> Create(const std::string& final_path, bool force);
  ResultDir(ResultDir&&) noexcept;
  ResultDir& operator=(ResultDir&&) noexcept;
  ResultDir(const ResultDir&) = delete;
  ResultDir& operator=(const ResultDir&) = delete;
  ~ResultDir();

  /// Path of a file inside the directory being written.
  std::string File(const std::string& name) const;
  const std::string& final_path() const { return final_path_; }
  /// Moves the directory into place, once; an old one is replaced only with force, in one step
  /// where the file system can.
  Status Commit();

 private:
  ResultDir(std::string path, std::string partial, bool force)
      : final_path_(std::move(path)), partial_(std::move(partial)), force_(force) {}
  std::string final_path_;
  std::string partial_;
  bool force_ = false;
};

/// Writes a text file aside and renames it (a pipe or device is written directly).
Status WriteFileAtomically(const std::string& path, const std::string& text);
/// The bytes of a file; empty for an empty one.
Result<std::string> ReadFile(const std::string& path);

}  // namespace phs
