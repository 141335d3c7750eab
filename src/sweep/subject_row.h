// What is said of a kind of file that a study varies: a bogie's scenario, a rig's manifest.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::sweep {

struct Study;

struct Subject {
  const char* key;     ///< in a study, and of the axes that vary it: "scenario"
  const char* file;    ///< of a laid-out run: "scenario.yaml"
  const char* verb;    ///< that repeats it: "simulate"
  const char* result;  ///< whose numbers are the outputs: "summary.json"
  /// Keys of axes: each begins with one of these; the word behind it is for messages.
  std::vector<std::pair<std::string, std::string>> axes;
  /// Axes whose words decide which numbers a run has.
  std::vector<std::string> kinds;
  /// A name that ships as a path.
  Result<std::string> (*find)(const std::string& name);
  /// Writes the files of a run into a folder, which exists; its path. Errors name the axis.
  Result<std::string> (*lay_out)(const Study& study, int run, const std::string& folder);
  /// A laid-out file can be read.
  Status (*check)(const std::string& file);
  /// Input files that the file at `path` names in a way of its own.
  std::vector<std::string> (*inputs)(const std::string& path);
};

}  // namespace phs::sweep
