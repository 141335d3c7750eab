// Axle modes of one or several bogies: `phs modes`, phs.modes in Python.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/axle_modes.h"
#include "base/result_dir.h"
#include "jobs/watch.h"
#include "vehicle/scenario.h"

namespace phs::jobs {

struct ModesRequest {
  vehicle::Scenario scenario;  ///< bogie, PHS, track that gives the gauge, step
  analysis::AxleModeOptions measure;
  std::vector<std::string> beside;  ///< further bogies, with their own PHS
};

struct MeasuredModes {
  std::string bogie;
  analysis::AxleModes modes;
};

Result<std::vector<MeasuredModes>> MeasureModes(const ModesRequest& request,
                                                const Watch& watch = {});
/// modes.json of one bogie.
nlohmann::ordered_json ModesJson(const MeasuredModes& measured, const ModesRequest& request);
/// modes.json, modes_1.json … and the report; not committed.
Status WriteModes(const std::vector<MeasuredModes>& all, const ModesRequest& request,
                  ResultDir* dir);

}  // namespace phs::jobs
