// What one run of a study calculates: which analysis, of which scenario, with which keys set.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"
#include "vehicle/scenario.h"

namespace phs::sweep {

enum class Analysis {
  kSimulate,   ///< the run in time: summary.json
  kCurving,    ///< the steady state in the first arc, found directly: steady_curve, totals
  kStability,  ///< linear stability on straight track: critical_speed_m_s, stable_up_to_m_s
  kModes,      ///< stiffness and damping of the axle modes: modes.json
  kLoads       ///< the standard longitudinal loads: loads.json
};

struct StudyCase {
  std::string name = {};  ///< empty: the only one
  Analysis analysis = Analysis::kSimulate;
  std::string scenario = {};                                  ///< path
  std::vector<std::pair<std::string, std::string>> set = {};  ///< key of an axis (study.h), value
  std::vector<std::string> outputs = {};  ///< those of the study's that it has; empty = all
};

/// Reads the word at key "analysis"; a run in time without it.
Analysis ReadAnalysis(YamlMap* map);

/// What an engineer looks at first.
std::vector<std::string> DefaultOutputs(Analysis analysis);

struct Analysed {
  std::string status = "ok";  ///< ok | derailed | diverged
  std::string reason = {};
  nlohmann::ordered_json numbers = {};
};

/// Does it. Bad input, or no steady state, is an error.
Result<Analysed> Analyse(Analysis analysis, const vehicle::Scenario& scenario);

}  // namespace phs::sweep
