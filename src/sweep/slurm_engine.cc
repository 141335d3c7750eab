#include "sweep/slurm_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "base/result_dir.h"
#include "base/words.h"
#include "sweep/slurm_batches.h"
#include "sweep/slurm_client.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// So many tasks lost in a row without a single record: something is wrong with all of them.
constexpr int kFutileTasks = 10;
/// Slurm may be silent for so long (its controller restarts) before waiting ends [s].
constexpr double kPatience = 600;

std::string LastLine(const std::string& path) {
  const auto text = ReadFile(path);
  if (!text.ok()) return "";
  std::istringstream lines(text.value());
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

/// One task that was submitted and has not been settled.
struct OpenTask {
  SlurmTask id;
  Runs runs;
  int absent = 0;          ///< answers in a row in which Slurm did not run it
  std::string last_state;  ///< "" if Slurm never named one
};

class SlurmSweep {
 public:
  SlurmSweep(const Study& study, const SlurmOptions& options, WorkDir* work,
             const Progress& progress)
      : study_(study),
        options_(options),
        work_(work),
        progress_(progress),
        folder_(fs::absolute(work->File("slurm")).string()),
        done_(static_cast<std::size_t>(study.num_runs()), false) {}

  Result<SlurmOutcome> Execute() {
    if (Status s = Prepare(); !s.ok()) return s.error();
    for (;;) {
      if (Status s = SubmitWhatFits(); !s.ok()) return s.error();
      if (num_done_ == study_.num_runs()) return SlurmOutcome{.all = true, .jobs = {}};
      if (!options_.wait || !progress_(num_done_, study_.num_runs()) || !Pause()) {
        return SlurmOutcome{.all = false, .jobs = Jobs()};
      }
      if (Status s = Look(); !s.ok()) return s.error();
    }
  }

 private:
  /// A file in the folder of the engine; the path is absolute, for tasks begin elsewhere.
  std::string File(const std::string& name) const { return folder_ + "/" + name; }

  bool MarkIfDone(int run) {
    const auto at = static_cast<std::size_t>(run);
    if (done_[at]) return true;
    if (!ReadRecord(study_, work_->path(), run)) return false;
    done_[at] = true;
    ++num_done_;
    return true;
  }

  Status Prepare() {
    const auto most = MostTasksPerArray();
    if (!most.ok()) return most.error();
    most_per_array_ = most.value();
    std::error_code fault;
    fs::create_directories(folder_, fault);
    if (fault) return WriteFault(folder_, fault.value());
    if (Status s = WriteScript(); !s.ok()) return s;
    if (Status s = TakeUpJobs(); !s.ok()) return s;
    std::set<int> under_way;
    for (const OpenTask& task : open_) under_way.insert(task.runs.begin(), task.runs.end());
    Runs missing;
    for (int run : work_->Missing(study_, true)) {
      fs::remove(RecordPath(work_->path(), run), fault);  // of a killed run: it is made again
      if (under_way.count(run) == 0) missing.push_back(run);
    }
    for (int run = 0; run < study_.num_runs(); ++run) MarkIfDone(run);
    waiting_ = Chunks(missing, ChunkSize(options_, missing.size()));
    return {};
  }

  Status WriteScript() const {
    std::error_code fault;
    const std::string program = fs::read_symlink("/proc/self/exe", fault).string();
    return WriteFileAtomically(
        File("task.sh"),
        fmt::format("#!/bin/sh\nexec {} sweep {} --quiet --out {} --slurm-task \"$1\"\n",
                    ShellWord(program), ShellWord(fs::absolute(study_.path).string()),
                    ShellWord(fs::absolute(work_->final_path()).string())));
  }

  /// Arrays of an earlier call: their tasks that Slurm still runs are waited for.
  Status TakeUpJobs() {
    const auto list = ReadFile(File("jobs.txt"));
    if (!list.ok()) return {};  // none was submitted
    const auto states = TaskStates();
    if (!states.ok()) return states.error();
    jobs_text_ = list.value();
    std::istringstream lines(jobs_text_);
    std::string job, batch;
    while (lines >> job >> batch) {
      ++num_batches_;
      const auto tasks = ReadBatch(File(batch));
      if (!tasks.ok()) return tasks.error();
      for (std::size_t i = 0; i < tasks.value().size(); ++i) {
        const SlurmTask id{job, static_cast<int>(i)};
        const auto state = states.value().find(id);
        if (state == states.value().end() || IsOver(state->second)) continue;
        open_.push_back({id, tasks.value()[i], 0, state->second});
      }
    }
    return {};
  }

  Status SubmitWhatFits() {
    while (!waiting_.empty()) {
      const int room = options_.queued_tasks - static_cast<int>(open_.size());
      const int count = std::min({room, most_per_array_, static_cast<int>(waiting_.size())});
      if (count < 1) return {};
      if (Status s = SubmitArray(count); !s.ok()) {
        // A full queue empties by itself while something is under way.
        return open_.empty() ? s : Status();
      }
    }
    return {};
  }

  Status SubmitArray(int count) {
    std::vector<Runs> tasks(waiting_.begin(), waiting_.begin() + count);
    const std::string batch = fmt::format("batch_{:03}.txt", num_batches_);
    if (Status s = WriteFileAtomically(File(batch), BatchText(tasks)); !s.ok()) return s;
    const auto job = Submit(RequestFor(study_, options_, folder_, batch, count));
    if (!job.ok()) return job.error();
    ++num_batches_;
    jobs_text_ += job.value() + " " + batch + "\n";
    waiting_.erase(waiting_.begin(), waiting_.begin() + count);
    for (int i = 0; i < count; ++i) {
      open_.push_back({{job.value(), i}, std::move(tasks[static_cast<std::size_t>(i)]), 0, ""});
    }
    wait_s_ = kShortestWait;
    return WriteFileAtomically(File("jobs.txt"), jobs_text_);
  }

  /// False: the user wants to stop.
  bool Pause() {
    const auto until = Clock::now() + std::chrono::duration<double>(wait_s_);
    while (Clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      if (!progress_(num_done_, study_.num_runs())) return false;
    }
    wait_s_ = std::min(1.3 * wait_s_, kLongestWait);
    return true;
  }

  Status Look() {
    const auto states = TaskStates();
    const auto now = Clock::now();
    if (!states.ok()) {
      // Silence tells nothing about the tasks.
      if (now - heard_ < std::chrono::duration<double>(kPatience)) return {};
      Error error = states.error();
      error.mend = "the jobs stay in the queue";
      return error;
    }
    heard_ = now;
    std::vector<OpenTask> still_open;
    std::vector<OpenTask> ended;
    for (OpenTask& task : open_) {
      const auto state = states.value().find(task.id);
      const bool known = state != states.value().end();
      if (known) task.last_state = state->second;
      task.absent = known && !IsOver(state->second) ? 0 : task.absent + 1;
      for (int run : task.runs) MarkIfDone(run);
      // Twice: a record may reach this machine a moment after Slurm's word.
      (task.absent >= 2 ? ended : still_open).push_back(std::move(task));
    }
    open_ = std::move(still_open);
    for (OpenTask& task : ended) {
      if (Status s = Settle(&task); !s.ok()) return s;
    }
    return {};
  }

  /// A task that Slurm no longer runs: what it did not make is submitted again.
  Status Settle(OpenTask* task) {
    const std::size_t before = task->runs.size();
    std::erase_if(task->runs, [&](int run) { return MarkIfDone(run); });
    if (task->runs.empty()) {
      futile_ = 0;
      return {};
    }
    futile_ = task->runs.size() < before ? 0 : futile_ + 1;
    const std::string log = File(fmt::format("{}_{}.log", task->id.first, task->id.second));
    if (futile_ >= kFutileTasks) {
      return Error{"Slurm",
                   fmt::format("{} tasks in a row left no result; the last was {}: {}", futile_,
                               Words(*task), Quoted(LastLine(log))),
                   "", "see " + log};
    }
    const int at_work = task->runs.front();
    if (++lost_[at_work] >= options_.attempts) {
      const std::string last = LastLine(log);
      const std::string reason =
          fmt::format("its Slurm task was lost {} times, at last as {}{}", options_.attempts,
                      Words(*task), last.empty() ? "" : ": " + Quoted(last));
      if (Status s = WriteRecord(KilledRun(study_, at_work, reason), work_->path()); !s.ok()) {
        return s;
      }
      MarkIfDone(at_work);
      task->runs.erase(task->runs.begin());
    }
    if (!task->runs.empty()) waiting_.push_back(std::move(task->runs));
    return {};
  }

  static std::string Words(const OpenTask& task) {
    return fmt::format("{}_{} ({})", task.id.first, task.id.second,
                       task.last_state.empty() ? "no state known" : task.last_state);
  }

  std::vector<std::string> Jobs() const {
    std::set<std::string> jobs;
    for (const OpenTask& task : open_) jobs.insert(task.id.first);
    return {jobs.begin(), jobs.end()};
  }

  static constexpr double kShortestWait = 0.2, kLongestWait = 5;  // [s] between two looks

  const Study& study_;
  const SlurmOptions& options_;
  WorkDir* work_;
  const Progress& progress_;
  std::string folder_;
  std::vector<bool> done_;
  int num_done_ = 0;
  int most_per_array_ = 1;
  int num_batches_ = 0;
  int futile_ = 0;
  std::string jobs_text_;
  std::deque<Runs> waiting_;  ///< to be submitted
  std::vector<OpenTask> open_;
  std::map<int, int> lost_;  ///< run -> how often its task was lost while it was at work
  double wait_s_ = kShortestWait;
  Clock::time_point heard_ = Clock::now();
};

}  // namespace

Result<SlurmPlan> PlanOnSlurm(const Study& study, const SlurmOptions& options,
                              const std::string& final_path) {
  const auto most = MostTasksPerArray();
  if (!most.ok()) return most.error();
  SlurmPlan plan;
  const std::string path = fs::absolute(UnfinishedPath(final_path)).string();
  const Runs missing = MissingRuns(study, path, true);
  plan.runs = static_cast<int>(missing.size());
  plan.chunk = ChunkSize(options, missing.size());
  plan.tasks = static_cast<int>(Chunks(missing, plan.chunk).size());
  const int per_array = std::max(1, std::min({most.value(), options.queued_tasks, plan.tasks}));
  plan.arrays = (plan.tasks + per_array - 1) / per_array;
  plan.command =
      SubmitCommand(RequestFor(study, options, path + "/slurm", "batch_000.txt", per_array));
  return plan;
}

Result<SlurmOutcome> RunOnSlurm(const Study& study, const SlurmOptions& options, WorkDir* work,
                                const Progress& progress) {
  return SlurmSweep(study, options, work, progress).Execute();
}

}  // namespace phs::sweep
