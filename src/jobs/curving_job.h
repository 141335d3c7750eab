// Steady state in curves of many radii: `phs curving`, phs.curving in Python.
#pragma once

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result_dir.h"
#include "jobs/watch.h"
#include "vehicle/scenario.h"

namespace phs::jobs {

struct CurvingRequest {
  vehicle::Scenario scenario;  ///< vehicle, friction, step
  std::string track;           ///< gives gauge and friction, without radii its own arc
  std::vector<std::string> bogies;
  std::vector<double> radii;  ///< [m]; empty: the track's arc, or 150 … 1500
  double speed_limit_km_h = 80;
  double largest_cant_m = -1;  ///< < 0: the family's
  double deficiency_m = std::numeric_limits<double>::quiet_NaN();
  bool time_run = false;  ///< each curve run in time too
};

/// What the caller hears as it goes: a bogie begins, a row is done.
struct CurvingTeller {
  std::function<void(const std::string& bogie)> begin = {};
  std::function<void(const nlohmann::ordered_json& row)> row = {};
};

/// curving.json: {"bogies": {BOGIE: [row per radius]}}. A radius without a steady state is a row
/// of status "no_steady_state". Stopped: an error.
Result<nlohmann::ordered_json> SolveCurves(const CurvingRequest& request, const Watch& watch,
                                           const CurvingTeller& tell = {});
/// curving.json and the report; not committed.
Status WriteCurves(const nlohmann::ordered_json& curves, ResultDir* dir);

}  // namespace phs::jobs
