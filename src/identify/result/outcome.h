// What a run of `phs identify` or `phs rig` hands back to the program.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace phs::identify {

struct RigOutcome {
  nlohmann::ordered_json result;  ///< what went into result.json
  std::string summary;            ///< some lines for the terminal
  std::string measured;           ///< data file on the clock of predicted.csv; empty: none measured
};

namespace search {

struct IdentifyOutcome {
  nlohmann::ordered_json result;  ///< what went into result.json
  std::string summary;            ///< about ten lines for the terminal
  bool cancelled = false;
};

}  // namespace search
}  // namespace phs::identify
