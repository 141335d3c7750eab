// How a long job is followed and stopped.
#pragma once

#include <functional>

namespace phs::jobs {

struct Watch {
  /// Called now and then with the share done (0 … 1), from the thread that asked for the job;
  /// false stops it.
  std::function<bool(double)> progress = {};
  /// True once the job shall stop; asked from any thread.
  std::function<bool()> stopped = {};

  bool GoesOn(double share) const { return !IsStopped() && (!progress || progress(share)); }
  bool IsStopped() const { return stopped && stopped(); }
};

}  // namespace phs::jobs
