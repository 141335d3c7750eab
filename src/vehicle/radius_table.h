// Several bogies in several curves: what each does to wheels and rails beside its yardstick (the
// conventional bogie with the same axles).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "vehicle/run_summary.h"

namespace phs::vehicle {

/// One bogie in one curve.
struct RadiusRow {
  double radius_m = 0;
  int hand = 0;  ///< +1 the curve is left-hand, -1 right-hand, 0 there is none
  double speed_m_s = 0;
  std::string bogie;
  std::string yardstick;  ///< "" if the bogie names none
  RunSummary summary;
};

/// The scenario of a curve: track and speed of the product's scenario "curve_rRADIUS", everything
/// else (friction, profiles, creep, vehicle, failures …) of `base`. Error: no such scenario.
Result<Scenario> ScenarioOfRadius(const Scenario& base, int radius_m);

/// Every bogie in every scenario, two runs at a time; rows in that order. Results do not depend on
/// it. Stops after the run in hand when `progress` returns false.
Result<std::vector<RadiusRow>> RunRadii(const std::vector<Scenario>& curves,
                                        const std::vector<std::string>& bogies,
                                        const Progress& progress);

/// bogies.json: one entry per row with angle of attack, T-gamma, wear against the yardstick, sum Y,
/// Y/Q (docs/bogies.md).
nlohmann::ordered_json DescribeRadii(const std::vector<RadiusRow>& rows, const Scenario& base);

}  // namespace phs::vehicle
