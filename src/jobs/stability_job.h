// Stability of a bogie on straight track: `phs stability`, phs.stability in Python.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/hunting_map.h"
#include "analysis/limit_cycle.h"
#include "analysis/stability.h"
#include "base/result_dir.h"
#include "jobs/watch.h"
#include "vehicle/scenario.h"

namespace phs::jobs {

struct StabilityRequest {
  vehicle::Scenario scenario;  ///< bogie, vehicle, PHS, profiles, friction, track that gives gauge
  analysis::StabilityOptions scan;
  analysis::LimitCycleOptions cycle;
  bool ramp = false;  ///< limit cycle by speed ramps
  analysis::HuntingMapOptions balance;
  bool map = false;       ///< map of hunting by harmonic balance
  double timestep_s = 0;  ///< of the ramps; 0 = chosen
};

struct Stability {
  analysis::StabilityResult linear;
  std::optional<analysis::LimitCycle> cycle;
  std::vector<analysis::HuntingPoint> map;  ///< empty: not asked for
  analysis::LimitCycleOptions ramp;         ///< as it was run
  nlohmann::ordered_json json;              ///< stability.json
};

/// `watch` follows the scan, `watch_ramp` the ramps.
Result<Stability> AnalyseStability(const StabilityRequest& request, const Watch& watch,
                                   const Watch& watch_ramp);
/// stability.json and the report; not committed.
Status WriteStability(const Stability& stability, ResultDir* dir);

}  // namespace phs::jobs
