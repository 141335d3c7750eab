// What the search for alarms has found, and how it is told.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/line_alarm.h"
#include "jobs/alarm_runs.h"
#include "jobs/alarms_request.h"

namespace phs::jobs {

/// One run to be made.
struct AlarmTask {
  size_t service = 0;
  vehicle::Scenario scenario;
  std::string line = {};  ///< hose that bursts
  double at_s = 0;
};

/// What a burst gives.
struct Burst {
  AlarmTask task;
  AlarmRun run;
  std::vector<double> seconds;  ///< [signal] to the alarm; infinite: none
  std::vector<double> settled;  ///< [signal] least from a second behind the burst on, turned
};

struct AlarmsFound {
  AlarmsRequest ask;
  std::vector<std::string> lines;
  std::vector<analysis::PairSignal> signals;
  std::vector<std::vector<std::vector<double>>> maxima;  ///< [service][signal] of blocks, turned
  std::vector<std::vector<analysis::Extremes>> laws;     ///< [service][signal]
  std::vector<double> thresholds;                        ///< [signal], turned
  double block_m = 0;                                    ///< length of a block
  double block_share = 0;  ///< probability that a block of one signal alarms falsely
  std::vector<Burst> bursts;
  std::vector<size_t> chosen;                 ///< [hose] signal
  std::vector<double> tested_km;              ///< [service]
  std::vector<std::vector<int>> false_count;  ///< [service][hose]

  std::vector<const Burst*> BurstsOf(const std::string& line) const;
  /// Seconds of the slowest alarm that `signal` gives of a hose, infinite where one lacks; `mean`
  /// counts that with the whole time waited.
  double Slowest(const std::string& line, size_t signal, double* mean) const;
  /// How far the signal stays beyond its threshold behind a burst, over how far the threshold lies
  /// beyond the median of blocks: the least of all bursts and services.
  double Margin(const std::string& line, size_t signal) const;
};

/// alarms.json.
nlohmann::ordered_json AlarmsJson(const AlarmsFound& found);
/// Every signal for every hose: threshold and seconds.
std::string SignalsCsv(const AlarmsFound& found);

}  // namespace phs::jobs
