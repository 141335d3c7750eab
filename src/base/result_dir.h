// A result directory is complete or absent: written aside, then renamed into place.
//
// Each result holds a list of its files (kResultMark). By it a former result is known again: only
// that is replaced by force, and only when it holds nothing that someone else has put there.
#pragma once

#include <string>

#include "base/disk.h"
#include "base/result.h"

namespace phs {

/// The list of a result's files, in the result.
inline constexpr char kResultMark[] = ".phs_result";

/// Success if `path` may be replaced: a former result with its own files alone, or an empty
/// directory. The error says what is there otherwise.
Status CheckFormerResult(const std::string& path);

/// A file that was written into a result afterwards belongs to it from then on, so that force
/// replaces it, too. Does nothing where its folder is no result.
Status AdoptIntoResult(const std::string& file);

/// A directory being written. Destroyed without Commit(), it leaves nothing behind.
class ResultDir {
 public:
  /// Creates `final_path + ".partial.HOST.PID.N"` and the parents. Fails if `final_path` exists and
  /// is no former result or `force` is false, if it holds the current directory, or if its parent
  /// cannot be written. What killed writers of the same directory left behind on this machine is
  /// removed; a former result that one had put aside is put back.
  static Result<ResultDir> Create(const std::string& final_path, bool force);
  ResultDir(ResultDir&&) noexcept;
  ResultDir& operator=(ResultDir&&) noexcept;
  ResultDir(const ResultDir&) = delete;
  ResultDir& operator=(const ResultDir&) = delete;
  ~ResultDir();

  /// Only the last of this: what killed writers of `final_path` left behind.
  static void RemoveAbandoned(const std::string& final_path);

  /// Path of a file inside the directory being written.
  std::string File(const std::string& name) const;
  const std::string& final_path() const { return final_path_; }
  /// Lists the files, waits until they are on the disk and moves the directory into place, once.
  /// A former result is replaced only with force, in one step where the file system can, and
  /// removed when the new one stands. After an error all is as it was before.
  Status Commit();

 private:
  ResultDir(std::string path, std::string partial, bool force)
      : final_path_(std::move(path)), partial_(std::move(partial)), force_(force) {}
  Status Replace();
  std::string Parent() const;
  std::string final_path_;
  std::string partial_;
  bool force_ = false;
};

/// The bytes of a file; empty for an empty one.
Result<std::string> ReadFile(const std::string& path);

}  // namespace phs
