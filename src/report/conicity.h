// The equivalent conicity of a run's wheels and rails: curve over the amplitude, table, what pair it
// is of, and by which formula.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/report_page.h"

namespace phs::report {

/// `conicity` of one bogie's results (analysis/pair_conicity.h); null if they have none.
struct ConicityOf {
  std::string label;  ///< of the bogie
  int colour = 0;
  nlohmann::ordered_json conicity;
};

/// One for each of `bogies`, which are keys of the object `conicity` ({bogie: …}).
std::vector<ConicityOf> ConicityOfBogies(const nlohmann::ordered_json& conicity,
                                         const std::vector<std::string>& bogies);

/// The section "Conicity". Bogies with the same curve share one; one without is named with the
/// reason.
void AddConicity(const std::vector<ConicityOf>& bogies, ReportPage* page);

}  // namespace phs::report
