// The report of alarms.json: how a lost hose is noticed, how soon, how often falsely.
#pragma once

#include <string>

#include "base/result.h"

namespace phs::report {

/// Table of hoses, pressures around a burst with the signal and its threshold, what the threshold
/// was learned from, false alarms with their bound, running safety until the alarm.
Status WriteAlarmsReport(const std::string& alarms_file, const std::string& path);

}  // namespace phs::report
