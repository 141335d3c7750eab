#include "sweep/sweep.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/result_dir.h"
#include "sweep/result_store.h"
#include "sweep/worker_pool.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;

/// Everything that decides the runs: the study and the laid-out values. Other results would follow
/// from another text.
std::string Fingerprint(const Study& study) {
  std::string text = study.text;
  for (const StudyCase& c : study.cases) {
    const auto base = ReadFile(c.scenario);
    text += "\n# base scenario\n" + (base.ok() ? base.value() : "");
  }
  text += "\n# runs\n";
  for (const auto& run : study.runs) text += fmt::format("{}\n", fmt::join(run, ","));
  return text;
}

Result<int> Lock(const std::string& path) {
  const std::string file = path + "/lock";
  const int lock = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) return Error{file, std::strerror(errno), "", "choose another directory"};
  if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    close(lock);
    return Error{path, "is in use by another sweep", "", "wait for it, or choose another --out"};
  }
  return lock;
}

Status CheckPlaces(const std::string& final_path, const std::string& path, bool resume,
                   bool force) {
  std::error_code ignored;
  if (fs::exists(final_path, ignored) && !force) {
    return Error{final_path, "exists already", "a new directory", "use --force to replace it"};
  }
  const bool unfinished = fs::exists(path + "/plan.txt", ignored);
  if (resume && !unfinished) {
    return Error{path, "holds no unfinished sweep", "", "start it without --resume"};
  }
  if (unfinished && !resume && !force) {
    return Error{path, "holds an unfinished sweep", "",
                 "--resume continues it, --force starts anew"};
  }
  return {};
}

Status CheckSameStudy(const std::string& path, const Study& study) {
  const auto before = ReadFile(path + "/plan.txt");
  if (before.ok() && before.value() == Fingerprint(study)) return {};
  return Error{path, "belongs to another study, or the study or its scenario has changed since", "",
               "--force starts anew"};
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
  fs::create_directories(path + "/runs", fault);
  if (fault) return Error{path, fault.message(), "", "choose another directory"};
  const auto lock = Lock(path);
  if (!lock.ok()) return lock.error();
  WorkDir work(path, final_path, lock.value(), force);
  if (resume) {
    if (Status s = CheckSameStudy(path, study); !s.ok()) return s.error();
    return work;
  }
  fs::remove_all(path + "/runs", fault);
  fs::remove(work.File("candidates.txt"), fault);
  fs::create_directories(path + "/runs", fault);
  if (Status s = WriteFileAtomically(work.File("plan.txt"), Fingerprint(study)); !s.ok()) {
    return s.error();
  }
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

Status WorkDir::Finish() {
  std::error_code fault;
  for (const char* name : {"runs", "scratch", "slurm", "plan.txt", "candidates.txt", "lock"}) {
    fs::remove_all(File(name), fault);
  }
  if (force_) fs::remove_all(final_path_, fault);
  fs::rename(path_, final_path_, fault);
  if (fault) return Error{final_path_, fault.message(), "", "the results are in " + path_};
  return {};
}

Result<bool> MakeRuns(const Study& study, const std::vector<int>& runs, int workers,
                      const std::string& scratch, WorkDir* work, const Progress& progress) {
  int done = study.num_runs() - static_cast<int>(runs.size());
  PoolEvents events;
  events.work = [&](int run, int worker) {
    work->ReleaseInChild();
    return WriteRecord(RunCase(study, run, fmt::format("{}/{}", scratch, worker)), work->path());
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

Status WriteTables(const Study& study, const std::vector<RunRecord>& records, const WorkDir& work) {
  if (Status s = WriteSweepCsv(study, records, work.File("sweep.csv")); !s.ok()) return s;
  std::error_code ignored;
  fs::remove(work.File("index.sqlite"), ignored);
  if (Status s = WriteIndex(study, records, work.File("index.sqlite")); !s.ok()) return s;
  return WriteFileAtomically(work.File("study.yaml"), study.text);
}

}  // namespace phs::sweep
