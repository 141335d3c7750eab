#include "cli/run_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "base/numbers.h"
#include "base/words.h"
#include "cli/number_within.h"

namespace phs::cli {

CLI::Option* AddTrackOption(CLI::App* verb, std::string* track, const std::string& what) {
  return verb->add_option("--track", *track, what);
}

void AddTimestepOption(CLI::App* verb, double* timestep_s, const std::string& what) {
  verb->add_option("--timestep", *timestep_s,
                   what + " in seconds, instead of the scenario's or the bogie file's")
      ->check(NumberWithin(1e-6, 0.05));  // what the model stands is judged with it
}

void AddFrictionOption(CLI::App* verb, rail::FrictionSettings* friction) {
  const std::vector<std::string> conditions = rail::FrictionConditionNames();
  verb->add_option_function<std::string>(
      "--friction",
      [=](const std::string& text) {
        *friction = {};
        if (const auto number = ParseNumber(text); number && *number >= 0.01 && *number <= 1) {
          friction->tread = *number;
          return;
        }
        if (std::find(conditions.begin(), conditions.end(), text) == conditions.end()) {
          const std::string near = DidYouMean(text, conditions);
          throw CLI::ValidationError("--friction", Quoted(text) +
                                                       " is neither a coefficient 0.01 … "
                                                       "1 nor one of " +
                                                       JoinWords(conditions) +
                                                       (near.empty() ? "" : "; " + near));
        }
        friction->condition = text;
      },
      "Wheel on rail: a coefficient, or " + JoinWords(conditions));
}

}  // namespace phs::cli
