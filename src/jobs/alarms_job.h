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

#include <nlohmann/json.hpp>
#include <string>

#include "base/result_dir.h"
#include "jobs/alarms_request.h"
#include "jobs/watch.h"

namespace phs::jobs {

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
