// Worker processes on this machine. Each takes one run at a time; one that dies or hangs costs that
// run alone and is replaced.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs::sweep {

struct PoolOptions {
  int workers = 1;            ///< >= 1
  double time_limit_s = 600;  ///< a run that takes longer is ended by SIGKILL
};

/// Why a run did not report: "ended by signal 9 (Killed)" …
struct LostRun {
  int run = 0;
  std::string reason;
};

struct PoolEvents {
  /// In a worker: makes the run and keeps its result; an error there stops the whole pool.
  std::function<Status(int run, int worker)> work;
  /// In the caller: a run was made (lost = nullptr) or lost. An error stops the pool.
  std::function<Status(int run, const LostRun* lost)> done;
  /// Asked several times a second; false stops the pool.
  std::function<bool()> go_on;
};

/// Makes `runs`, in any order, each once. Returns true if all were made, false if go_on said stop.
/// The caller must have no threads (workers are forked). Workers die with the caller.
Result<bool> RunPool(const std::vector<int>& runs, const PoolOptions& options,
                     const PoolEvents& events);

}  // namespace phs::sweep
