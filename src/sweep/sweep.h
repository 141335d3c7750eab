// A sweep from start to result: a working directory that survives, the runs, the result directory.
//
// DIR.unfinished/ holds the study, a lock and runs/NNNNNN.json while work goes on; a sweep that is
// stopped or killed is continued from there. When every run has its record, sweep.csv, index.sqlite
// and study.yaml are written and the directory becomes DIR, in one rename.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "sweep/run_case.h"
#include "sweep/study.h"

namespace phs::sweep {

/// FINAL_PATH.unfinished.
std::string UnfinishedPath(std::string final_path);
/// Runs without a record in that directory, or with one of status "killed" when `repeat_killed`.
std::vector<int> MissingRuns(const Study& study, const std::string& path, bool repeat_killed);

/// The working directory, locked for this process.
class WorkDir {
 public:
  /// Creates DIR.unfinished, or takes up the one that is there when `resume`. Refused: a finished
  /// DIR or an unfinished sweep without `force`/`resume`, one of another study, one in use.
  static Result<WorkDir> Open(const std::string& final_path, const Study& study, bool resume,
                              bool force);
  /// An existing working directory, shared: for tasks on other machines.
  static Result<WorkDir> Join(const std::string& final_path, const Study& study);
  WorkDir(WorkDir&& other) noexcept;
  WorkDir& operator=(WorkDir&&) = delete;
  ~WorkDir();

  const std::string& path() const { return path_; }
  const std::string& final_path() const { return final_path_; }
  std::string File(const std::string& name) const { return path_ + "/" + name; }
  /// Runs that have no record yet, or one of status "killed" when `repeat_killed`.
  std::vector<int> Missing(const Study& study, bool repeat_killed) const;
  /// Removes the runs' files, and renames to the final path.
  Status Finish();
  /// In a forked child: the lock stays with the parent alone.
  void ReleaseInChild();

 private:
  WorkDir(std::string path, std::string final_path, int lock, bool force)
      : path_(std::move(path)), final_path_(std::move(final_path)), lock_(lock), force_(force) {}
  std::string path_, final_path_;
  int lock_ = -1;
  bool force_ = false;
};

using Progress = std::function<bool(int done, int of)>;

/// Makes `runs` with worker processes, their files in `scratch`. False: stopped by `progress`.
Result<bool> MakeRuns(const Study& study, const std::vector<int>& runs, int workers,
                      const std::string& scratch, WorkDir* work, const Progress& progress);

/// Makes the missing runs on this machine.
Result<bool> RunLocally(const Study& study, int workers, WorkDir* work, const Progress& progress);

/// All records in order of the runs. @pre none is missing
std::vector<RunRecord> ReadRecords(const Study& study, const WorkDir& work);

/// sweep.csv, index.sqlite, study.yaml in the working directory.
Status WriteTables(const Study& study, const std::vector<RunRecord>& records, const WorkDir& work);

}  // namespace phs::sweep
