#include "sweep/sweep.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>

#include "base/result_dir.h"
#include "sweep/result_store.h"
#include "sweep/study_inputs.h"
#include "sweep/worker_pool.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;

constexpr char kPlan[] = "plan.txt";

Result<int> Lock(const std::string& path) {
  const std::string file = path + "/lock";
  const int lock = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) return WriteFault(file, errno);
  if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    close(lock);
    return Error{path, "is in use by another sweep", "", "wait for it, or choose another --out"};
  }
  return lock;
}

/// A file that was being written when the program was killed (disk.h).
bool IsHalfWritten(const std::string& name) { return name.find(".tmp.") != std::string::npos; }

/// Nothing but what a sweep leaves in its working directory.
Status CheckIsWorkDir(const std::string& path) {
  std::error_code fault;
  for (const auto& entry : fs::directory_iterator(path, fault)) {
    const std::string name = entry.path().filename().string();
    const auto& known = WorkDir::kParts;
    const bool own = std::find(std::begin(known), std::end(known), name) != std::end(known) ||
                     IsHalfWritten(name);
    if (own) continue;
    return Error{path, "is no working directory of a sweep: it holds '" + name + "'", "",
                 "choose another --out, or remove it yourself"};
  }
  return {};
}

Status CheckPlaces(const std::string& final_path, const std::string& path, bool resume,
                   bool force) {
  std::error_code ignored;
  const bool unfinished = fs::exists(path + "/" + kPlan, ignored);
  if (resume && !unfinished) {
    return Error{path, "holds no unfinished sweep", "", "start it without --resume"};
  }
  if (fs::exists(fs::symlink_status(final_path, ignored))) {
    if (!force) {
      return Error{final_path, "exists already", "a new directory", "use --force to replace it"};
    }
    if (Status s = CheckFormerResult(final_path); !s.ok()) return s;
  }
  if (unfinished && !resume && !force) {
    return Error{path, "holds an unfinished sweep", "",
                 "--resume continues it, --force starts anew"};
  }
  return resume ? Status() : CheckIsWorkDir(path);
}

Status CheckSameStudy(const std::string& path, const Study& study) {
  const auto before = ReadFile(path + "/" + kPlan);
  if (!before.ok()) return before.error();
  if (Status s = CheckInputs(before.value()); !s.ok()) return s;
  if (before.value() == PlanText(study)) return {};
  return Error{path, "belongs to another study, or the study has changed since", "",
               "--force starts anew"};
}

/// An empty place for runs, and only then the plan: with it the sweep can be resumed.
Status BeginAnew(const WorkDir& work, const Study& study) {
  std::error_code fault;
  for (const char* name : {kPlan, "runs", "scratch", "slurm", "candidates.txt"}) {
    fs::remove_all(work.File(name), fault);
    if (fault) return WriteFault(work.File(name), fault.value());
  }
  fs::create_directory(work.File("runs"), fault);
  if (fault) return WriteFault(work.File("runs"), fault.value());
  if (Status s = SyncFolder(work.path()); !s.ok()) return s;
  return WriteFileAtomically(work.File(kPlan), PlanText(study));
}

}  // namespace

std::string UnfinishedPath(std::string path) {
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path + ".unfinished";
}

std::vector<int> MissingRuns(const Study& study, const std::string& path, bool repeat_killed) {
  std::vector<int> missing;
  for (int run = 0; run < study.num_runs(); ++run) {
    const auto record = ReadRecord(study, path, run);
    if (!record || (repeat_killed && record->status == "killed")) missing.push_back(run);
  }
  return missing;
}

Result<WorkDir> WorkDir::Open(const std::string& final_path, const Study& study, bool resume,
                              bool force) {
  const std::string path = UnfinishedPath(final_path);
  if (Status s = CheckPlaces(final_path, path, resume, force); !s.ok()) return s.error();
  std::error_code fault;
  fs::create_directories(path, fault);
  if (fault) return WriteFault(path, fault.value());
  if (Status s = SyncFolder(fs::path(path).parent_path().string()); !s.ok()) return s.error();
  const auto lock = Lock(path);
  if (!lock.ok()) return lock.error();
  WorkDir work(path, final_path, lock.value(), force);
  if (resume) {
    if (Status s = CheckSameStudy(path, study); !s.ok()) return s.error();
    fs::create_directory(work.File("runs"), fault);
    return work;
  }
  if (Status s = BeginAnew(work, study); !s.ok()) return s.error();
  return work;
}

