// What one run of a study can calculate: the word after `analysis:`, a row each.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"
#include "vehicle/scenario.h"

namespace phs::sweep {

/// Numbers of one run.
struct Analysed {
  std::string status = "ok";  ///< ok | derailed | diverged
  std::string reason = {};
  nlohmann::ordered_json numbers = {};
};

struct Analysis {
  const char* name;
  const char* text;  ///< one line of docs/sweep_optimise.md
  /// Paths among the numbers that an engineer looks at first.
  std::vector<std::string> outputs;
  /// Lists among the numbers: a column does without their names.
  std::vector<std::string> lists;
  /// The part whose numbers a run may lack although it ended well; "" = none.
  const char* may_lack;
  /// Does it. Bad input, or no steady state, is an error.
  Result<Analysed> (*run)(const vehicle::Scenario& scenario);
  /// The same numbers by name, sooner, for the outputs asked for: their values mean nothing. Null:
  /// `run` is quick enough.
  Result<Analysed> (*names)(const vehicle::Scenario& scenario,
                            const std::vector<std::string>& outputs);
};

/// All of them; the first is meant where a study says nothing.
std::span<const Analysis> Analyses();

/// Reads the word at key "analysis".
const Analysis* ReadAnalysis(YamlMap* map);

/// True for a path below the part of an analysis that may be lacking.
bool MayLack(const Analysis& analysis, const std::string& path);

}  // namespace phs::sweep
