// The standard load cases on a bogie: `phs loads`, phs.loads in Python.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/load_cases.h"
#include "base/result_dir.h"
#include "vehicle/scenario.h"
#include "vehicle/simulation.h"

namespace phs::jobs {

struct Loads {
  vehicle::Simulation simulation;
  std::vector<analysis::LoadResult> results;
  nlohmann::ordered_json json;  ///< loads.json
};

/// `scenario`: bogie, PHS, track that gives the gauge, step.
Result<Loads> CalcLoads(vehicle::Scenario scenario);
/// loads.json; not committed.
Status WriteLoads(const Loads& loads, ResultDir* dir);

}  // namespace phs::jobs
