// What the search for alarms is asked (jobs/alarms_job.h).
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/line_alarm.h"
#include "vehicle/scenario.h"

namespace phs::jobs {

struct AlarmsRequest {
  std::vector<vehicle::Scenario> services;
  double learn_km = 100;            ///< in each service
  double test_km = 200;             ///< in all services together
  int bursts = 5;                   ///< of each hose in each service
  double wanted_per_1000_km = 0.1;  ///< false alarms, all hoses together
  analysis::SignalTimes times;
  double block_m = 0;    ///< a block of track; 0: a run over the whole line
  double run_in_s = 10;  ///< at the start of a run nothing is looked at
  double after_s = 8;    ///< so long after a burst an alarm is waited for
  double hold_s = 5;     ///< an alarm that comes again within is the same
  std::uint64_t seed = 1;
  int workers = 1;  ///< threads
};

}  // namespace phs::jobs
