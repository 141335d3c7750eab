// Limits that a result must keep, for continuous integration: which one is missed and by how much.
//
//   limits:
//     - {quantity: run.max_Y_over_Q, at_most: 0.8}                     # every bogie
//     - {quantity: steady_curve.wheels.lead_outer.Y_N, bogie: phs, at_most: 10e3}
//     - {quantity: verdict, is: [sufficient, explained]}                # a word of a result
//     - {quantity: ratios.phs_over_rigid_link.run.T_gamma_total_J, at_most: 0.2}
//
// A quantity is the path of a number in summary.json (of each bogie in compare.json): keys joined
// by dots, entries of lists by their `name`. Its unit is in its key.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace phs::analysis {

struct Limit {
  std::string quantity = {};
  std::string bogie = {};  ///< empty: every bogie
  double at_most = std::numeric_limits<double>::infinity();
  double at_least = -std::numeric_limits<double>::infinity();
  bool of_magnitude = false;            ///< the bounds hold for the magnitude
  std::vector<std::string> words = {};  ///< not empty: the quantity is a word, one of these
  std::string where = {};               ///< file:line: key, for messages
};

/// Errors name file:line and key.
Result<std::vector<Limit>> LoadLimits(const std::string& path);

/// One limit held against one number.
struct LimitCheck {
  std::string bogie;  ///< empty for a ratio
  std::string quantity = {};
  std::string claim;   ///< "at most 0.8"
  double value = 0;    ///< NaN: the run did not get far enough to have it
  double excess = 0;   ///< how far beyond the bound, in the quantity's unit; <= 0: kept
  std::string reason;  ///< of a run that did not end well: takes the place of a number

  bool Passed() const;
  /// "phs: run.max_Y_over_Q is 0.91, at most 0.8 allowed: 0.11 too much".
  std::string Text() const;
};

using NamedSummary = std::pair<std::string, nlohmann::ordered_json>;

/// Every limit for every bogie it is for; first of all that each run ended well. `ratios` as in
/// compare.json, null for one bogie. A quantity that nothing has is an error that names the
/// nearest.
Result<std::vector<LimitCheck>> CheckLimits(const std::vector<Limit>& limits,
                                            const std::vector<NamedSummary>& summaries,
                                            const nlohmann::ordered_json& ratios);

/// JUnit XML, one test case per check.
std::string JUnitXml(const std::string& suite, const std::vector<LimitCheck>& checks);

}  // namespace phs::analysis
