#include "sweep/worker_pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>

namespace phs::sweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kNoRun = -1;

/// What a worker answers: the run and, if its result could not be kept, why.
struct Answer {
  int run;
  char fault[500];
};

bool ReadAll(int file, void* to, std::size_t size) {
  char* at = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t got = read(file, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool WriteAll(int file, const void* from, std::size_t size) {
  const char* at = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t put = write(file, at, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    at += put;
    size -= static_cast<std::size_t>(put);
  }
  return true;
}

[[noreturn]] void Serve(int number, int orders, int answers, const PoolEvents& events) {
  // Ctrl-C reaches the whole group: the caller decides, and ends the workers.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int run = kNoRun; ReadAll(orders, &run, sizeof run);) {
    Answer answer{};
    answer.run = run;
    try {
      const Status status = events.work(run, number);
      if (!status.ok()) {
        std::strncpy(answer.fault, status.error().Line().c_str(), sizeof answer.fault - 1);
      }
    } catch (const std::exception& fault) {
      std::strncpy(answer.fault, fault.what(), sizeof answer.fault - 1);
    }
    if (!WriteAll(answers, &answer, sizeof answer)) break;
  }
  _exit(0);
}

struct Worker {
  pid_t process = -1;
  int orders = -1;   ///< written by us
  int answers = -1;  ///< read by us
  int run = kNoRun;
  bool over_time = false;
  Clock::time_point begun;
};

class Pool {
 public:
  Pool(const std::vector<int>& runs, const PoolOptions& options, const PoolEvents& events)
      : runs_(runs), options_(options), events_(events) {}
  ~Pool() {
    for (Worker& worker : workers_) End(&worker);
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  Result<bool> Execute() {
    const std::size_t count = std::min(static_cast<std::size_t>(options_.workers), runs_.size());
    workers_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (Status s = Start(i); !s.ok()) return s.error();
    }
    while (open_ > 0 || next_ < runs_.size()) {
      if (!events_.go_on()) return false;
      if (Status s = Wait(); !s.ok()) return s.error();
    }
    return true;
  }

 private:
  Status Start(std::size_t number) {
    int orders[2], answers[2];
    if (pipe(orders) != 0 || pipe(answers) != 0) return SystemFault("pipe");
    std::fflush(nullptr);
    Worker& worker = workers_[number];
    worker = {};
    worker.process = fork();
    if (worker.process < 0) return SystemFault("fork");
    if (worker.process == 0) {
      // Ends of the other workers' pipes must not stay open here.
      for (const Worker& other : workers_) {
        if (other.orders >= 0) close(other.orders);
        if (other.answers >= 0) close(other.answers);
      }
      close(orders[1]);
      close(answers[0]);
      Serve(static_cast<int>(number), orders[0], answers[1], events_);
    }
    close(orders[0]);
    close(answers[1]);
    worker.orders = orders[1];
    worker.answers = answers[0];
    Order(&worker);
    return {};
  }

  static Status SystemFault(const char* what) {
    return Error{what, std::strerror(errno), "", "use fewer workers"};
  }

  void Order(Worker* worker) {
    worker->run = kNoRun;
    worker->over_time = false;
    if (next_ >= runs_.size()) return;
    worker->run = runs_[next_++];
    worker->begun = Clock::now();
    ++open_;
    // A worker that has just died shows when its answer is read.
    (void)WriteAll(worker->orders, &worker->run, sizeof worker->run);
  }

  Status Wait() {
    std::vector<pollfd> polled;
    for (const Worker& worker : workers_) polled.push_back({worker.answers, POLLIN, 0});
    poll(polled.data(), polled.size(), 100);
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      Worker& worker = workers_[i];
      if ((polled[i].revents & (POLLIN | POLLHUP)) != 0) {
        if (Status s = Receive(i); !s.ok()) return s;
      } else if (worker.run != kNoRun && !worker.over_time &&
                 Clock::now() - worker.begun >
                     std::chrono::duration<double>(options_.time_limit_s)) {
        worker.over_time = true;
        kill(worker.process, SIGKILL);
      }
    }
    return {};
  }

  Status Receive(std::size_t number) {
    Worker& worker = workers_[number];
    Answer answer{};
    if (ReadAll(worker.answers, &answer, sizeof answer)) {
      if (answer.fault[0] != '\0') return Error{"", answer.fault, "", ""};
      --open_;
      Order(&worker);
      return events_.done(answer.run, nullptr);
    }
    return Bury(number);
  }

  /// The worker is dead: its run is lost, a new one takes its place.
  Status Bury(std::size_t number) {
    Worker& worker = workers_[number];
    int state = 0;
    const bool over_time = worker.over_time;
    LostRun lost{worker.run, {}};
    waitpid(worker.process, &state, 0);
    if (over_time) {
      lost.reason = fmt::format("ended after its time limit of {:g} s", options_.time_limit_s);
    } else if (WIFSIGNALED(state)) {
      lost.reason = fmt::format("its process was ended by signal {} ({})", WTERMSIG(state),
                                strsignal(WTERMSIG(state)));
    } else {
      lost.reason = fmt::format("its process ended with exit code {}", WEXITSTATUS(state));
    }
    close(worker.orders);
    close(worker.answers);
    worker = {};
    if (lost.run != kNoRun) {
      --open_;
      if (Status s = events_.done(lost.run, &lost); !s.ok()) return s;
    }
    return Start(number);
  }

  static void End(Worker* worker) {
    if (worker->process <= 0) return;
    kill(worker->process, SIGKILL);
    waitpid(worker->process, nullptr, 0);
    close(worker->orders);
    close(worker->answers);
    *worker = {};
  }

  const std::vector<int>& runs_;
  const PoolOptions& options_;
  const PoolEvents& events_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0;
  int open_ = 0;
};

}  // namespace

Result<bool> RunPool(const std::vector<int>& runs, const PoolOptions& options,
                     const PoolEvents& events) {
  // A worker's death must not end the caller when it is given an order.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  Result<bool> all = Pool(runs, options, events).Execute();
  std::signal(SIGPIPE, before);
  return all;
}

}  // namespace phs::sweep
