// The runs behind the alarm for a lost hose: a scenario on tracks that are each drawn anew from the
// spectrum of its track, without failure or with a hose that bursts.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/local_folder.h"
#include "base/result.h"
#include "jobs/watch.h"
#include "vehicle/scenario.h"

namespace phs::jobs {

/// What is kept of a run, rows at the scenario's recording interval.
struct AlarmRun {
  std::string status;
  std::vector<std::string> lines;
  double interval_s = 0;
  std::vector<double> time_s;
  std::vector<double> place_m;                   ///< never falls
  std::vector<std::vector<double>> pressure_Pa;  ///< [line][row], absolute
  /// Largest over wheels or wheelsets at each row, all behind 20 Hz: Y/Q and sum of Y as means over
  /// 2 m that end there, share of its own mean load that a wheel has lost. Empty unless asked for.
  std::vector<double> Y_over_Q, sum_Y_N, unloading;
};

/// Tracks like that of a scenario, each drawn anew. Not shared by threads while it draws.
class DrawnTracks {
 public:
  DrawnTracks() = default;
  /// Path of the track with its irregularity drawn from `seed`. The error says that a track has no
  /// spectrum.
  Result<std::string> Draw(const std::string& track, std::uint64_t seed);

 private:
  LocalFolder folder_;
  int drawn_ = 0;
};

/// Error: not exactly one PHS, or the vehicle cannot be made.
Result<AlarmRun> MakeAlarmRun(const vehicle::Scenario& scenario, bool safety, const Watch& watch);

/// Does task(0) … task(count - 1) on `workers` threads; the first error ends it, and a stop of the
/// watch. False: stopped. Progress goes from `from` to `to`.
Result<bool> DoAll(int count, int workers, double from, double to, const Watch& watch,
                   const std::function<Status(int)>& task);

}  // namespace phs::jobs
