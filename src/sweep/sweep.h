// A sweep from start to result: a working directory that survives, the runs, the result directory.
//
// DIR.unfinished/ holds the plan, a lock and runs/NNNNNN.json while work goes on; a sweep that is
// stopped or killed, at whatever place, is continued from there. The plan holds a digest of every
// input file (study_inputs.h). When every run has its record, the result is written beside
// (ResultDir) and becomes DIR in one rename; then DIR.unfinished/ goes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result_dir.h"
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
  /// DIR or an unfinished sweep without `force`/`resume`, with `force` a DIR that is no former
  /// result, a sweep of another study or with changed inputs, one in use.
  static Result<WorkDir> Open(const std::string& final_path, const Study& study, bool resume,
                              bool force);
  /// An existing working directory, shared: for tasks on other machines.
  static Result<WorkDir> Join(const std::string& final_path, const Study& study);
  WorkDir(WorkDir&& other) noexcept;
  WorkDir& operator=(WorkDir&&) = delete;
  ~WorkDir();

  /// What a working directory may hold, the plan first: without it there is nothing to resume.
  static constexpr const char* kParts[] = {"plan.txt", "runs",           "scratch",
                                           "slurm",    "candidates.txt", "lock"};
  /// What a finished sweep has left, to be removed.
  static WorkDir Leftover(const std::string& path, int lock) { return {path, "", lock, false}; }
  /// Removes it; what is not a sweep's stays.
  void Remove() const;

  const std::string& path() const { return path_; }
  const std::string& final_path() const { return final_path_; }
  std::string File(const std::string& name) const { return path_ + "/" + name; }
  /// Runs that have no record yet, or one of status "killed" when `repeat_killed`.
  std::vector<int> Missing(const Study& study, bool repeat_killed) const;
  /// A directory for the result. Refused if an input file has changed since the sweep was begun.
  Result<ResultDir> OpenResult() const;
  /// Puts the result into place and removes the working directory.
  Status Finish(ResultDir* result);
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

/// sweep.csv, index.sqlite, study.yaml, plan.txt.
Status WriteTables(const Study& study, const std::vector<RunRecord>& records, const WorkDir& work,
                   const ResultDir& result);

/// True if FINAL_PATH is the result of this very study with these inputs: a sweep was killed after
/// the result stood. What is left of its working directory is removed.
bool IsFinished(const std::string& final_path, const Study& study);

}  // namespace phs::sweep
