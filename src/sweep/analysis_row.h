// What is said of a kind of analysis: its word in a study, its outputs, how it is done.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"

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
  const char* of;    ///< key of its subject: "scenario", "rig"
  /// Paths among the numbers that an engineer looks at first.
  std::vector<std::string> outputs;
  /// Lists among the numbers: a column does without their names.
  std::vector<std::string> lists;
  /// The part whose numbers a run may lack although it ended well; "" = none.
  const char* may_lack;
  /// Does it, of a laid-out file. Bad input, or no steady state, is an error.
  Result<Analysed> (*run)(const std::string& file);
  /// The same numbers by name, sooner, for the outputs asked for: their values mean nothing. Null:
  /// `run` is quick enough.
  Result<Analysed> (*names)(const std::string& file, const std::vector<std::string>& outputs);
};

}  // namespace phs::sweep
