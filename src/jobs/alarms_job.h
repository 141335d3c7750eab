// The alarm for lost hoses: which pair of pressures, which threshold, how soon, how many false
// alarms: `phs alarms`.
//
// 1. Learn: runs without failure of every service give the block maxima of every signal
//    (analysis/line_alarm.h). Each hose has one signal, so a signal may alarm falsely at the wanted
//    rate over the number of hoses; its threshold is the level for that, at the upper end of its
//    one-sided 95 % interval, and the largest of all services.
// 2. Burst: every hose tears in every service at places spread over the track. Of the signals that
//    alarm within a second in all of them (else the soonest) a hose is watched by that with the
//    widest margin: how far beyond the threshold the signal stays, over how far the threshold lies
//    beyond a usual block.
// 3. Test: other tracks without failure; alarms are counted. The bound is Poisson's, 95 %.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result_dir.h"
#include "jobs/watch.h"
#include "vehicle/scenario.h"

namespace phs::jobs {

struct AlarmsRequest {
  std::vector<vehicle::Scenario> services;
  double learn_km = 40;             ///< in each service
  double test_km = 200;             ///< in all services together
  int bursts = 5;                   ///< of each hose in each service
  double wanted_per_1000_km = 0.1;  ///< false alarms, all hoses together
  double lag_s = 0.3;               ///< behind every signal
  double block_m = 500;             ///< a block of track
  double run_in_s = 10;             ///< at the start of a run nothing is looked at
  double after_s = 8;               ///< so long after a burst an alarm is waited for
  double hold_s = 5;                ///< an alarm that comes again within is the same
  std::uint64_t seed = 1;
  int workers = 1;  ///< threads
};

struct Alarms {
  bool all = false;             ///< false: stopped
  nlohmann::ordered_json json;  ///< alarms.json
  std::string signals_csv;      ///< every signal with its threshold and seconds for every hose
};

/// Errors: no service, services with different lines, a track without a spectrum, a run without
/// failure that does not end well, fewer than three blocks to learn from.
Result<Alarms> FindAlarms(const AlarmsRequest& request, const Watch& watch);
/// alarms.json, signals.csv, report.html; not committed.
Status WriteAlarms(const Alarms& alarms, ResultDir* dir);

}  // namespace phs::jobs