Result<WorkDir> WorkDir::Join(const std::string& final_path, const Study& study) {
  const std::string path = UnfinishedPath(final_path);
  if (Status s = CheckSameStudy(path, study); !s.ok()) return s.error();
  return WorkDir(path, final_path, -1, false);
}

WorkDir::WorkDir(WorkDir&& other) noexcept
    : path_(std::move(other.path_)),
      final_path_(std::move(other.final_path_)),
      lock_(other.lock_),
      force_(other.force_) {
  other.lock_ = -1;
}

WorkDir::~WorkDir() { ReleaseInChild(); }

void WorkDir::ReleaseInChild() {
  if (lock_ >= 0) close(lock_);
  lock_ = -1;
}

std::vector<int> WorkDir::Missing(const Study& study, bool repeat_killed) const {
  return MissingRuns(study, path_, repeat_killed);
}

Result<ResultDir> WorkDir::OpenResult() const {
  const auto plan = ReadFile(File(kPlan));
  if (!plan.ok()) return plan.error();
  if (Status s = CheckInputs(plan.value()); !s.ok()) return s.error();
  return ResultDir::Create(final_path_, force_);
}

Status WorkDir::Finish(ResultDir* result) {
  if (Status s = result->Commit(); !s.ok()) {
    Error error = s.error();
    error.mend += (error.mend.empty() ? "" : "; ") +
                  std::string("the runs are kept: --resume writes the result");
    return error;
  }
  Remove();
  return {};
}

void WorkDir::Remove() const {
  std::error_code ignored;
  for (const char* name : kParts) fs::remove_all(File(name), ignored);
  std::vector<fs::path> half_written;
  for (const auto& entry : fs::directory_iterator(path_, ignored)) {
    if (IsHalfWritten(entry.path().filename().string())) half_written.push_back(entry.path());
  }
  for (const fs::path& file : half_written) fs::remove(file, ignored);
  fs::remove(path_, ignored);  // not if someone has put something there
}

Result<bool> MakeRuns(const Study& study, const std::vector<int>& runs, int workers,
                      const std::string& scratch, WorkDir* work, const Progress& progress) {
  int done = study.num_runs() - static_cast<int>(runs.size());
  PoolEvents events;
  events.work = [&](int run, int worker) {
    work->ReleaseInChild();
    const auto record = RunCase(study, run, fmt::format("{}/{}", scratch, worker));
    return record.ok() ? WriteRecord(record.value(), work->path()) : Status(record.error());
  };
  events.done = [&](int run, const LostRun* lost) -> Status {
    ++done;
    if (lost == nullptr) return {};
    return WriteRecord(KilledRun(study, run, lost->reason), work->path());
  };
  events.go_on = [&] { return progress(done, study.num_runs()); };
  return RunPool(runs, {.workers = workers, .time_limit_s = study.time_limit_s}, events);
}

Result<bool> RunLocally(const Study& study, int workers, WorkDir* work, const Progress& progress) {
  return MakeRuns(study, work->Missing(study, true), workers, work->File("scratch"), work,
                  progress);
}

std::vector<RunRecord> ReadRecords(const Study& study, const WorkDir& work) {
  std::vector<RunRecord> records;
  for (int run = 0; run < study.num_runs(); ++run) {
    auto record = ReadRecord(study, work.path(), run);
    PHS_CHECK(record.has_value());
    records.push_back(std::move(*record));
  }
  return records;
}

Status WriteTables(const Study& study, const std::vector<RunRecord>& records, const WorkDir& work,
                   const ResultDir& result) {
  if (Status s = WriteSweepCsv(study, records, result.File("sweep.csv")); !s.ok()) return s;
  if (Status s = WriteIndex(study, records, result.File("index.sqlite")); !s.ok()) return s;
  const auto plan = ReadFile(work.File(kPlan));
  if (!plan.ok()) return plan.error();
  if (Status s = WriteFileAtomically(result.File(kPlan), plan.value()); !s.ok()) return s;
  return WriteFileAtomically(result.File("study.yaml"), study.text);
}

bool IsFinished(const std::string& final_path, const Study& study) {
  const auto plan = ReadFile(final_path + "/" + kPlan);
  if (!plan.ok() || plan.value() != PlanText(study) || !CheckFormerResult(final_path).ok()) {
    return false;
  }
  ResultDir::RemoveAbandoned(final_path);
  const std::string path = UnfinishedPath(final_path);
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return true;
  const auto left = ReadFile(path + "/" + kPlan);
  if (left.ok() && left.value() != plan.value()) return false;
  const auto lock = Lock(path);
  if (!lock.ok()) return false;
  WorkDir::Leftover(path, lock.value()).Remove();
  return true;
}

}  // namespace phs::sweep
